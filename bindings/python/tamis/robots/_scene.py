"""Scenes: robots among obstacles, and the questions of planners about configurations and edges."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles, doubles
from tamis._checks import instance, truth, word
from tamis._errors import InvalidOptions, InvalidPath, InvalidStep
from tamis._world._bodies import Deforming
from tamis._world._world import World
from tamis.robots._edges import Edges, TrajectoryAnswer, ask_edges, overlaps
from tamis.robots._robot import Robot
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
        No robot, or two robots of one name; an option outside its range.
    """

    __slots__ = ("_bodies", "_names", "_separation", "is_continuous", "joints", "limits", "robots", "world")

    def __init__(self, *robots: Robot, threads: int = 0, min_separation: float = 0.0) -> None:
        names = [instance(robot, Robot, "robots", "robots, as tamis.robots.load returns them").name for robot in robots]
        if not robots or len(set(names)) < len(names):
            raise InvalidOptions(
                f"robots are called {', '.join(names) or 'nothing'}: give one or more, each another name"
            )
        self.robots = robots
        self._separation = min_separation
        self.world = World(threads=threads, min_separation=min_separation)
        self._names: dict[int, str] = {}
        self._bodies: list[Any] = []
        several = len(robots) > 1
        for robot in robots:
            self._bodies += self._add_robot(robot, f"{robot.name}/" if several else "")
        self.joints = tuple(f"{r.name}/{joint}" if several else joint for r in robots for joint in r.joints)
        self.limits = np.vstack([robot.limits for robot in robots])
        self.is_continuous = np.concatenate([robot.is_continuous for robot in robots])
        home = np.clip(0.0, self.limits[:, 0], self.limits[:, 1])  # until a question moves them
        self.world.move_many(self._bodies, self.chain(home, home))

    def _add_robot(self, robot: Robot, prefix: str) -> list[int]:
        bodies = {name: self.world.add(shape, _STILL) for name, shape in zip(robot.links, robot.shapes)}
        self._names.update({body: prefix + name for name, body in bodies.items()})
        pairs = [(bodies[a], bodies[b]) for a, b in robot.ignored_pairs]
        if pairs:
            self.world.set_may_touch(pairs, False)
        return list(bodies.values())

    @property
    def dimension(self) -> int:
        """How many numbers a configuration has."""
        return len(self.joints)

    @property
    def open_bodies(self) -> list[str]:
        """The links and obstacles whose surface is not closed: nothing counts as inside them."""
        return [name for body, name in self._names.items() if not self.world.is_closed(body)]

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
        number = self.world.add(shape_of(body, "body"), motion)
        self._names[number] = name
        return number

    def ignore(self, pairs: Iterable[tuple[str, str]]) -> None:
        """Let pairs of links and obstacles never count, such as a robot's foot and the floor it stands on.

        Parameters
        ----------
        pairs : iterable of pairs of str
            Names of links and obstacles.

        Raises
        ------
        InvalidOptions
            There is no such link or obstacle.
        """
        self.world.set_may_touch([[self._body(name) for name in pair] for pair in pairs], False)

    def _body(self, name: str) -> int:
        for body, known in self._names.items():
            if known == name:
                return body
        raise InvalidOptions(f"the scene has no {name!r}: it has {', '.join(self._names.values())}")

    def chain(self, start: npt.ArrayLike, end: npt.ArrayLike, *, whole_turns: bool = False) -> Doubles:
        """Make the motions of all robots from one configuration to another, as `Robot.chain` does for one.

        Parameters
        ----------
        start, end : array_like, shape (d,) or (n, d)
            Configurations.
        whole_turns : bool
            As in `Robot.chain`.

        Returns
        -------
        array of float64, shape (b, links, 4, 3) or (n, b, links, 4, 3)
            A chain for each body of a robot.

        Raises
        ------
        InvalidPath
            As `Robot.chain`.
        """
        starts, ends = self._parted(start, "start"), self._parted(end, "end")
        whole = truth(whole_turns, "whole_turns")
        chains = [r.chain(a, b, whole_turns=whole) for r, a, b in zip(self.robots, starts, ends)]
        longest = max(chain.shape[-3] for chain in chains)
        padding = [(0, 0)] * (chains[0].ndim - 3)
        filled = [np.pad(c, [*padding, (0, longest - c.shape[-3]), (0, 0), (0, 0)]) for c in chains]
        return doubles(np.concatenate(filled, -4))

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
        """
        parts = zip(self.robots, self._parted(start, "start"), self._parted(end, "end"))
        return np.concatenate([robot.shorter_way(a, b) for robot, a, b in parts], -1)

    def _parted(self, given: npt.ArrayLike, name: str) -> list[Doubles]:
        array = np.asarray(given)
        if array.ndim not in (1, 2) or array.shape[-1] != self.dimension:
            raise InvalidPath(
                f"{name} has the shape {array.shape}: give a number for each of the {self.dimension} joints "
                f"({', '.join(self.joints)})"
            )
        return np.split(array, np.cumsum([len(robot.joints) for robot in self.robots])[:-1], -1)

    def is_valid(self, configurations: npt.ArrayLike) -> Any:
        """Tell whether nothing overlaps at configurations; inside counts, and so does the scene's separation.

        Parameters
        ----------
        configurations : array_like, shape (d,) or (n, d)
            Configurations. Obstacles are where they are at t=0.

        Returns
        -------
        bool, or array of bool, shape (n,)
            True: no link overlaps another body.

        Raises
        ------
        InvalidPath
            As `chain`.
        """
        chains = self.chain(configurations, configurations)
        if chains.ndim == 4:
            return not overlaps(self.world, self._bodies, chains, self._separation)
        return np.array([not overlaps(self.world, self._bodies, chain, self._separation) for chain in chains], bool)

    def is_free(
        self, start: npt.ArrayLike, end: npt.ArrayLike, *, starts_are_valid: bool = False, whole_turns: bool = False
    ) -> Any:
        """Tell whether edges are free of contacts.

        Parameters
        ----------
        start, end : array_like, shape (d,) or (n, d)
            The configurations that each edge joins.
        starts_are_valid : bool
            True skips `is_valid` of the starts, for planners that have called it.
        whole_turns : bool
            As in `Robot.chain`.

        Returns
        -------
        bool, or array of bool, shape (n,)
            True is a proof: nothing touches and nothing overlaps at any time of the edge.

        Raises
        ------
        InvalidPath
            As `chain`.
        """
        found = self.last_valid(start, end, starts_are_valid=starts_are_valid, whole_turns=whole_turns)
        return bool(found.is_free[0]) if np.ndim(start) == 1 else found.is_free

    def last_valid(
        self, start: npt.ArrayLike, end: npt.ArrayLike, *, starts_are_valid: bool = False, whole_turns: bool = False
    ) -> Edges:
        """Find how far along edges nothing touches, and what touches then.

        Parameters
        ----------
        start, end, starts_are_valid, whole_turns
            As in `is_free`.

        Returns
        -------
        Edges
            Edge i is free before `fraction[i]`, proven.

        Raises
        ------
        InvalidPath
            As `chain`.
        """
        chains = self.chain(start, end, whole_turns=whole_turns)
        many = chains if chains.ndim == 5 else chains[np.newaxis]
        skip = truth(starts_are_valid, "starts_are_valid")
        return ask_edges(self.world, self._bodies, many, self._names, skip)

    def first_bad_edge(self, waypoints: npt.ArrayLike, *, whole_turns: bool = False) -> TrajectoryAnswer:
        """Find the first edge of a trajectory that is not free.

        Parameters
        ----------
        waypoints : array_like, shape (n, d)
            Configurations; n >= 2.
        whole_turns : bool
            As in `Robot.chain`.

        Returns
        -------
        TrajectoryAnswer
            Whether all edges are free; else the first that is not, how far it is free, and what touches.

        Raises
        ------
        InvalidPath
            As `chain`.
        """
        ways = np.asarray(waypoints)
        if ways.ndim != 2 or len(ways) < 2:
            raise InvalidPath(f"waypoints has the shape {ways.shape}: give two configurations or more, (n, d)")
        edges = self.last_valid(ways[:-1], ways[1:], whole_turns=whole_turns)
        bad = np.flatnonzero(~edges.is_free)
        if not len(bad):
            return TrajectoryAnswer(True, None, 1.0, None, None)
        first = int(bad[0])
        point = edges.points[first]
        return TrajectoryAnswer(False, first, float(edges.fraction[first]), edges.pairs[first], point)

    def overlapping(self, configuration: npt.ArrayLike) -> list[tuple[str, str]]:
        """Find all pairs of bodies that overlap at a configuration.

        Parameters
        ----------
        configuration : array_like, shape (d,)
            One configuration.

        Returns
        -------
        list of pairs of str
            Their names; empty if the configuration is valid.

        Raises
        ------
        InvalidPath
            As `chain`.
        """
        self.world.move_many(self._bodies, self.chain(configuration, configuration))
        rows = self.world.intersections()
        found = {tuple(sorted(pair)) for pair in rows.bodies.tolist()}
        if not found and self.world.has_overlap():  # one is inside the other: ask two at a time
            found = {pair for pair in self._pairs() if self._overlap_alone(pair)}
        return [(self._names[a], self._names[b]) for a, b in sorted(found)]

    def _pairs(self) -> list[tuple[int, int]]:
        return [(a, b) for a in self._bodies for b in self._names if a < b or b not in self._bodies]

    def _overlap_alone(self, pair: tuple[int, int]) -> bool:
        everything = list(self._names)
        self.world.set_enabled(everything, False)
        self.world.set_enabled(pair, True)
        found = self.world.has_overlap()
        self.world.set_enabled(everything, True)
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
            As `chain`.
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
            f"Scene({', '.join(robot.name for robot in self.robots)}, {self.dimension} joints, {obstacles} obstacles)"
        )
