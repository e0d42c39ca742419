"""Measures the time that Python adds to a question: overhead.py FRAMES [--list-call FILE].

Compares, in one warm process, the time of a call in Python with the library's own time of it (`statistics`). With FILE,
which the preset bench builds from list_call.cpp, also times a million single pairs, by `narrow_phase` and by the C++
call for lists of pairs, in turns.
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
    """Return the seconds of one call."""
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def compare_steps(frames: pathlib.Path, threads: int, repeat: int) -> None:
    """Time all contacts of recorded cloth."""
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
    """Time `count` vertices against as many faces. Each module has a copy of the library."""
    call = ctypes.CDLL(str(path)).tamis_list_call
    call.restype, call.argtypes = ctypes.c_double, (ctypes.c_size_t, ctypes.c_void_p, ctypes.c_void_p)
    start, end = np.random.default_rng(1).uniform(-1, 1, (2, 4 * count, 3))
    given = count, start.ctypes.data, end.ctypes.data
    vertices = np.arange(4 * count, dtype=np.int32).reshape(-1, 4)

    def ask() -> tamis.Pairs:
        return tamis.narrow_phase(tamis.PairKind.VERTEX_FACE, vertices, start, end)

    call(*given)
    times = np.array([[call(*given), seconds(ask)] for _ in range(repeat)])
    cpp, python = np.median(times, axis=0)
    ratio = np.median(times[:, 1] / times[:, 0])
    print(f"{count:,} pairs: C++ {1000 * cpp:.0f} ms, NumPy {1000 * python:.0f} ms, ratio {ratio:.3f}")


def main() -> None:
    """Ask, and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("frames", type=pathlib.Path, help="the folder that holds cloth-ball and cloth-funnel")
    parser.add_argument("--list-call", type=pathlib.Path, help="libtamis_list_call.so")
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--repeat", type=int, default=40)
    arguments = parser.parse_args()
    compare_steps(arguments.frames, arguments.threads, arguments.repeat)
    if arguments.list_call:
        compare_pairs(arguments.list_call, max(3, arguments.repeat // 8))


if __name__ == "__main__":
    main()
