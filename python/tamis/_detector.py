"""Continuous collision detection of a mesh with itself, step after step."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, overload

import numpy.typing as npt

from tamis import _core
from tamis._answers import EarliestContact, SafeStep, TruncatedStep, safe_step
from tamis._arrays import Doubles, rows
from tamis._checks import instance, number, number_or_none
from tamis._contacts import Contacts
from tamis._errors import InvalidMesh
from tamis._looking import Asked
from tamis._mesh import Mesh
from tamis._motion import motion
from tamis._near import Intersections, NearPairs
from tamis._options import Filter, Isa, PaperOptions, make_options
from tamis._paths import Path
from tamis._statistics import Statistics


class Detector:
    """Holds a mesh and the hierarchy over it; keep one for all steps of a mesh.

    The first question builds the hierarchy; later ones refit it, and rebuild it by themselves once that pays. Pairs are
    vertex-face and edge-edge, of features without a common vertex. The answers do not depend on the number of threads,
    on the machine, or on earlier questions.

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
    method : str
        "tamis"; or "paper", "brute" and the others of `method_choices()`, which give the same contacts.
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
    thickness : array_like of float, shape (g,), optional
        A radius >= 0 for each group: contact means a distance of at most `min_separation` plus both radii.
    filter : callable, optional
        ``filter(kind, vertices)`` is asked for every pair that is left, and says whether it counts. From several
        threads, one at a time: slow, a microsecond a pair. Groups cost nothing.
    is_cancelled : callable, optional
        Asked some 20 times a second during a question; True ends it with `Cancelled`.
    paper : PaperOptions, optional
        More choices for the method "paper".

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
        method: str = "tamis",
        threads: int = 0,
        min_separation: float = 0.0,
        isa: Isa = "best",
        groups: npt.ArrayLike | None = None,
        may_touch: npt.ArrayLike | None = None,
        thickness: npt.ArrayLike | None = None,
        filter: Filter | None = None,
        is_cancelled: Callable[[], bool] | None = None,
        paper: PaperOptions | None = None,
    ) -> None:
        known = instance(mesh, Mesh, "mesh", "a tamis.Mesh, as of tamis.Mesh(faces)", InvalidMesh)
        options = make_options(
            method=method,
            threads=threads,
            min_separation=min_separation,
            isa=isa,
            groups=groups,
            may_touch=may_touch,
            thickness=thickness,
            filter=filter,
            is_cancelled=is_cancelled,
        )
        if paper is not None:
            instance(paper, PaperOptions, "paper", "a tamis.PaperOptions")._apply(options)
        self._mesh = known
        self._options = options
        self._detector = _core.Detector(known._mesh, options)
        self._description = f"method={method!r}, min_separation={float(min_separation):g}"

    @property
    def mesh(self) -> Mesh:
        """What moves."""
        return self._mesh

    @property
    def statistics(self) -> Statistics:
        """What the last question cost."""
        return Statistics(**self._detector.statistics())

    @overload
    def contacts(
        self, start: npt.ArrayLike, end: npt.ArrayLike, *, min_separation: float | None = None
    ) -> Contacts: ...
    @overload
    def contacts(
        self, start: Path, /, *, min_separation: float | None = None, tolerance: float | None = None
    ) -> Contacts: ...
    def contacts(
        self,
        start: npt.ArrayLike | Path,
        end: npt.ArrayLike | None = None,
        *,
        min_separation: float | None = None,
        tolerance: float | None = None,
    ) -> Contacts:
        """Find every contact of a step, or of a path.

        Parameters
        ----------
        start, end : array_like, shape (n, 3)
            Where each vertex is at the start and at the end of the step. Or a `Path` alone: curved motion.
        min_separation : float, optional
            Of this question alone; by default the detector's.
        tolerance : float, optional
            Of a path: widest bracket of a contact, in (0, 1], a fraction of the step; by default 1e-9.

        Returns
        -------
        Contacts
            By kind, then vertices; `Contacts.view` shows them. On a path, what cannot be decided (a touch
            without crossing, say) is a contact that is not certified.
        """
        moving = motion(start, end, tolerance)
        separation = number_or_none(min_separation, "min_separation")
        found = self._detector.contacts(*moving.native(), separation)
        return Contacts(found, Asked(self._mesh._mesh, self._options, moving, separation))

    @overload
    def earliest(
        self, start: npt.ArrayLike, end: npt.ArrayLike, *, min_separation: float | None = None
    ) -> EarliestContact: ...
    @overload
    def earliest(
        self, start: Path, /, *, min_separation: float | None = None, tolerance: float | None = None
    ) -> EarliestContact: ...
    def earliest(
        self,
        start: npt.ArrayLike | Path,
        end: npt.ArrayLike | None = None,
        *,
        min_separation: float | None = None,
        tolerance: float | None = None,
    ) -> EarliestContact:
        """Find the first contact: how far the step, or the path, may go. `truncate` says to which positions.

        Parameters
        ----------
        start, end, min_separation, tolerance
            As of `contacts`.

        Returns
        -------
        EarliestContact
            The motion is free before its `toi_lower`: proven.
        """
        separation = number_or_none(min_separation, "min_separation")
        lower, upper, found = self._detector.earliest(*motion(start, end, tolerance).native(), separation)
        contacts = Contacts(found)
        return EarliestContact(lower, upper, contacts[0] if len(contacts) else None)

    @overload
    def is_free(self, start: npt.ArrayLike, end: npt.ArrayLike, *, min_separation: float | None = None) -> bool: ...
    @overload
    def is_free(
        self, start: Path, /, *, min_separation: float | None = None, tolerance: float | None = None
    ) -> bool: ...
    def is_free(
        self,
        start: npt.ArrayLike | Path,
        end: npt.ArrayLike | None = None,
        *,
        min_separation: float | None = None,
        tolerance: float | None = None,
    ) -> bool:
        """Tell whether the whole step, or the whole path, is free of contacts.

        Parameters
        ----------
        start, end, min_separation, tolerance
            As of `contacts`.

        Returns
        -------
        bool
            True is a proof. On a path False may be due to a contact that is not certified.
        """
        separation = number_or_none(min_separation, "min_separation")
        return self._detector.is_free(*motion(start, end, tolerance).native(), separation)

    def keep_distance(
        self, start: npt.ArrayLike, end: npt.ArrayLike, fraction: float = 0.1, *, min_separation: float | None = None
    ) -> SafeStep:
        """Find how far the step may go so that every pair keeps a fraction of its distance.

        The step length for the line search of a barrier method. The distance that counts is what exceeds the minimum
        separation.

        Parameters
        ----------
        start, end : array_like, shape (n, 3)
            Where each vertex is at the start and at the end of the step.
        min_separation : float, optional
            Of this question alone; by default the detector's.
        fraction : float
            0 <= fraction < 1. 0.1 for the line search of a barrier, where the next steps need room; 0.01 and less to
            come near what is met; 0.5 and more where distances may shrink slowly only. 0: only contacts count. The
            closer to 1, the longer the search.

        Returns
        -------
        SafeStep
            On [0, lower] every pair keeps the fraction: proven.

        Raises
        ------
        InvalidOptions
            The fraction is outside its range.
        """
        return safe_step(self._detector.keep_distance(*_given(start, end, fraction, min_separation)))

    def truncate(
        self, start: npt.ArrayLike, end: npt.ArrayLike, fraction: float = 0.1, *, min_separation: float | None = None
    ) -> TruncatedStep:
        """Find positions to go to, so that every pair keeps a fraction of its distance, and one does not stop all.

        All vertices go together as far as every pair keeps a little more than the fraction, from there each on its own
        side of planes between the features that it could reach, by a quarter of the mean edge at most. What starts
        within the minimum separation may move as long as it comes no nearer; then no vertex goes farther than that.

        Parameters
        ----------
        start, end : array_like, shape (n, 3)
            Where each vertex is at the start and at the end of the step.
        fraction : float
            0 < fraction < 1, of the distance as far as that exceeds the minimum separation.
        min_separation : float, optional
            Of this question alone; by default the detector's.

        Returns
        -------
        TruncatedStep
            Positions as doubles: the straight way there is proven.

        Raises
        ------
        InvalidOptions
            The fraction is outside its range.
        """
        return TruncatedStep(*self._detector.truncate(*_given(start, end, fraction, min_separation)))

    def near(self, positions: npt.ArrayLike, distance: float) -> NearPairs:
        """Find every pair of features that is near at rest: what a barrier or penalty method starts from.

        Parameters
        ----------
        positions : array_like, shape (n, 3)
            Where each vertex is.
        distance : float
            >= 0, in the unit of the positions; both radii of `thickness` come on top.

        Returns
        -------
        NearPairs
            Each pair once, by kind, then vertices.

        Raises
        ------
        InvalidOptions
            The distance is negative or not finite.
        """
        return NearPairs(self._detector.near(rows(positions, "positions"), number(distance, "distance")))

    def intersections(self, positions: npt.ArrayLike) -> Intersections:
        """Find every edge that passes through a triangle or touches it: exactly.

        Parameters
        ----------
        positions : array_like, shape (n, 3)
            Where each vertex is.

        Returns
        -------
        Intersections
            By edge, then face. Of the filter the groups count, thickness does not.
        """
        return Intersections(self._detector.intersections(rows(positions, "positions")))

    def has_intersection(self, positions: npt.ArrayLike) -> bool:
        """Tell whether any edge passes through a triangle or touches it: whether this is no pose to start from.

        Parameters
        ----------
        positions : array_like, shape (n, 3)
            Where each vertex is.

        Returns
        -------
        bool
            Exact. Ends at the first.
        """
        return self._detector.has_intersection(rows(positions, "positions"))

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


def _given(
    start: npt.ArrayLike, end: npt.ArrayLike, fraction: float, min_separation: float | None
) -> tuple[Doubles, Doubles, float, float | None]:
    separation = number_or_none(min_separation, "min_separation")
    return rows(start, "start"), rows(end, "end"), number(fraction, "fraction"), separation
