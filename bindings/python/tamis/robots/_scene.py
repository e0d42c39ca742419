"""Scenes: robots among obstacles, and the questions of planners about configurations and edges."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles
from tamis._checks import truth
from tamis._errors import InvalidStep
from tamis._world._edges import FreeRoadmap
from tamis.robots._contents import Contents
from tamis.robots._edges import Edges, TrajectoryAnswer


class Scene(Contents):
    """Robots among obstacles. A configuration has the numbers of the first robot's joints, then of the next one's.

    An edge is the motion from one configuration to another in which each joint goes at constant speed. Obstacles that
    move do so during each edge.

    Parameters
    ----------
    robots : Robot
        One or more, with different names.
    threads : int
        As in `tamis.World`.
    min_separation : float
        As in `tamis.World`: free means farther apart than this along the whole edge.

    Raises
    ------
    InvalidOptions
        No robot, no joint that moves, or two robots of one name; an option outside its range.
    """

    __slots__ = ()

    def shorter_way(self, start: npt.ArrayLike, end: npt.ArrayLike) -> Doubles:
        """Return `end` with continuous joints moved by whole turns, as `Robot.shorter_way`.

        Parameters
        ----------
        start, end : array_like, shape (d,) or (n, d)
            Configurations.

        Returns
        -------
        array of float64, shape (d,) or (n, d)
            The end to give to the questions.

        Raises
        ------
        InvalidPath
            As `Robot.chain`.
        """
        return self._coordinates.shorter_way(start, end)

    def is_valid(self, configurations: npt.ArrayLike, *, min_separation: float | None = None) -> Any:
        """Tell whether nothing overlaps or touches at configurations. A link inside an obstacle overlaps it.

        Parameters
        ----------
        configurations : array_like, shape (d,) or (n, d)
            Configurations. Obstacles are where their motions begin.
        min_separation : float, optional
            As in `World.contacts`: valid means farther apart than this.

        Returns
        -------
        bool, or array of bool, shape (n,)
            True is a proof.

        Raises
        ------
        InvalidPath
            As `Robot.chain`.
        """
        given = self._coordinates.some(configurations, "configurations")
        found = self._world.configurations_are_free(self._linkage, np.atleast_2d(given), min_separation=min_separation)
        return found if given.ndim == 2 else bool(found[0])

    def is_free(
        self,
        start: npt.ArrayLike,
        end: npt.ArrayLike,
        *,
        starts_are_valid: bool = False,
        whole_turns: bool = False,
        min_separation: float | None = None,
    ) -> Any:
        """Tell whether edges are free: nothing overlaps at the start, and nothing touches at any time.

        Parameters
        ----------
        start, end : array_like, shape (d,) or (n, d)
            The configurations that each edge joins.
        starts_are_valid : bool
            True skips the test of the starts, for planners that have called `is_valid`.
        whole_turns : bool
            As in `Robot.chain`.
        min_separation : float, optional
            As in `World.contacts`: free means farther apart than this along the whole edge.

        Returns
        -------
        bool, or array of bool, shape (n,)
            True is a proof.

        Raises
        ------
        InvalidPath
            As `Robot.chain`.
        """
        first, last = self._coordinates.edges(start, end, whole_turns)
        known, ends = truth(starts_are_valid, "starts_are_valid"), (np.atleast_2d(first), np.atleast_2d(last))
        found = self._world.edges_are_free(self._linkage, *ends, known, min_separation=min_separation)
        return found if first.ndim == 2 else bool(found[0])

    def last_valid(
        self,
        start: npt.ArrayLike,
        end: npt.ArrayLike,
        *,
        starts_are_valid: bool = False,
        whole_turns: bool = False,
        min_separation: float | None = None,
    ) -> Edges:
        """Find how far along edges nothing touches, and what touches then.

        Parameters
        ----------
        start, end, starts_are_valid, whole_turns, min_separation
            As in `is_free`.

        Returns
        -------
        Edges
            Edge i is free before `fraction[i]`, proven. One edge given alone is edge 0.

        Raises
        ------
        InvalidPath
            As `Robot.chain`.
        """
        first, last = self._coordinates.edges(start, end, whole_turns)
        known, ends = truth(starts_are_valid, "starts_are_valid"), (np.atleast_2d(first), np.atleast_2d(last))
        found = self._world.last_valid(self._linkage, *ends, known, min_separation=min_separation)
        pairs = [self._named(pair) for pair in found.bodies.tolist()]
        return Edges(found.is_free, found.fraction, found.overlaps_at_start, pairs, found.points)

    def first_bad_edge(
        self, waypoints: npt.ArrayLike, *, whole_turns: bool = False, min_separation: float | None = None
    ) -> TrajectoryAnswer:
        """Find the first edge of a trajectory that is not free.

        Parameters
        ----------
        waypoints : array_like, shape (n, d)
            Configurations; n >= 2.
        whole_turns, min_separation
            As in `is_free`.

        Returns
        -------
        TrajectoryAnswer
            Whether all edges are free; else the first that is not, how far it is free, and what touches.

        Raises
        ------
        InvalidPath
            As `Robot.chain`.
        """
        ways = np.atleast_2d(self._coordinates.some(waypoints, "waypoints"))
        self._coordinates.edges(ways[:-1], ways[1:], whole_turns)
        found = self._world.first_bad_edge(self._linkage, ways, min_separation=min_separation)
        pair = None if found.bodies is None else self._named(found.bodies)
        return TrajectoryAnswer(found.is_free, found.edge, found.fraction, pair, found.point)

    def roadmap(
        self, configurations: npt.ArrayLike, edges: npt.ArrayLike, *, min_separation: float | None = None
    ) -> FreeRoadmap:
        """Tell what is free of a whole roadmap.

        Parameters
        ----------
        configurations : array_like, shape (n, d)
            The roadmap's configurations.
        edges : array_like of int, shape (e, 2)
            The numbers of two configurations each. Continuous joints go as their numbers say.
        min_separation : float, optional
            As in `is_free`.

        Returns
        -------
        FreeRoadmap
            `configurations_are_free` (n,) and `edges_are_free` (e,).

        Raises
        ------
        InvalidOptions
            An edge that names a configuration that is not there.
        InvalidPath
            As `Robot.chain`.
        """
        given = self._coordinates.some(configurations, "configurations")
        return self._world.roadmap(self._linkage, given, edges, min_separation=min_separation)

    def overlapping(self, configuration: npt.ArrayLike) -> list[tuple[str, str]]:
        """Find all pairs of bodies that overlap at a configuration.

        Parameters
        ----------
        configuration : array_like, shape (d,)
            One configuration.

        Returns
        -------
        list of tuple of two str
            Their names; empty if the configuration is valid.

        Raises
        ------
        InvalidPath
            As `Robot.chain`.
        """
        at = self._coordinates.one(configuration, "configuration")
        self._world.move_many(self._bodies, self._linkage.motions(at, at))
        rows = np.sort(self._world.intersections().bodies, 1)
        found = {(a, b) for a, b in rows.tolist() if a in self._bodies or b in self._bodies}
        if not found and not self.is_valid(at):  # one is inside the other: test two bodies at a time
            pairs = [(a, b) for a in self._bodies for b in self._names if a < b]
            found = {pair for pair in pairs if self._overlap_alone(pair)}
        return [(self._names[a], self._names[b]) for a, b in sorted(found)]

    def _overlap_alone(self, pair: tuple[int, int]) -> bool:
        everything = list(self._names)
        self._world.set_enabled(everything, False)
        self._world.set_enabled(pair, True)
        found = self._world.has_overlap()
        self._world.set_enabled(everything, True)
        return found

    def check(self, configuration: npt.ArrayLike) -> None:
        """Raise if anything overlaps at a configuration, such as a planner's first one.

        Parameters
        ----------
        configuration : array_like, shape (d,)
            One configuration.

        Raises
        ------
        InvalidStep
            Bodies overlap. The message names the first pair.
        InvalidPath
            As `Robot.chain`.
        """
        found = self.overlapping(configuration)
        if found:
            (a, b), more = found[0], len(found) - 1
            others = f", and {more} other pair{'s' * (more > 1)}" if more else ""
            raise InvalidStep(
                f"{a!r} and {b!r} overlap at this configuration{others}: move the robot, or let pairs that always "
                "overlap never count (srdf or disabled of tamis.robots.load, Scene.ignore)"
            )
