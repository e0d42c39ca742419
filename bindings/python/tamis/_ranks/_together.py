"""A communicator of a detector's own, duplicated and freed; and errors of one rank, which all ranks raise."""

from __future__ import annotations

import uuid
import weakref
from collections import Counter
from collections.abc import Callable, Iterable
from typing import TypeVar

from mpi4py import MPI

from tamis import _errors
from tamis._checks import instance
from tamis._errors import Error

_Result = TypeVar("_Result")
_Name = tuple[bytes, int]  # of a communicator: bytes that are the same on its ranks alone, and the number of these

# Communicators that this rank no longer uses. They are not freed at once. Freeing is collective, but Python collects
# garbage at another time on each rank; and it may do so while mpi4py holds the lock that freeing takes.
_left: dict[_Name, MPI.Intracomm] = {}


class Ranks:
    """A duplicate of a communicator: its messages never mix with other messages. All calls are collective.

    Making one frees the duplicates that all of their ranks have dropped.
    """

    __slots__ = ("__weakref__", "comm")

    def __init__(self, comm: MPI.Intracomm) -> None:
        self.comm = instance(comm, MPI.Intracomm, "comm", "a communicator of mpi4py, such as MPI.COMM_WORLD").Dup()
        said = self.comm.allgather((uuid.uuid4().bytes, list(_left)))
        weakref.finalize(self, _left.__setitem__, (said[0][0], self.comm.size), self.comm)
        _free(name for _, names in said for name in names)

    def together(self, work: Callable[[], _Result]) -> _Result:
        """Return the result of `work`, which each rank does alone. If it fails on any, all raise the lowest's error."""
        result, failure = _outcome_of(work)
        first = self.comm.allreduce(self.comm.size if failure is None else self.comm.rank, op=MPI.MIN)
        if first == self.comm.size:
            return result  # type: ignore[return-value]
        kind, sentence = self.comm.bcast(None if failure is None else _report_of(failure), root=first)
        raise getattr(_errors, kind)(f"rank {first}: {sentence}") from failure


def _free(left: Iterable[_Name]) -> None:
    """Free the communicators that all of their ranks have named, in the same order on each rank."""
    counts = Counter(left)
    for name in sorted(counts):
        comm = _left.pop(name, None) if counts[name] == name[1] else None
        if comm is not None:
            comm.Free()


def _outcome_of(work: Callable[[], _Result]) -> tuple[_Result | None, Exception | None]:
    try:
        return work(), None
    except Exception as failure:
        return None, failure


def _report_of(failure: Exception) -> tuple[str, str]:
    """Return the name of the class of `tamis` to raise, and the sentence."""
    if isinstance(failure, Error):
        return type(failure).__name__, str(failure)
    said, raised_again = _outcome_of(lambda: str(failure))
    return Error.__name__, f"{type(failure).__name__}: {'its text raises an exception, too' if raised_again else said}"
