"""What Python adds to a question: overhead.py FRAMES.

In one process, warm: the time of the call as Python sees it, and the library's own time of the same call, which
`statistics` gives. Rounds alternate between new results and results that are let go at once.
"""

from __future__ import annotations

import argparse
import pathlib
import statistics
import time

import tamis


def main() -> None:
    """Ask, and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("frames", type=pathlib.Path, help="the folder that holds cloth-ball and cloth-funnel")
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--repeat", type=int, default=60)
    arguments = parser.parse_args()
    for scene in ("cloth-funnel", "cloth-ball"):
        first, last = tamis.read_frames(arguments.frames / scene)
        detector = tamis.Detector(first.mesh, threads=arguments.threads)
        calls, inside = [], []
        for _ in range(arguments.repeat):
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


if __name__ == "__main__":
    main()
