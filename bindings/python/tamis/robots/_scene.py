"""Scenes: robots among obstacles, and the questions of planners about configurations and edges."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles
from tamis._checks import instance, truth, word
from tamis._errors import InvalidOptions, InvalidStep
from tamis._world._bodies import Deforming
from tamis._world._edges import FreeRoadmap
from tamis._world._linkage import Linkage
from tamis._world._world import World
from tamis.robots._coordinates import Coordinates
from tamis.robots._edges import Edges, Flags, TrajectoryAnswer
from tamis.robots._robot import Robot, linkage_of
from tamis.robots._solids import shape_of

_STILL = np.zeros((2, 3))


class Scene:
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

    __slots__ = ("_bodies", "_coordinates", "_linkage", "_names", "_robots", "_world")

    def __init__(self, *robots: Robot, threads: int = 0, min_separation: float = 0.0) -> None:
        names = [instance(robot, Robot, "robots", "robots, as tamis.robots.load returns them").name for robot in robots]
        if not robots or len(set(names)) < len(names):
            raise InvalidOptions(
                f"robots are called {', '.join(names) or 'nothing'}: give one or more, each another name"
            )
        self._robots = robots
        self._world = World(threads=threads, min_separation=min_separation)
        self._names: dict[int, str] = {}
        self._bodies: list[int] = []
        several = len(robots) > 1
        for robot in robots:
            self._bodies += self._add_robot(robot, f"{robot.name}/" if several else "")
        self._linkage = linkage_of(list(robots), self._bodies)
        self._coordinates = Coordinates(
            tuple(f"{robot.name}/{joint}" if several else joint for robot in robots for joint in robot.joints),
            np.vstack([robot.limits for robot in robots]),
            np.concatenate([robot.is_continuous for robot in robots]),
        )
        home = np.clip(0.0, self.limits[:, 0], self.limits[:, 1])  # where the robots stay in `world`
        self._world.move_many(self._bodies, self._linkage.motions(home, home))

    def _add_robot(self, robot: Robot, prefix: str) -> list[int]:
        bodies = {name: self._world.add(shape, _STILL) for name, shape in zip(robot.links, robot.shapes)}
        self._names.update({body: prefix + name for name, body in bodies.items()})
        pairs = [(bodies[a], bodies[b]) for a, b in robot.ignored_pairs]
        if pairs:
            self._world.set_may_touch(pairs, False)
        return list(bodies.values())

    @property
    def robots(self) -> tuple[Robot, ...]:
        """The robots, as given."""
        return self._robots

    @property
    def world(self) -> World:
        """The world of the links and the obstacles."""
        return self._world

    @property
    def joints(self) -> tuple[str, ...]:
        """The names of the joints that a configuration moves; of several robots each after its robot's name."""
        return self._coordinates.names

    @property
    def limits(self) -> Doubles:
        """The least and the greatest value of each of `joints`, shape (d, 2)."""
        return self._coordinates.limits

    @property
    def is_continuous(self) -> Flags:
        """Whether each of `joints` turns without limits, shape (d,)."""
        return self._coordinates.is_continuous

    @property
    def linkage(self) -> Linkage:
        """The joints, with the links as bodies of `world`: for questions to `world` itself."""
        return self._linkage

    @property
    def open_bodies(self) -> list[str]:
        """The links and obstacles whose surface is not closed: nothing counts as inside them."""
        return [name for body, name in self._names.items() if not self._world.is_closed(body)]

    def add(self, name: str, body: Any, motion: npt.ArrayLike | Deforming | None = None) -> int:
        """Add an obstacle.

        Parameters
        ----------
        name : str
            A new name.
        body : tamis.Shape, or an object with `vertices` and `faces`, such as a trimesh.Trimesh
            The obstacle, in its own frame.
        motion : array_like or Deforming, optional
            A pose or a motion, as in `World.add`. By default it stays where its points are.

        Returns
        -------
        int
            The number of its body in `world`, for `World.move`, `set_enabled` and `set_radius`.

        Raises
        ------
        InvalidOptions
            The name is taken.
        InvalidMesh, InvalidPath, InvalidStep
            The body is not a mesh, or the motion is not valid.
        """
        if word(name, "name") in self._names.values():
            raise InvalidOptions(f"name is {name!r}, which the scene has already: give another")
        number = self._world.add(shape_of(body, "body"), motion)
        self._names[number] = name
        return number

    def ignore(self, pairs: Iterable[tuple[str, str]]) -> None:
        """Let pairs of links and obstacles never count, such as a robot's foot and the floor it stands on.

        Parameters
        ----------
        pairs : iterable of tuple of two str
            Names of links and obstacles.

        Raises
        ------
        InvalidOptions
            There is no such link or obstacle.
        """
        self._world.set_may_touch([[self._body(name) for name in pair] for pair in pairs], False)

    def _body(self, name: str) -> int:
        for body, known in self._names.items():
            if known == name:
                return body
        raise InvalidOptions(f"the scene has no {name!r}: it has {', '.join(self._names.values())}")

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

    def _named(self, pair: Any) -> tuple[str, str] | None:
        first, second = pair
        return None if first < 0 else (self._names[first], self._names[second])

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

    def __repr__(self) -> str:
        obstacles = len(self._names) - len(self._bodies)
        return (
            f"Scene({', '.join(robot.name for robot in self.robots)}, {len(self.joints)} joints, {obstacles} obstacles)"
        )
