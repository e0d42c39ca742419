"""Continuous collision detection of a mesh with itself, step after step."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy.typing as npt

from tamis import _core
from tamis._arrays import rows
from tamis._detector._at_rest import AtRest
from tamis._detector._in_motion import InMotion
from tamis._detector._step_lengths import StepLengths
from tamis._mesh import Mesh, known_mesh
from tamis._options import Filter, Isa, make_options
from tamis._statistics import Statistics
from tamis._tables._contacts import Contacts


class Detector(InMotion, StepLengths, AtRest):
    """Holds a mesh and the hierarchy over it; keep one for all steps of a mesh.

    The first question builds the hierarchy. Later questions refit it, and rebuild it once refitting has made it poor.
    Pairs are vertex-face and edge-edge; with loose edges and points also vertex-edge and vertex-vertex. Features with a
    common vertex are not a pair. The answers do not depend on the number of threads, on the machine, or on earlier
    questions.

    Questions take positions at the start and at the end of a step, shape (n, 3), one row a vertex. Each vertex moves on
    a straight line. Float64 arrays whose rows are contiguous, at any positive distance from each other, are read in
    place. Anything else that NumPy can convert is copied once. For motion on curves, `contacts`, `earliest` and
    `is_free` take a `Path` instead of start and end.

    Other Python threads run during a question, and Ctrl-C ends it. A second question at the same time raises `Busy`.
    Every question raises `InvalidStep` for positions that do not fit the mesh or are not finite. It raises
    `InvalidPath` for a path that does not fit the mesh or breaks its promises.

    Parameters
    ----------
    mesh : Mesh
        The mesh that moves.
    threads : int
        The number of threads to use, >= 0; 0: all. Changes speed only.
    min_separation : float
        d >= 0, in the unit of the positions: contact means Euclidean distance <= d. A question may have its own.
    isa : str
        Instruction set: "best", "baseline", "avx2", "avx512". Changes speed only.
    groups : array_like of int, shape (n,), optional
        The group of each vertex, >= 0, such as the object it belongs to. A feature has the group of its first vertex.
    may_touch : array_like of bool, shape (g, g), optional
        Symmetric; False skips the pairs of these two groups. ``~np.eye(g, dtype=bool)``: no self-contact.
    radii : array_like of float, shape (g,), optional
        A radius >= 0 for each group, half of its thickness: contact means a distance of at most `min_separation` plus
        both radii.
    filter : callable, optional
        ``filter(kind, vertices)`` returns True for a pair that counts, False for a pair to skip. Any other answer
        raises `InvalidOptions`. It is called for every pair that the groups do not skip, from several threads, one at a
        time. A call takes a microsecond; groups cost nothing.
    rings : int
        >= 1: skips pairs whose features are fewer than this many edges apart along the mesh. 1 skips pairs with a
        common vertex, which never count. Tested last, only for pairs that would be in the answer.
    is_cancelled : callable, optional
        ``is_cancelled()`` is called some 20 times a second during a question. It returns True to end the question with
        `Cancelled`, else False; any other answer raises `InvalidOptions`.

    Raises
    ------
    InvalidMesh
        `mesh` is not a `Mesh`.
    InvalidOptions
        An option outside its range, an unknown name, an instruction set that this machine lacks, or groups or radii
        that do not fit the mesh or each other.

    Examples
    --------
    >>> mesh = Mesh([[0, 1, 2]], points=[3], vertex_count=4)  # a triangle and a loose point
    >>> start = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.2, 0.2, 1.0]])
    >>> end = start - [[0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 4]]
    >>> Detector(mesh).contacts(start, end)
    Contacts(1 vertex-face; first at 0.25)
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
        known = known_mesh(mesh)
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
        """The mesh that moves."""
        return self._mesh

    @property
    def statistics(self) -> Statistics:
        """The cost of the last question."""
        return Statistics(**self._detector.statistics())

    def __repr__(self) -> str:
        return f"Detector({self._mesh!r}, {self._description})"

    def __reduce__(self) -> Any:
        raise TypeError("a Detector cannot be pickled: pickle its Mesh, and make a Detector where you need it")


def contacts(faces: npt.ArrayLike, start: npt.ArrayLike, end: npt.ArrayLike, **options: Any) -> Contacts:
    """Find every contact of one step of a triangle mesh. For more than one step, keep a `Detector`.

    Parameters
    ----------
    faces : array_like of int, shape (f, 3)
        Vertex indices of each triangle.
    start, end : array_like, shape (n, 3)
        Where each vertex is at the start and at the end of the step.
    **options
        As in `Detector`.

    Returns
    -------
    Contacts
        Sorted by kind, then vertices.

    Raises
    ------
    InvalidMesh, InvalidStep, InvalidOptions
        As in `Mesh`, `Detector.contacts` and `Detector`.
    """
    first = rows(start, "start")
    return Detector(Mesh(faces, vertex_count=len(first)), **options).contacts(first, end)
