"""Continuous collision detection of a mesh with itself, step after step."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy.typing as npt

from tamis import _core
from tamis._arrays import rows
from tamis._checks import instance
from tamis._detector._at_rest import AtRest
from tamis._detector._in_motion import InMotion
from tamis._detector._step_lengths import StepLengths
from tamis._errors import InvalidMesh
from tamis._mesh import Mesh
from tamis._options import Filter, Isa, make_options
from tamis._statistics import Statistics
from tamis._tables._contacts import Contacts


class Detector(InMotion, StepLengths, AtRest):
    """Holds a mesh and the hierarchy over it; keep one for all steps of a mesh.

    The first question builds the hierarchy; later ones refit it, and rebuild it by themselves once that pays. Pairs are
    vertex-face and edge-edge, of loose edges and points also vertex-edge and vertex-vertex; their features have no
    common vertex. The answers do not depend on the number of threads, on the machine, or on earlier questions.

    Questions take positions at the start and at the end of a step, shape (n, 3), one row a vertex; each vertex moves on
    a straight line. Doubles whose rows are contiguous, at any positive distance from each other, are read where they
    are; anything else that NumPy can convert is copied once. `contacts`, `earliest` and `is_free` take a `Path` in
    place of both, for curved motion. Other Python threads run meanwhile, Ctrl-C ends a question, and a second question
    at the same time raises `Busy`. Every question raises `InvalidStep` for positions that do not fit the mesh or are
    not finite, `InvalidPath` for a path that does not fit or breaks its promises.

    Parameters
    ----------
    mesh : Mesh
        What moves.
    threads : int
        To use; 0: all. Speed only.
    min_separation : float
        d >= 0 in the unit of the positions: contact means Euclidean distance <= d. A question may bring its own.
    isa : str
        Instruction set: "best", "baseline", "avx2", "avx512". Speed only.
    groups : array_like of int, shape (n,), optional
        The object that each vertex belongs to, from 0; a feature belongs to the group of its first vertex.
    may_touch : array_like of bool, shape (g, g), optional
        Symmetric; False leaves out the pairs of two groups. ``~np.eye(g, dtype=bool)``: no self-contact.
    radii : array_like of float, shape (g,), optional
        A radius >= 0 for each group: contact means a distance of at most `min_separation` plus both radii.
    filter : callable, optional
        ``filter(kind, vertices)`` returns True for a pair that counts, False for one to leave out. It is called for
        every pair that groups leave, from several threads, one at a time: slow, a microsecond a pair. Groups cost
        nothing.
    rings : int
        Leaves out pairs whose features are fewer than this many edges apart, along the mesh; 1: those with a common
        vertex. Looked at last, and only for pairs that would be in an answer.
    is_cancelled : callable, optional
        Asked some 20 times a second during a question; True ends it with `Cancelled`.

    Raises
    ------
    InvalidOptions
        An option outside its range, an unknown name, or groups that do not fit the mesh.
    """

    __slots__ = ("_description", "_detector", "_mesh", "_options")

    def __init__(
        self,
        mesh: Mesh,
        *,
        threads: int = 0,
        min_separation: float = 0.0,
        isa: Isa = "best",
        groups: npt.ArrayLike | None = None,
        may_touch: npt.ArrayLike | None = None,
        radii: npt.ArrayLike | None = None,
        filter: Filter | None = None,
        rings: int = 1,
        is_cancelled: Callable[[], bool] | None = None,
    ) -> None:
        known = instance(mesh, Mesh, "mesh", "a tamis.Mesh, as of tamis.Mesh(faces)", InvalidMesh)
        options = make_options(
            threads=threads,
            min_separation=min_separation,
            isa=isa,
            groups=groups,
            may_touch=may_touch,
            radii=radii,
            filter=filter,
            rings=rings,
            is_cancelled=is_cancelled,
        )
        self._mesh = known
        self._options = options
        self._detector = _core.Detector(known._mesh, options)
        self._description = f"min_separation={float(min_separation):g}"

    @property
    def mesh(self) -> Mesh:
        """What moves."""
        return self._mesh

    @property
    def statistics(self) -> Statistics:
        """What the last question cost."""
        return Statistics(**self._detector.statistics())

    def __repr__(self) -> str:
        return f"Detector({self._mesh!r}, {self._description})"

    def __reduce__(self) -> Any:
        raise TypeError("a Detector cannot be pickled: pickle its Mesh, and make a Detector where you need it")


def contacts(faces: npt.ArrayLike, start: npt.ArrayLike, end: npt.ArrayLike, **options: Any) -> Contacts:
    """Find every contact of one step of a triangle mesh. For more than one step keep a `Detector`.

    Parameters
    ----------
    faces : array_like of int, shape (f, 3)
        Vertex indices of each triangle.
    start, end : array_like, shape (n, 3)
        Where each vertex is at the start and at the end of the step.
    **options
        As of `Detector`.

    Returns
    -------
    Contacts
        By kind, then vertices.
    """
    first = rows(start, "start")
    return Detector(Mesh(faces, vertex_count=len(first)), **options).contacts(first, end)
