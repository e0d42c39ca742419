"""Checks a sequence of frames on all cores: sequence.py FRAMES... [--out PICTURE].

FRAMES are files, folders or patterns. Steps are independent, so each thread has a detector of its own: Tamis releases
the interpreter's lock during a question. Without frames it takes a generated scene, cut into eight steps.
"""

from __future__ import annotations

import argparse
import os
import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor

import numpy as np

import tamis

try:
    import matplotlib.pyplot as plt
except ModuleNotFoundError as missing:
    raise SystemExit(f"{missing}: pip install matplotlib") from None


def frames_of(names: list[str]) -> tuple[tamis.Mesh, list[np.ndarray]]:
    """Return the topology, and the positions of each frame."""
    if names:
        frames = list(tamis.read_frames(*names))
        return frames[0].mesh, [frame.positions for frame in frames]
    mesh, start, end, _ = tamis.scene("colliding-bodies", 5000)
    return mesh, [start + t * (end - start) for t in np.linspace(0, 1, 9)]


def answers(mesh: tamis.Mesh, frames: list[np.ndarray]) -> Iterator[tuple[tamis.Contacts, tamis.EarliestContact]]:
    """Yield all contacts and the first contact of each step, in the order of the steps."""
    local = threading.local()

    def ask(step: tuple[np.ndarray, np.ndarray]) -> tuple[tamis.Contacts, tamis.EarliestContact]:
        if not hasattr(local, "detector"):
            local.detector = tamis.Detector(mesh, threads=1)
        return local.detector.contacts(*step), local.detector.earliest(*step)

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        yield from pool.map(ask, zip(frames, frames[1:]))


def main() -> None:
    """Ask, print, and draw."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("frames", nargs="*")
    parser.add_argument("--out", default="sequence.png")
    arguments = parser.parse_args()
    mesh, frames = frames_of(arguments.frames)
    print(f"{mesh}, {len(frames) - 1} steps\n step   vertex-face   edge-edge   free until")
    counts, free = [], []
    for step, (contacts, first) in enumerate(answers(mesh, frames), 1):
        counts.append(np.bincount(contacts.kind, minlength=2)[:2])
        free.append(first.toi_lower)
        print(f"{step:5} {counts[-1][0]:13,} {counts[-1][1]:11,} {free[-1]:12.6f}")

    figure, (above, below) = plt.subplots(2, sharex=True, layout="constrained")
    steps = np.arange(1, len(counts) + 1)
    above.bar(steps, [c[0] for c in counts], label="vertex-face", color="#4d7fb3")
    above.bar(steps, [c[1] for c in counts], bottom=[c[0] for c in counts], label="edge-edge", color="#d98032")
    above.set_ylabel("contacts")
    above.legend()
    below.step(steps, free, where="mid", color="#333333")
    below.set(xlabel="step", ylabel="free until", ylim=(0, 1.05))
    figure.savefig(arguments.out, dpi=150)


if __name__ == "__main__":
    main()
