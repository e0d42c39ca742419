"""Questions to a world."""

from __future__ import annotations

import numpy.typing as npt

from tamis import _core
from tamis._arrays import Doubles
from tamis._checks import number, whole
from tamis._options import AtStart, query_options
from tamis._world._bodies import chains_of_each, numbers_of
from tamis._world._tables import (
    BodyContacts,
    BodyIntersections,
    BodyNearPairs,
    BodyStep,
    EarliestBodyContact,
    EarliestMany,
    body_step_of,
    earliest_many_of,
    earliest_of,
)


class Questions:
    """What touches while the bodies move, how far all may go, and what is near at the start; part of `World`."""

    __slots__ = ()
    _world: _core.World

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
            As of `Detector.contacts`. Where one of two bodies turns, "ignore" looks at certain times alone: a pair
            counts from the first of these on at which it is proven apart (docs/worlds.md).
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

    def earliest_many(
        self,
        bodies: npt.ArrayLike,
        motions: npt.ArrayLike,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
        tolerance: float | None = None,
    ) -> EarliestMany:
        """Find the first contact for each of many motions of some bodies: a planner's, between configurations.

        All other bodies move as they were told, and so do these afterwards. Threads share the motions; each answer has
        the bits that it has alone.

        Parameters
        ----------
        bodies : array_like of int, shape (b,)
            Each once.
        motions : array_like, shape (n, b, links, 4, 3)
            For each motion a chain for each of the bodies, as of `add`.
        min_separation, at_start, tolerance
            As of `contacts`.

        Returns
        -------
        EarliestMany
            Motion i is free before `toi_lower[i]`: proven.

        Raises
        ------
        InvalidOptions
            A body that is not there, or one twice.
        InvalidPath
            Motions of another shape, or numbers that are not finite.
        InvalidStep
            With at_start="fail".
        """
        named = numbers_of(bodies)
        asked = query_options(min_separation, at_start, tolerance)
        return earliest_many_of(self._world.earliest_many(named, chains_of_each(motions, named), asked))

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
        self,
        keep: float = 0.1,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
        tolerance: float | None = None,
    ) -> BodyStep:
        """Find how far all may go so that every pair keeps a fraction of its distance.

        Parameters
        ----------
        keep, min_separation, at_start
            As of `Detector.safe_step`.
        tolerance : float, optional
            As of `contacts`.

        Returns
        -------
        BodyStep
            On [0, lower] every pair keeps the fraction: proven. Where one of two bodies turns, a pair that starts
            nearer to its separation than doubles can tell ends the step at once.

        Raises
        ------
        InvalidOptions
            An option outside its range.
        InvalidStep
            With at_start="fail".
        """
        asked = query_options(min_separation, at_start, tolerance)
        return body_step_of(self._world.safe_step(number(keep, "keep"), asked))

    def pairs_within(self, distance: float) -> BodyNearPairs:
        """Find every pair of features that is near at t=0.

        Two bodies that only have poses are not asked about, even where they pass through each other: give one of them
        ``interpolated(pose, pose)``.

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

        Two bodies that only have poses are not asked about, as of `pairs_within`.

        Returns
        -------
        BodyIntersections
            By bodies, edge and face.
        """
        return BodyIntersections(self._world.intersections())

    def has_intersection(self) -> bool:
        """Tell whether any edge passes through a triangle or touches it at t=0: whether this is no start to move from.

        Two bodies that only have poses are not asked about, as of `pairs_within`.

        Returns
        -------
        bool
            Exact, of the pairs that `intersections` asks about. Ends at the first.
        """
        return self._world.has_intersection()

    def points_at(self, body: int, time: float) -> tuple[Doubles, float]:
        """Tell where the vertices of a body are at a time of its motion, on the curves that questions are about.

        Parameters
        ----------
        body : int
            That `add` has returned.
        time : float
            In [0, 1]: that of a contact, say.

        Returns
        -------
        points : array, shape (n, 3)
            One a vertex of its shape, in the frame of the world.
        error : float
            No coordinate is off by more, of vertices that take part in contacts. 0: the points are exact.

        Raises
        ------
        InvalidOptions
            The body is not there, or the time is outside the step.
        """
        return self._world.points_at(whole(body, "body"), number(time, "time"))
