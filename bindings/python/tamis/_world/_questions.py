"""Questions to a world."""

from __future__ import annotations

import numpy.typing as npt

from tamis import _core
from tamis._arrays import Doubles
from tamis._checks import number, truth, whole
from tamis._options import AtStart, path_options
from tamis._tables._table import bracket_of
from tamis._world._bodies import chains_of_each, numbers_of
from tamis._world._tables import (
    BodyContacts,
    BodyIntersections,
    BodyNearPairs,
    BodyStep,
    EarliestBodyContact,
    EarliestMany,
)


class Questions:
    """The questions of a `World` (this is a base of it)."""

    __slots__ = ()
    _world: _core.World

    def contacts(
        self,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
        tolerance: float | None = None,
    ) -> BodyContacts:
        """Find every contact of the step.

        Parameters
        ----------
        min_separation : float, optional
            >= 0, instead of the world's for this question alone.
        at_start : str
            As in `Detector.contacts`. If one of two bodies turns, "ignore" looks at certain times only: a pair counts
            from the first of them on at which it is proven apart (docs/worlds.md).
        tolerance : float, optional
            Only where one of two bodies turns: the widest bracket of a contact, a fraction of the step in (0, 1]; by
            default 1e-9.

        Returns
        -------
        BodyContacts
            Sorted by kind, then bodies and vertices.

        Raises
        ------
        InvalidOptions
            An option outside its range.
        InvalidStep
            With ``at_start="fail"``, if a pair touches at t=0.
        """
        return BodyContacts(self._world.contacts(path_options(min_separation, at_start, tolerance)))

    def first_contacts(
        self,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
        tolerance: float | None = None,
    ) -> BodyContacts:
        """Find the first contact of each pair of bodies, and of each deforming body with itself.

        Costs about as much as `earliest` where the same bodies meet, not as much as their contacts.

        Parameters
        ----------
        min_separation, at_start, tolerance
            As in `contacts`.

        Returns
        -------
        BodyContacts
            One for each pair that touches, sorted by the smaller body, then the greater one. It is the contact of the
            pair with the least `toi_lower`; of several such the first by kind, then bodies and vertices.

        Raises
        ------
        InvalidOptions, InvalidStep
            As `contacts`.
        """
        return BodyContacts(self._world.first_contacts(path_options(min_separation, at_start, tolerance)))

    def earliest(
        self,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
        tolerance: float | None = None,
    ) -> EarliestBodyContact:
        """Find the first contact: how far all bodies may go.

        Parameters
        ----------
        min_separation, at_start, tolerance
            As in `contacts`.

        Returns
        -------
        EarliestBodyContact
            The motion is free before its `toi_lower`, proven.
        """
        found = self._world.earliest(path_options(min_separation, at_start, tolerance))
        return EarliestBodyContact(*bracket_of(found, BodyContacts))

    def earliest_many(
        self,
        bodies: npt.ArrayLike,
        motions: npt.ArrayLike,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
        tolerance: float | None = None,
    ) -> EarliestMany:
        """Find the first contact for each of many motions of some bodies, as planners need it between configurations.

        All other bodies move as they were told; afterwards `bodies` have the motions of before. Threads share the
        motions; each answer has the bits of `earliest` for that motion alone.

        Parameters
        ----------
        bodies : array_like of int, shape (b,)
            The numbers of the bodies, each once; b >= 1.
        motions : array_like, shape (n, b, links, 4, 3)
            For each motion a chain for each of `bodies`, as in `add`.
        min_separation, at_start, tolerance
            As in `contacts`.

        Returns
        -------
        EarliestMany
            Motion i is free before `toi_lower[i]`, proven.

        Raises
        ------
        InvalidOptions
            No body is named, the world has no such body, or one is named twice; or an option outside its range.
        InvalidPath
            `motions` has another shape, or numbers that are not finite.
        InvalidStep
            A body turns too far, as in `add`; with ``at_start="fail"``, a pair touches at t=0.
        """
        named = numbers_of(bodies)
        asked = path_options(min_separation, at_start, tolerance)
        lower, upper, touching, rows = self._world.earliest_many(named, chains_of_each(motions, named), asked)
        return EarliestMany(lower, upper, touching, BodyContacts(rows))

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
            As in `contacts`.

        Returns
        -------
        bool
            True is a proof. If a body turns, False may be due to a contact that is not certified.
        """
        return self._world.is_free(path_options(min_separation, at_start, tolerance))

    def safe_step(
        self,
        keep: float = 0.1,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
        tolerance: float | None = None,
    ) -> BodyStep:
        """Find how far all bodies may go while every pair keeps a fraction of its distance.

        Parameters
        ----------
        keep, min_separation, at_start
            As in `Detector.safe_step`.
        tolerance : float, optional
            As in `contacts`.

        Returns
        -------
        BodyStep
            On [0, toi_lower] every pair keeps the fraction, proven. If one of two bodies turns, a pair that starts
            nearer to its separation than doubles can tell ends the step at once.

        Raises
        ------
        InvalidOptions
            An option outside its range.
        InvalidStep
            With ``at_start="fail"``, if a pair touches at t=0.
        """
        asked = path_options(min_separation, at_start, tolerance)
        return BodyStep(*bracket_of(self._world.safe_step(number(keep, "keep"), asked), BodyNearPairs))

    def pairs_within(self, distance: float, *, include_static: bool = False) -> BodyNearPairs:
        """Find every pair of features that are near each other at t=0.

        Parameters
        ----------
        distance : float
            >= 0, in the unit of the points: pairs at most this far apart count. Both radii are added to it.
        include_static : bool
            Also test two bodies that both stay at a pose. Set it once, before the first step. By default they are
            skipped, even where they pass through each other.

        Returns
        -------
        BodyNearPairs
            Each pair once, sorted by kind, then bodies and vertices.

        Raises
        ------
        InvalidOptions
            The distance is negative or not finite.
        """
        reach, with_static = number(distance, "distance"), truth(include_static, "include_static")
        return BodyNearPairs(self._world.pairs_within(reach, with_static))

    def intersections(self, *, include_static: bool = False) -> BodyIntersections:
        """Find every edge that passes through a triangle or touches it at t=0. Decided exactly.

        Parameters
        ----------
        include_static : bool
            As in `pairs_within`.

        Returns
        -------
        BodyIntersections
            Sorted by bodies, edge and face.
        """
        return BodyIntersections(self._world.intersections(truth(include_static, "include_static")))

    def has_intersection(self, *, include_static: bool = False) -> bool:
        """Tell whether any edge passes through a triangle or touches it at t=0.

        Decided exactly; ends at the first intersection.

        Parameters
        ----------
        include_static : bool
            As in `pairs_within`.

        Returns
        -------
        bool
            Whether `intersections` has a row.
        """
        return self._world.has_intersection(truth(include_static, "include_static"))

    def points_at(self, body: int, time: float) -> tuple[Doubles, float]:
        """Compute where the vertices of a body are at `time`, on the curves that questions are about.

        Parameters
        ----------
        body : int
            The number that `add` returned.
        time : float
            In [0, 1], such as the time of a contact.

        Returns
        -------
        points : array of float64, shape (n, 3)
            One row a vertex of its shape, in the world's frame.
        error : float
            No coordinate of a vertex in `Mesh.points` is off by more than this, in the unit of the points. 0: they are
            exact.

        Raises
        ------
        InvalidOptions
            The world has no such body, or the time is outside [0, 1].
        """
        return self._world.points_at(whole(body, "body"), number(time, "time"))
