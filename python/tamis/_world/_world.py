"""Bodies, each with its own mesh and its own way of moving."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import Indices, indices, numbers
from tamis._checks import number, truth, whole
from tamis._errors import InvalidOptions, InvalidPath
from tamis._options import AtStart, Isa, make_options, query_options
from tamis._statistics import Statistics
from tamis._world._bodies import AT_REST, Deforming, Shape, known_shape, motion_of, motions_of, numbers_of
from tamis._world._tables import (
    BodyContacts,
    BodyIntersections,
    BodyNearPairs,
    BodyStep,
    EarliestBodyContact,
    body_step_of,
    earliest_of,
)


class World:
    """Bodies, each with its own shape and motion, and the questions of a `Detector` about them.

    Each body moves during t in [0, 1] as it was told last. What does not deform costs nothing to keep, and bodies far
    from each other next to nothing. A body that has a pose stays there; one that has a chain moves by it as a whole;
    one that is `Deforming` goes straight, vertex by vertex. Where no rotation of a chain changes, contacts are decided
    exactly, as of a step; where one turns, as on a `Path`: proven free, or with a bracket as narrow as the tolerance,
    or not certified.

    Other Python threads run meanwhile, Ctrl-C ends a question, and a question or change during a question raises
    `Busy`. Whatever names a body that is not there, or no more, raises `InvalidOptions`. The answers do not depend on
    the number of threads, on the machine, or on earlier questions.

    Parameters
    ----------
    threads : int
        To use; 0: all. Speed only.
    min_separation : float
        d >= 0 in the unit of the points: contact means Euclidean distance <= d. A question may bring its own.
    isa : str
        Instruction set: "best", "baseline", "avx2", "avx512". Speed only.
    rings : int
        As of `Detector`: of deforming bodies with themselves.
    is_cancelled : callable, optional
        Asked some 20 times a second during a question; True ends it with `Cancelled`.

    Raises
    ------
    InvalidOptions
        An option outside its range, or an unknown name.
    """

    __slots__ = ("_description", "_world")

    def __init__(
        self,
        *,
        threads: int = 0,
        min_separation: float = 0.0,
        isa: Isa = "best",
        rings: int = 1,
        is_cancelled: Callable[[], bool] | None = None,
    ) -> None:
        options = make_options(
            threads=threads,
            min_separation=min_separation,
            isa=isa,
            groups=None,
            may_touch=None,
            radii=None,
            filter=None,
            rings=rings,
            is_cancelled=is_cancelled,
        )
        self._world = _core.World(options)
        self._description = f"min_separation={float(min_separation):g}"

    def add(self, shape: Shape, motion: npt.ArrayLike | Deforming | None = None) -> int:
        """Add a body.

        Parameters
        ----------
        shape : Shape
            Its mesh; one may serve many bodies.
        motion : array_like or Deforming, optional
            A pose, shape (2, 3): position and rotation vector, where it stays (`pose_of`). A chain, shape (links, 4,
            3): it moves by it (`between`, `interpolated`, `turned`). Or `Deforming`. None: stays as its shape is given.

        Returns
        -------
        int
            Names the body: 0, 1, 2, ..., never given twice.

        Raises
        ------
        InvalidPath
            No pose and no chain, or numbers that are not finite.
        InvalidStep
            A deforming body with other than one point a vertex, or one that is not finite.
        """
        return int(self._world.add(known_shape(shape)._shape, *motion_of(AT_REST if motion is None else motion))[0])

    def add_many(self, shape: Shape, motions: npt.ArrayLike) -> Indices:
        """Add bodies of one shape.

        Parameters
        ----------
        shape : Shape
            Of all.
        motions : array_like, shape (n, 2, 3) or (n, links, 4, 3)
            Poses, where they stay (`pose_of`), or chains, by which they move (`between`).

        Returns
        -------
        array of int, shape (n,)
            Names them, in order.

        Raises
        ------
        InvalidPath
            As of `add`; then none is added.
        """
        return self._world.add(known_shape(shape)._shape, motions_of(motions))

    def move(self, body: int, motion: npt.ArrayLike | Deforming) -> None:
        """Say how a body moves from now on; it may also begin to move in another way.

        Parameters
        ----------
        body : int
            That `add` has returned.
        motion : array_like or Deforming
            As of `add`.

        Raises
        ------
        InvalidPath, InvalidStep
            As of `add`.
        """
        self._world.move(np.array([whole(body, "body")], np.int32), *motion_of(motion))

    def move_many(self, bodies: npt.ArrayLike, motions: npt.ArrayLike) -> None:
        """Say how bodies move from now on, all in one call: ``world.move_many(bodies, tamis.between(start, end))``.

        Parameters
        ----------
        bodies : array_like of int, shape (n,)
            Each once.
        motions : array_like, shape (n, 2, 3) or (n, links, 4, 3)
            Of each, as of `add_many`.

        Raises
        ------
        InvalidPath
            As of `add`, or not as many; then none is moved.
        InvalidOptions
            A body twice: none is moved. One that is not there: those before it are.
        """
        given, named = motions_of(motions), numbers_of(bodies)
        if len(named) != len(given):
            raise InvalidPath(f"motions has {len(given)} entries, bodies {len(named)}: give as many")
        ordered = np.sort(named)
        twice = ordered[1:][ordered[1:] == ordered[:-1]]
        if len(twice):
            raise InvalidOptions(f"bodies holds {twice[0]} twice: a body goes one way, give each once")
        self._world.move(named, given)

    def remove(self, bodies: npt.ArrayLike) -> None:
        """Take bodies out of the world; their numbers are not given again.

        Parameters
        ----------
        bodies : int or array_like of int, shape (n,)
            Which.
        """
        self._world.remove(numbers_of(bodies))

    def set_enabled(self, bodies: npt.ArrayLike, is_enabled: bool) -> None:
        """Switch bodies off, so that they take no part in any question, or on again; they begin switched on.

        Parameters
        ----------
        bodies : int or array_like of int, shape (n,)
            Which.
        is_enabled : bool
            On, or off.
        """
        self._world.set_enabled(numbers_of(bodies), truth(is_enabled, "is_enabled"))

    def set_may_touch(self, bodies: npt.ArrayLike, may_touch: bool) -> None:
        """Say of pairs of bodies whether they may touch at all.

        At first all may but two that both stay; a deforming one may touch itself.

        Parameters
        ----------
        bodies : array_like of int, shape (2,) or (n, 2)
            One pair or many; a deforming body with itself is twice the same.
        may_touch : bool
            False leaves these pairs out of every answer.

        Raises
        ------
        InvalidOptions
            True for two bodies that both stay, or for one with itself that does not deform.
        """
        pairs = indices(np.atleast_2d(numbers(bodies, "bodies", InvalidOptions)), 2, "bodies", InvalidOptions)
        self._world.set_may_touch(pairs, truth(may_touch, "may_touch"))

    def contacts(
        self,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
        tolerance: float | None = None,
    ) -> BodyContacts:
        """Find every contact.

        Parameters
        ----------
        min_separation : float, optional
            Of this question alone; by default the world's.
        at_start : str
            As of `Detector.contacts`; of bodies that turn, "ignore" leaves a pair out until one of some times proves it
            apart (docs/worlds.md).
        tolerance : float, optional
            Where one of two bodies turns: widest bracket of a contact, in (0, 1], a fraction of the step; by default
            1e-9.

        Returns
        -------
        BodyContacts
            By kind, then bodies and vertices; the bodies in a column of their own.

        Raises
        ------
        InvalidOptions
            An option outside its range.
        InvalidStep
            With at_start="fail".
        """
        return BodyContacts(self._world.contacts(query_options(min_separation, at_start, tolerance)))

    def earliest(
        self,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
        tolerance: float | None = None,
    ) -> EarliestBodyContact:
        """Find the first contact: how far all may go.

        Parameters
        ----------
        min_separation, at_start, tolerance
            As of `contacts`.

        Returns
        -------
        EarliestBodyContact
            The motion is free before its `toi_lower`: proven.
        """
        return earliest_of(self._world.earliest(query_options(min_separation, at_start, tolerance)))

    def is_free(
        self,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
        tolerance: float | None = None,
    ) -> bool:
        """Tell whether the motion of all bodies is free of contacts.

        Parameters
        ----------
        min_separation, at_start, tolerance
            As of `contacts`.

        Returns
        -------
        bool
            True is a proof. Where a body turns, False may be due to a contact that is not certified.
        """
        return self._world.is_free(query_options(min_separation, at_start, tolerance))

    def safe_step(
        self, keep: float = 0.1, *, min_separation: float | None = None, at_start: AtStart = "report"
    ) -> BodyStep:
        """Find how far all may go so that every pair keeps a fraction of its distance.

        Parameters
        ----------
        keep, min_separation, at_start
            As of `Detector.safe_step`.

        Returns
        -------
        BodyStep
            On [0, lower] every pair keeps the fraction: proven.

        Raises
        ------
        InvalidOptions
            A body that turns comes near another: ask `earliest`.
        """
        return body_step_of(self._world.safe_step(number(keep, "keep"), query_options(min_separation, at_start)))

    def pairs_within(self, distance: float) -> BodyNearPairs:
        """Find every pair of features that is near at t=0.

        Parameters
        ----------
        distance : float
            >= 0, in the unit of the points.

        Returns
        -------
        BodyNearPairs
            Each pair once, by kind, then bodies and vertices.

        Raises
        ------
        InvalidOptions
            The distance is negative or not finite.
        """
        return BodyNearPairs(self._world.pairs_within(number(distance, "distance")))

    def intersections(self) -> BodyIntersections:
        """Find every edge that passes through a triangle or touches it at t=0: exactly.

        Returns
        -------
        BodyIntersections
            By bodies, edge and face.
        """
        return BodyIntersections(self._world.intersections())

    @property
    def statistics(self) -> Statistics:
        """What the last question cost; `memory_bytes` without shapes."""
        return Statistics(**self._world.statistics())

    def __repr__(self) -> str:
        return f"World({self._description})"

    def __reduce__(self) -> Any:
        raise TypeError("a World cannot be pickled: pickle its shapes, and make a World where you need it")
