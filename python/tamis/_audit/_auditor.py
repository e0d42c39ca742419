"""Audits of a motion that is still going on."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy.typing as npt

from tamis import _core
from tamis._arrays import rows
from tamis._audit._options import make_audit_options
from tamis._audit._report import AuditReport
from tamis._audit._shared import Objects, shared_mesh
from tamis._audit._tables import AuditFrame, AuditFrames, AuditPairs, ObjectNames
from tamis._checks import word
from tamis._mesh import Mesh


class StepReport(NamedTuple):
    """What was found in the frame that was added, and in the step to it.

    Attributes
    ----------
    frame : AuditFrame
        How many pairs, and when the first touches.
    pairs : AuditPairs
        What was found, a row a pair.
    problem : str
        Why the frame could not be used; empty if it could.
    """

    frame: AuditFrame
    pairs: AuditPairs
    problem: str

    @property
    def is_free(self) -> bool:
        """True: nothing was found, proven."""
        return not self.problem and not len(self.pairs)


class Auditor:
    """Audits a motion while it is being made: one frame after the other, as `audit` does a recorded one.

    >>> auditor = tamis.Auditor(tamis.Mesh(faces))
    >>> while simulating:
    ...     if not auditor.add(positions).is_free: ...
    >>> auditor.report()

    Parameters
    ----------
    mesh : Mesh
        What moves.
    objects : array_like of int, shape (n,), or dict, optional
        The object that each vertex belongs to, from 0, -1 for none; or the vertices of each object by its name, as
        slices, ranges or arrays of indices. By default what is connected is an object.
    min_separation : float
        d >= 0 in the unit of the positions: contact means Euclidean distance <= d. Intersections have none.
    threads : int
        That share each frame; 0: all. Speed only.
    intersections, contacts : bool
        What to ask: of each frame, and of each step between two.
    ring_limit : int
        From 1 to 1000: how far to search for the path between two features, in edges.
    listed_pairs : int
        >= 0: how many pairs `AuditReport.pairs` may list; all are counted.

    Raises
    ------
    InvalidOptions
        An option outside its range.
    InvalidMesh
        Objects that do not fit the mesh.
    """

    __slots__ = ("_auditor", "_mesh", "_names")

    def __init__(
        self,
        mesh: Mesh,
        *,
        objects: Objects | None = None,
        min_separation: float = 0.0,
        threads: int = 0,
        intersections: bool = True,
        contacts: bool = True,
        ring_limit: int = 10,
        listed_pairs: int = 1_000_000,
    ) -> None:
        shared = shared_mesh(mesh, objects)
        options = make_audit_options(
            min_separation=min_separation,
            threads=threads,
            intersections=intersections,
            contacts=contacts,
            ring_limit=ring_limit,
            listed_pairs=listed_pairs,
        )
        self._mesh = mesh
        self._names = ObjectNames([(0, shared.object_names)])
        self._auditor = _core.Auditor(shared, options)

    @property
    def mesh(self) -> Mesh:
        """What moves."""
        return self._mesh

    def add(self, positions: npt.ArrayLike, name: str | None = None) -> StepReport:
        """Ask about the next frame, and about the step to it from the one before.

        Parameters
        ----------
        positions : array_like, shape (n, 3)
            Where each vertex is. They are copied, as doubles: the same memory may hold the next frame.
        name : str, optional
            What to call the frame; by default its number.

        Returns
        -------
        StepReport
            A frame that cannot be used, such as one with a NaN, has a `problem`; no step leads to it or from it.

        Raises
        ------
        InvalidStep
            Positions that are no rows of three numbers.
        """
        called = "" if name is None else word(name, "name")
        row, label, problem, pairs = self._auditor.add(rows(positions, "positions"), called)
        frame = AuditFrames(row)[0]
        return StepReport(frame._replace(name=label), AuditPairs(pairs, self._names), problem)

    def report(self) -> AuditReport:
        """Return what was found in all frames so far."""
        return AuditReport(self._auditor.report())

    def __reduce__(self) -> Any:
        raise TypeError("an Auditor cannot be pickled: make one where you need it")
