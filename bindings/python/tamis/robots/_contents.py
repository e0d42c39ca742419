"""What a scene has: robots, obstacles, and which pairs may overlap."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles
from tamis._checks import instance, word
from tamis._errors import InvalidOptions
from tamis._world._bodies import Deforming
from tamis._world._linkage import Linkage
from tamis._world._world import World
from tamis.robots._coordinates import Coordinates
from tamis.robots._edges import Flags
from tamis.robots._robot import Robot, linkage_of
from tamis.robots._solids import shape_of

_STILL = np.zeros((2, 3))


class Contents:
    """The robots and obstacles of a `Scene`."""

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

    def _named(self, pair: Any) -> tuple[str, str] | None:
        first, second = pair
        return None if first < 0 else (self._names[first], self._names[second])

    def __repr__(self) -> str:
        obstacles = len(self._names) - len(self._bodies)
        return (
            f"Scene({', '.join(robot.name for robot in self.robots)}, {len(self.joints)} joints, {obstacles} obstacles)"
        )
