"""The number of threads, with ipctk's names."""

from __future__ import annotations

import os

from tamis._checks import whole

_ALL = os.cpu_count() or 1
_most = _ALL


def set_num_threads(nthreads: int) -> None:
    """Set the number of threads of all questions from now on; 0, or more than there are cores: one a core."""
    global _most
    _most = min(whole(nthreads, "nthreads") or _ALL, _ALL)


def get_num_threads() -> int:
    """Return the largest number of threads that a question uses."""
    return _most
