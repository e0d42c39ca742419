"""What Python adds to a question: overhead.py FRAMES [--c-library FILE].

In one process, warm: the time of the call as Python sees it, and the library's own time of the same call, which
`statistics` gives. With the library of the C interface also a million single pairs, through NumPy and through C, in
turns.
"""

from __future__ import annotations

import argparse
import ctypes
import pathlib
import statistics
import time
from collections.abc import Callable
from typing import Any

import numpy as np

import tamis


def seconds(work: Callable[[], Any]) -> float:
    """Return how long one call takes."""
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def compare_steps(frames: pathlib.Path, threads: int, repeat: int) -> None:
    """All contacts of recorded cloth."""
    for scene in ("cloth-funnel", "cloth-ball"):
        first, last = tamis.read_frames(frames / scene)
        detector = tamis.Detector(first.mesh, threads=threads)
        calls, inside = [], []
        for _ in range(repeat):
            begin = time.perf_counter()
            contacts = detector.contacts(first.positions, last.positions)
            calls.append(time.perf_counter() - begin)
            inside.append(detector.statistics.seconds["total"])
        added = statistics.median(call - library for call, library in zip(calls, inside))
        library = statistics.median(inside)
        print(
            f"{scene}: {len(contacts):,} contacts, library {1000 * library:.2f} ms, Python adds {1e6 * added:.0f} us "
            f"= {added / library:.2%}"
        )


def compare_pairs(path: pathlib.Path, repeat: int, count: int = 1_000_000) -> None:
    """A million vertices against as many faces."""
    library, handle = ctypes.CDLL(str(path)), ctypes.c_void_p()
    library.tamis_pairs_create(None, ctypes.byref(handle))
    start, end = np.random.default_rng(1).uniform(-1, 1, (2, count, 4, 3))
    pointer = ctypes.POINTER(ctypes.c_double)

    def through_c() -> None:
        results = np.empty((count, 8))  # 64 bytes each
        arguments = (ctypes.c_size_t(count), start.ctypes.data_as(pointer), end.ctypes.data_as(pointer))
        library.tamis_vertex_face(handle, *arguments, ctypes.c_void_p(results.ctypes.data), ctypes.c_size_t(64))

    def through_numpy() -> None:
        tamis.vertex_face(start, end)

    through_c()
    times = np.array([[seconds(through_c), seconds(through_numpy)] for _ in range(repeat)])
    c, python = np.median(times, axis=0)
    ratio = np.median(times[:, 1] / times[:, 0])
    print(f"{count:,} pairs: C {1000 * c:.0f} ms, NumPy {1000 * python:.0f} ms, ratio {ratio:.3f}")


def main() -> None:
    """Ask, and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("frames", type=pathlib.Path, help="the folder that holds cloth-ball and cloth-funnel")
    parser.add_argument("--c-library", type=pathlib.Path, help="libtamis_c.so of the same build")
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--repeat", type=int, default=40)
    arguments = parser.parse_args()
    compare_steps(arguments.frames, arguments.threads, arguments.repeat)
    if arguments.c_library:
        compare_pairs(arguments.c_library, max(3, arguments.repeat // 8))


if __name__ == "__main__":
    main()
