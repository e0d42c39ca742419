"""`Auditor`: audits a motion while it is being simulated."""

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
    """The findings in the frame that was added, and in the step to it.

    Attributes
    ----------
    frame : AuditFrame
        The numbers of pairs, and the time of the first contact.
    pairs : AuditPairs
        The intersections and contacts.
    problem : str
        Why the frame could not be used; empty if it could.
    """

    frame: AuditFrame
    pairs: AuditPairs
    problem: str

    @property
    def is_free(self) -> bool:
        """Whether the frame could be used, and nothing was found in it and the step to it, nor an object collapsed.

        True is a proof; if `intersections` or `contacts` was False, it says nothing about these.
        """
        return not self.problem and not self.frame.has_collapsed and not len(self.pairs)


class Auditor:
    """Audits a motion while it is being simulated, one frame after the other, as `audit` does a recorded motion.

    >>> auditor = tamis.Auditor(tamis.Mesh(faces))
    >>> while simulating:
    ...     if not auditor.add(positions).is_free: ...
    >>> auditor.report()

    Parameters
    ----------
    mesh : Mesh
        The mesh that moves.
    objects : array_like of int, shape (n,), or dict, optional
        The object that each vertex belongs to, >= 0, or -1 for none. Or a dict from the name of each object to its
        vertices: a slice, a range or an array of indices. By default each connected part of the mesh is an object.
    min_separation : float
        d >= 0, in the unit of the positions: contact means Euclidean distance <= d. It does not count for
        intersections.
    threads : int
        The number of threads that share each frame, >= 0; 0: all. Changes speed only.
    intersections, contacts : bool
        Whether to find the intersections in each frame, and the contacts in each step.
    ring_limit : int
        In [1, 1000]: the largest number of edges to search for the shortest path between the features of a pair.
    listed_pairs : int
        >= 0: the largest number of pairs in `AuditReport.pairs`. All pairs are counted.
    page_bytes : int
        >= 0: memory for frames that the page of the report shows, 32 MB by default. If they need more, the report
        keeps those with findings, and some of the others. 0: no frame; `view` then has none to show.

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
        page_bytes: int = 32 << 20,
    ) -> None:
        shared = shared_mesh(mesh, objects)
        options = make_audit_options(
            min_separation=min_separation,
            threads=threads,
            intersections=intersections,
            contacts=contacts,
            ring_limit=ring_limit,
            listed_pairs=listed_pairs,
            page_bytes=page_bytes,
        )
        self._mesh = mesh
        self._names = ObjectNames([(0, shared.object_names)])
        self._auditor = _core.Auditor(shared, options)

    @property
    def mesh(self) -> Mesh:
        """The mesh that moves."""
        return self._mesh

    def add(self, positions: npt.ArrayLike, name: str | None = None) -> StepReport:
        """Audit the next frame, and the step to it from the frame before.

        Parameters
        ----------
        positions : array_like, shape (n, 3)
            Where each vertex is. They are copied: the same memory may hold the next frame.
        name : str, optional
            The name of the frame; by default its number.

        Returns
        -------
        StepReport
            The findings. A frame that cannot be used, such as one with a NaN, has a `problem`; no step leads to it or
            from it.

        Raises
        ------
        InvalidStep
            An array of another shape than (n, 3), or of another type.
        InvalidOptions
            `name` is not text.
        """
        called = "" if name is None else word(name, "name")
        row, label, problem, pairs = self._auditor.add(rows(positions, "positions"), called)
        frame = AuditFrames(row)[0]
        return StepReport(frame._replace(name=label), AuditPairs(pairs, self._names), problem)

    def report(self) -> AuditReport:
        """Return the findings in all frames so far."""
        return AuditReport(self._auditor.report())

    def __reduce__(self) -> Any:
        raise TypeError("an Auditor cannot be pickled: make one where you need it")
