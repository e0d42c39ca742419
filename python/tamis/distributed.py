"""The questions of `tamis.Detector`, asked by all ranks of an MPI communicator about one mesh that is in parts.

>>> from mpi4py import MPI
>>> from tamis import distributed
>>> detector = distributed.Detector(MPI.COMM_WORLD, faces, vertices)
>>> contacts = detector.contacts(start, end)

Needs mpi4py, and a build that knows MPI: ``pip install . -C cmake.define.TAMIS_PYTHON_MPI=ON`` in a clone. Scripts run
as ``mpirun -n 4 python -m mpi4py script.py``, so that one that ends with an exception ends all.
"""

from __future__ import annotations

import threading
import weakref
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, TypeVar

import numpy as np
import numpy.typing as npt
from mpi4py import MPI

from tamis import _errors
from tamis._answers import EarliestContact, SafeStep, safe_step_of
from tamis._arrays import Doubles, indices, indices_or_none, rows
from tamis._checks import instance, number, whole
from tamis._distributed_statistics import Balance, Statistics
from tamis._errors import Busy, Error, InvalidMesh, InvalidOptions
from tamis._options import AtStart, Filter, Isa, make_options, query_options
from tamis._tables._contacts import Contacts

try:
    from tamis import _distributed
except ImportError as reason:
    raise ImportError(
        f"this build of tamis knows no MPI ({reason}): pip install . -C cmake.define.TAMIS_PYTHON_MPI=ON in a clone"
    ) from reason

__all__ = ["Balance", "Detector", "Statistics"]

_Result = TypeVar("_Result")

# Communicators of detectors that are gone, freed when the next one is made: not at once, since memory may be collected
# while mpi4py holds the lock that freeing takes.
_left: list[MPI.Intracomm] = []


def _require_one_mpi() -> None:
    """Handles of one library mean nothing to another."""
    ours, theirs = (said.rstrip("\0 \n") for said in (_distributed.library_version(), MPI.Get_library_version()))
    if ours != theirs:
        raise ImportError(f"tamis was built for '{ours}', mpi4py uses '{theirs}': let both use the same MPI")


_require_one_mpi()


class Detector:
    """A `tamis.Detector` over all ranks of a communicator, each of which has a part of the mesh.

    Construction and every question are collective: all ranks call them, in the same order and with the same options,
    but for `threads`, `isa`, `filter` and `is_cancelled`. Vertices have the numbers of the whole mesh everywhere, in
    faces, filters and answers. The answers are bit for bit those of one `tamis.Detector` with the whole mesh, whatever
    rank has what.

    What one rank raises is raised on all, as the same `tamis.Error` with a sentence that begins with the rank; the next
    question may be asked. The exception is an interrupt: Ctrl-C, or what `is_cancelled` raises, stays itself on its
    rank, the others raise `Cancelled`.

    Parameters
    ----------
    comm : mpi4py.MPI.Intracomm
        Who asks. Duplicated, so that messages never meet.
    faces : array_like of int, shape (f, 3)
        This rank's triangles, each on one rank; may be empty.
    vertices : array_like of int, shape (n,)
        The number of each row of positions that this rank gives. A vertex on a border may be given by several ranks,
        always with the same position; one that features here use may be given elsewhere alone.
    edges : array_like of int, shape (e, 2), optional
        This rank's loose edges: rods.
    points : array_like of int, shape (p,), optional
        This rank's loose points.
    threads : int
        Of this rank; 0: all cores. With a rank a core: 1.
    groups : array_like of int, shape (n,), optional
        The object of each row's vertex.
    filter : callable, optional
        As of `tamis.Detector`; asked on any rank, so what it says of a pair may not depend on the rank.
    min_separation, isa, may_touch, radii, is_cancelled
        As of `tamis.Detector`.

    Raises
    ------
    InvalidMesh
        A negative number, a vertex that is given twice by one rank, or one that is used and given by none.
    InvalidOptions
        As of `tamis.Detector`, and where ranks say different things.
    """

    __slots__ = ("__weakref__", "_comm", "_description", "_detector", "_lock")

    def __init__(
        self,
        comm: MPI.Intracomm,
        faces: npt.ArrayLike,
        vertices: npt.ArrayLike,
        *,
        edges: npt.ArrayLike | None = None,
        points: npt.ArrayLike | None = None,
        threads: int = 0,
        min_separation: float = 0.0,
        isa: Isa = "best",
        groups: npt.ArrayLike | None = None,
        may_touch: npt.ArrayLike | None = None,
        radii: npt.ArrayLike | None = None,
        filter: Filter | None = None,
        is_cancelled: Callable[[], bool] | None = None,
    ) -> None:
        self._lock = threading.Lock()
        _free_left()
        self._comm = instance(comm, MPI.Intracomm, "comm", "a communicator of mpi4py, such as MPI.COMM_WORLD").Dup()
        weakref.finalize(self, _left.append, self._comm)
        part = self._together(
            lambda: _distributed.Part(
                indices(vertices, 0, "vertices", InvalidMesh),
                indices(faces, 3, "faces", InvalidMesh),
                indices_or_none(edges, 2, "edges", InvalidMesh),
                indices_or_none(points, 0, "points", InvalidMesh),
            )
        )
        # No rank need have a vertex of each group.
        group_count = self._comm.allreduce(self._together(lambda: _group_count(groups)), op=MPI.MAX)
        options = self._together(
            lambda: make_options(
                threads=threads,
                min_separation=min_separation,
                isa=isa,
                groups=groups,
                may_touch=may_touch,
                radii=radii,
                filter=filter,
                is_cancelled=is_cancelled,
                group_count=group_count,
            )
        )
        self._detector = _distributed.Detector(self._comm.py2f(), part, options)
        self._description = f"min_separation={min_separation:g}"

    @property
    def vertex_count(self) -> int:
        """Largest number of a vertex that is used, of all ranks, plus 1."""
        return self._detector.vertex_count()

    @property
    def statistics(self) -> Statistics:
        """What the last question cost this rank."""
        return Statistics(**self._detector.statistics())

    @property
    def balance(self) -> Balance:
        """How evenly the last question's work was shared; the same on every rank."""
        return Balance(*self._detector.balance())

    def contacts(
        self,
        start: npt.ArrayLike,
        end: npt.ArrayLike,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
    ) -> Contacts:
        """Find every contact of a step, each on one rank.

        Parameters
        ----------
        start, end : array_like, shape (n, 3)
            Where this rank's `vertices` are at the start and at the end of the step.
        min_separation : float, optional
            Of this question alone; by default the detector's.
        at_start : str
            As of `tamis.Detector.contacts`: "report" or "ignore".

        Returns
        -------
        Contacts
            Those whose first vertex this rank gives (of several ranks, the lowest), by kind, then vertices.

        Raises
        ------
        InvalidStep
            Positions that do not fit the vertices, are not finite, or differ between ranks.
        """
        with self._turn():
            first, second, own = self._together(lambda: (*_step(start, end), query_options(min_separation, at_start)))
            return Contacts(self._detector.contacts(first, second, own))

    def gather_contacts(self, root: int = 0) -> Contacts:
        """Bring the contacts of the last such question to one rank. Collective.

        Parameters
        ----------
        root : int
            The rank that gets them.

        Returns
        -------
        Contacts
            Of all ranks, in the order of `tamis.Detector`; none on the other ranks.

        Raises
        ------
        InvalidOptions
            There is no such rank.
        """
        with self._turn():
            rank = self._together(lambda: whole(root, "root"))
            return Contacts(self._detector.gather_contacts(rank))

    def earliest(
        self,
        start: npt.ArrayLike,
        end: npt.ArrayLike,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
    ) -> EarliestContact:
        """Find the first contact: how far the step may go. The same on every rank.

        Parameters
        ----------
        start, end, min_separation, at_start
            As of `contacts`.

        Returns
        -------
        EarliestContact
            The motion is free before its `toi_lower`: proven.
        """
        with self._turn():
            first, second, own = self._together(lambda: (*_step(start, end), query_options(min_separation, at_start)))
            lower, upper, found = self._detector.earliest(first, second, own)
        contacts = Contacts(found)
        return EarliestContact(lower, upper, contacts[0] if len(contacts) else None)

    def is_free(
        self,
        start: npt.ArrayLike,
        end: npt.ArrayLike,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
    ) -> bool:
        """Tell whether the whole step is free of contacts. The same on every rank.

        Parameters
        ----------
        start, end, min_separation, at_start
            As of `contacts`.

        Returns
        -------
        bool
            True is a proof.
        """
        with self._turn():
            first, second, own = self._together(lambda: (*_step(start, end), query_options(min_separation, at_start)))
            return self._detector.is_free(first, second, own)

    def safe_step(
        self,
        start: npt.ArrayLike,
        end: npt.ArrayLike,
        keep: float = 0.1,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
    ) -> SafeStep:
        """Find how far the step may go so that every pair keeps a fraction of its distance. The same on every rank.

        Parameters
        ----------
        start, end, min_separation, at_start
            As of `contacts`.
        keep : float
            0 <= keep < 1; which, `tamis.Detector.safe_step` says. 0: only contacts count.

        Returns
        -------
        SafeStep
            On [0, lower] every pair keeps the fraction: proven.

        Raises
        ------
        InvalidOptions
            The fraction is outside its range.
        """
        with self._turn():
            first, second, kept, own = self._together(
                lambda: (*_step(start, end), number(keep, "keep"), query_options(min_separation, at_start))
            )
            return safe_step_of(self._detector.safe_step(first, second, kept, own))

    @contextmanager
    def _turn(self) -> Iterator[None]:
        if not self._lock.acquire(blocking=False):
            raise Busy("the detector is answering another question: ask one after the other, on all ranks alike")
        try:
            yield
        finally:
            self._lock.release()

    def _together(self, work: Callable[[], _Result]) -> _Result:
        """Collective: what this rank does alone; where any has failed, all raise what the lowest did."""
        result, failure = _outcome_of(work)
        first = self._comm.allreduce(self._comm.size if failure is None else self._comm.rank, op=MPI.MIN)
        if first == self._comm.size:
            return result  # type: ignore[return-value]
        kind, sentence = self._comm.bcast(None if failure is None else _report_of(failure), root=first)
        raise getattr(_errors, kind)(f"rank {first}: {sentence}") from failure

    def __repr__(self) -> str:
        return f"Detector(rank {self._comm.rank} of {self._comm.size}, {self._description})"

    def __reduce__(self) -> Any:
        raise TypeError("a Detector cannot be pickled: every rank makes its own, all together")


def _free_left() -> None:
    while _left:
        _left.pop().Free()


def _outcome_of(work: Callable[[], _Result]) -> tuple[_Result | None, Exception | None]:
    try:
        return work(), None
    except Exception as failure:
        return None, failure


def _report_of(failure: Exception) -> tuple[str, str]:
    """Return the name of the class to raise, one of `tamis`, and the sentence."""
    if isinstance(failure, Error):
        return type(failure).__name__, str(failure)
    return Error.__name__, f"{type(failure).__name__}: {failure}"


def _step(start: npt.ArrayLike, end: npt.ArrayLike) -> tuple[Doubles, Doubles]:
    return rows(start, "start"), rows(end, "end")


def _group_count(groups: npt.ArrayLike | None) -> int:
    return 1 + int(np.max(indices_or_none(groups, 0, "groups", InvalidOptions), initial=-1))
