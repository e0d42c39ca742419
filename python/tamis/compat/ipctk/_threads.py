"""The number of threads by ipctk's names."""

from __future__ import annotations

import os

from tamis._checks import whole

_ALL = os.cpu_count() or 1
_most = _ALL


def set_num_threads(nthreads: int) -> None:
    """Set how many threads each question uses from now on, of every mesh; 0, or more than there are: all."""
    global _most
    _most = min(whole(nthreads, "nthreads") or _ALL, _ALL)


def get_num_threads() -> int:
    """Return how many threads a question uses at most."""
    return _most
