"""Robots: a tree of joints, the links that they carry, and the motions from configuration to configuration."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles
from tamis._checks import word
from tamis._errors import InvalidOptions
from tamis._world._bodies import Shape
from tamis._world._linkage import JointKind, Linkage
from tamis.robots._coordinates import Coordinates
from tamis.robots._frames import frame_of, moved, placed, pose_of_frame
from tamis.robots._solids import shape_of


@dataclass(frozen=True)
class Joint:
    """A joint that moves: how, which joint carries it (-1: none), and which coordinate of a configuration it follows.

    All frames are parallel when every joint is at 0, so a joint's frame is its `center` there, and its `axis` is in the
    frame of the base.
    """

    name: str
    turns: bool
    parent: int
    center: Doubles
    axis: Doubles
    coordinate: int
    factor: float
    offset: float


@dataclass(frozen=True)
class Link:
    """A link: the joint that carries it (-1: none), its frame when every joint is at 0, and its shape if it has one.

    The points of the shape are relative to the joint's center. `rests_on` is the first link that it is fixed to.
    """

    name: str
    joint: int
    frame: Doubles
    rests_on: str
    shape: Shape | None


class Robot:
    """A robot: joints, and links with their collision shapes. `tamis.robots.load` makes one; it never changes.

    A configuration has one number for each of `joints`: radians, or metres of a joint that slides.
    """

    __slots__ = ("_coordinates", "_joints", "_linkage", "_links", "_name", "_never")

    def __init__(
        self, name: str, coordinates: Coordinates, joints: list[Joint], links: list[Link], never: set[frozenset[str]]
    ) -> None:
        self._name = name
        self._coordinates = coordinates
        self._joints, self._links, self._never = joints, links, never
        self._linkage = linkage_of([self], list(range(len(self.links))))

    @property
    def name(self) -> str:
        """The robot's name in its file."""
        return self._name

    @property
    def joints(self) -> tuple[str, ...]:
        """The names of the joints that a configuration moves."""
        return self._coordinates.names

    @property
    def limits(self) -> Doubles:
        """The least and the greatest value of each of `joints`, shape (d, 2)."""
        return self._coordinates.limits

    @property
    def is_continuous(self) -> npt.NDArray[np.bool_]:
        """Whether each of `joints` turns without limits, shape (d,)."""
        return self._coordinates.is_continuous

    @property
    def _solid(self) -> list[Link]:
        return [link for link in self._links if link.shape]

    @property
    def links(self) -> tuple[str, ...]:
        """The names of the links that have a collision shape."""
        return tuple(link.name for link in self._solid)

    @property
    def shapes(self) -> list[Shape]:
        """The shape of each of `links`, in the frame of its motion."""
        return [link.shape for link in self._solid if link.shape]

    @property
    def ignored_pairs(self) -> list[tuple[str, str]]:
        """The pairs of `links` that never count.

        A joint connects them, they are fixed to each other, or the SRDF file or `disabled` names them.
        """
        names = self.links
        return [(a, b) for i, b in enumerate(names) for a in names[:i] if frozenset((a, b)) in self._never]

    def chain(self, start: npt.ArrayLike, end: npt.ArrayLike, *, whole_turns: bool = False) -> Doubles:
        """Make the motions from one configuration to another: each joint goes at constant speed, as planners have it.

        Parameters
        ----------
        start, end : array_like, shape (d,) or (n, d)
            Configurations, one number for each of `joints`.
        whole_turns : bool
            True lets continuous joints go by more than half a turn. By default that is refused, because planners take
            the shorter way: `shorter_way` returns its end.

        Returns
        -------
        array of float64, shape (b, links, 4, 3) or (n, b, links, 4, 3)
            A chain for each of `links`, as `World.earliest_many` and `World.move_many` take them.

        Raises
        ------
        InvalidPath
            Other shapes, numbers that are not finite, a joint beyond its limits, or a continuous joint that goes by
            more than half a turn. The message names the joint.
        """
        return self._linkage.motions(*self._coordinates.edges(start, end, whole_turns))

    def shorter_way(self, start: npt.ArrayLike, end: npt.ArrayLike) -> Doubles:
        """Return `end` with continuous joints moved by whole turns, so that each goes the shorter way from `start`.

        Parameters
        ----------
        start, end : array_like, shape (d,) or (n, d)
            Configurations.

        Returns
        -------
        array of float64, shape (d,) or (n, d)
            The end to give to `chain`.

        Raises
        ------
        InvalidPath
            As `chain`.
        """
        return self._coordinates.shorter_way(start, end)

    def pose(self, link: str, configuration: npt.ArrayLike) -> Doubles:
        """Compute the pose of a link's frame, as the URDF file has it.

        Parameters
        ----------
        link : str
            The name of a link, also of one without a shape.
        configuration : array_like, shape (d,)
            One number for each of `joints`.

        Returns
        -------
        array of float64, shape (2, 3)
            Position and rotation vector.

        Raises
        ------
        InvalidOptions
            There is no such link.
        InvalidPath
            As `chain`.
        """
        named, values = self._link(link), self._coordinates.one(configuration, "configuration")
        frame = np.eye(4)
        last = np.zeros(3)
        for i in _carriers(self._joints, named.joint):
            joint = self._joints[i]
            way = joint.axis * (joint.factor * values[joint.coordinate] + joint.offset)
            shift = joint.center - last
            frame = frame @ (placed(way, shift) if joint.turns else placed(np.eye(3), shift + way))
            last = joint.center
        return pose_of_frame(frame @ placed(np.eye(3), -last) @ named.frame)

    def attach(
        self, name: str, body: Any, link: str, pose: npt.ArrayLike | None = None, *, touching: Iterable[str] = ()
    ) -> Robot:
        """Return this robot with an object that moves with a link, such as a load in a hand.

        Parameters
        ----------
        name : str
            A new name; the object is one of `links` then.
        body : tamis.Shape, or an object with `vertices` and `faces`, such as a trimesh.Trimesh
            The object, in its own frame.
        link : str
            The link that carries it. Contacts with this link, and with links that are fixed to it, never count.
        pose : array_like, shape (2, 3) or (4, 4), optional
            Where the object's frame is in the link's frame. By default the frames are one.
        touching : iterable of str
            Other links whose contacts with it never count, as fingers that hold it.

        Returns
        -------
        Robot
            A new one.

        Raises
        ------
        InvalidOptions
            There is no such link, or the name is taken.
        InvalidMesh, InvalidPath
            The body is not a mesh, or the pose is not valid.
        """
        carrier = self._link(link)
        if any(word(name, "name") == other.name for other in self._links):
            raise InvalidOptions(f"name is {name!r}, which {self._name} has already: give another")
        frame = carrier.frame @ frame_of(pose)
        given = shape_of(body, "body")
        shape = Shape(given.mesh, moved(given.points, frame) - center_of(self._joints, carrier.joint))
        new = Link(name, carrier.joint, frame, carrier.rests_on, shape)
        fixed = [other.name for other in self._links if other.rests_on == carrier.rests_on]
        pairs = {frozenset((name, self._link(other).name)) for other in (*fixed, *touching)}
        return Robot(self._name, self._coordinates, self._joints, [*self._links, new], self._never | pairs)

    def _link(self, name: str) -> Link:
        for link in self._links:
            if link.name == name:
                return link
        raise InvalidOptions(f"{self.name} has no link {name!r}: it has {', '.join(link.name for link in self._links)}")

    def __repr__(self) -> str:
        return f"Robot({self._name!r}, {len(self.joints)} joints, {len(self.links)} links with shapes)"


def linkage_of(robots: list[Robot], bodies: list[int]) -> Linkage:
    """Return the linkage of some robots, whose links with a shape are `bodies`, robot after robot.

    All frames are parallel at 0, so places only shift, and a chain has no link but its joints.
    """
    parents, places, axes, coordinates = [-1], [np.zeros(3)], [np.ones(3)], [-1]
    kinds: list[JointKind] = ["fixed"]
    factors, offsets, carriers, dimension = [1.0], [0.0], [], 0
    for robot in robots:
        before = len(parents)
        for joint in robot._joints:
            parents.append(before + joint.parent if joint.parent >= 0 else 0)
            places.append(joint.center - center_of(robot._joints, joint.parent))
            kinds.append("turning" if joint.turns else "sliding")
            axes.append(joint.axis)
            coordinates.append(dimension + joint.coordinate)
            factors.append(joint.factor)
            offsets.append(joint.offset)
        carriers += [before + link.joint if link.joint >= 0 else 0 for link in robot._solid]
        dimension += len(robot.joints)
    poses = np.stack([np.array(places), np.zeros((len(places), 3))], 1)
    return Linkage(
        parents, poses, kinds, np.array(axes), coordinates, bodies, carriers, factors=factors, offsets=offsets
    )


def _carriers(joints: list[Joint], last: int) -> list[int]:
    """Return the joints that carry a link, from the base to `last`."""
    found: list[int] = []
    while last >= 0:
        found.append(last)
        last = joints[last].parent
    return found[::-1]


def center_of(joints: list[Joint], joint: int) -> Doubles:
    """Return a joint's center, the origin for -1."""
    return joints[joint].center if joint >= 0 else np.zeros(3)
