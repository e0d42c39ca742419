"""Robots: a tree of joints, the links that they carry, and the motions from configuration to configuration."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles, Indices, doubles, finite, numbers, shape_text
from tamis._checks import number, number_from_zero, word
from tamis._errors import FileError, InvalidOptions, InvalidPath
from tamis._world._bodies import Shape
from tamis.robots._frames import frame_of, moved, placed, pose_of_frame
from tamis.robots._solids import MeshFiles, link_triangles, shape_of, welded
from tamis.robots._srdf import disabled_pairs
from tamis.robots._urdf import FileJoint, RobotFile, read_urdf

_BEYOND = 1e-9  # how far a value may be beyond a limit: planners round


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

    __slots__ = ("_indices", "_joints", "_links", "_never", "is_continuous", "joints", "limits", "name")

    def __init__(
        self,
        name: str,
        joints: tuple[str, ...],
        limits: Doubles,
        is_continuous: npt.NDArray[np.bool_],
        tree: tuple[list[Joint], list[Link], set[frozenset[str]]],
    ) -> None:
        self.name = name
        self.joints = joints
        self.limits = limits
        self.is_continuous = is_continuous
        self._joints, self._links, self._never = tree
        self._indices = _padded([_carriers(self._joints, link.joint) for link in self._solid], len(self._joints))

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
        first, last = self._configurations(start, "start"), self._configurations(end, "end")
        if first.shape != last.shape:
            raise InvalidPath(f"start has the shape {shape_text(first)}, end {shape_text(last)}: give the same")
        if not whole_turns:
            self._refuse_long_turns(first, last)
        ways = np.zeros((*first.shape[:-1], len(self._joints) + 1, 4, 3))
        for i, joint in enumerate(self._joints):
            carrier = self._joints[joint.parent].center if joint.parent >= 0 else np.zeros(3)
            ways[..., i, ::2, :] = joint.center - carrier
            for side, configuration in ((0, first), (2, last)):
                value = joint.factor * configuration[..., joint.coordinate] + joint.offset
                ways[..., i, side + joint.turns, :] += value[..., np.newaxis] * joint.axis
        return doubles(ways[..., self._indices, :, :])

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
        first, last = self._configurations(start, "start"), self._configurations(end, "end").copy()
        turns = np.round((last - first) / (2 * np.pi))
        last -= np.where(self.is_continuous, turns * 2 * np.pi, 0.0)
        return last

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
        named, values = self._link(link), self._configurations(configuration, "configuration")
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
            raise InvalidOptions(f"name is {name!r}, which {self.name} has already: give another")
        frame = carrier.frame @ frame_of(pose)
        given = shape_of(body, "body")
        shape = Shape(given.mesh, moved(given.points, frame) - _center(self._joints, carrier.joint))
        new = Link(name, carrier.joint, frame, carrier.rests_on, shape)
        fixed = [other.name for other in self._links if other.rests_on == carrier.rests_on]
        pairs = {frozenset((name, self._link(other).name)) for other in (*fixed, *touching)}
        tree = (self._joints, [*self._links, new], self._never | pairs)
        return Robot(self.name, self.joints, self.limits, self.is_continuous, tree)

    def _link(self, name: str) -> Link:
        for link in self._links:
            if link.name == name:
                return link
        raise InvalidOptions(f"{self.name} has no link {name!r}: it has {', '.join(link.name for link in self._links)}")

    def _configurations(self, given: npt.ArrayLike, name: str) -> Doubles:
        """Return configurations that are within the limits, with any number of leading dimensions up to one."""
        array = numbers(given, name, InvalidPath)
        if array.ndim not in (1, 2) or array.shape[-1] != len(self.joints):
            raise InvalidPath(
                f"{name} has the shape {shape_text(array)}: give a number for each of the {len(self.joints)} joints "
                f"({', '.join(self.joints)})"
            )
        values = finite(doubles(array), name, InvalidPath)
        beyond = (values < self.limits[:, 0] - _BEYOND) | (values > self.limits[:, 1] + _BEYOND)
        if beyond.any():
            place = tuple(np.argwhere(beyond)[0])
            low, high = self.limits[place[-1]]
            row = f"row {place[0]} of {name}" if values.ndim == 2 else name
            raise InvalidPath(
                f"joint {self.joints[place[-1]]!r} is at {values[place]:.6g} in {row}, beyond its limits "
                f"{low:g} to {high:g}: keep within them"
            )
        return values

    def _refuse_long_turns(self, first: Doubles, last: Doubles) -> None:
        long = self.is_continuous & (np.abs(last - first) > np.pi + _BEYOND)
        if long.any():
            place = tuple(np.argwhere(long)[0])
            raise InvalidPath(
                f"the continuous joint {self.joints[place[-1]]!r} goes from {first[place]:.6g} to {last[place]:.6g}, "
                "by more than half a turn: pass shorter_way(start, end) as the end, or whole_turns=True if it shall"
            )

    def __repr__(self) -> str:
        return f"Robot({self.name!r}, {len(self.joints)} joints, {len(self.links)} links with shapes)"


def load(
    file: str | os.PathLike[str],
    *,
    srdf: str | os.PathLike[str] | None = None,
    disabled: Iterable[tuple[str, str]] = (),
    held: Mapping[str, float] | None = None,
    base: npt.ArrayLike | None = None,
    tolerance: float = 1e-3,
    package_dirs: Iterable[str | os.PathLike[str]] = (),
    name: str | None = None,
) -> Robot:
    """Read a robot from its URDF file. Needs the package trimesh where the file names meshes.

    Each <collision> becomes triangles: meshes as they are, scaled and if need be mirrored; boxes, cylinders, capsules
    and spheres by triangles around them. What cannot be understood is refused. A joint that mimics another one follows
    it, whatever its own limits are.

    Parameters
    ----------
    file : path
        The URDF file.
    srdf : path, optional
        An SRDF file: the pairs of its <disable_collisions> never count.
    disabled : iterable of pairs of str
        More pairs of links that never count.
    held : mapping of str to float, optional
        Joints that stay at a value, such as a gripper's. They are no longer among the robot's `joints`.
    base : array_like, shape (2, 3) or (4, 4), optional
        Where the root link is, as `tamis.pose_of` makes it, or a matrix. By default it is at the origin.
    tolerance : float
        > 0, in metres: how far triangles may be outside a round primitive. They are nowhere inside.
    package_dirs : iterable of paths
        Folders that hold the packages of ``package://`` names. The folders around the file are searched after them.
    name : str, optional
        The robot's name instead of the file's: two robots in one scene need two.

    Returns
    -------
    Robot
        The robot.

    Raises
    ------
    FileError
        A file that is missing, or says something that cannot be used. The message names the link or joint.
    InvalidOptions
        A joint or link that the robot lacks, a value beyond its limits, or a tolerance that is not positive.
    """
    if number_from_zero(tolerance, "tolerance") == 0:
        raise InvalidOptions("tolerance is 0: give a length > 0, such as 1e-3")
    read = read_urdf(file)
    values = _held(read, held or {})
    joints, links = _place(read, values, frame_of(base))
    files = MeshFiles(os.fspath(file), package_dirs)
    solid: list[Link] = []
    for link in links:
        triangles = link_triangles(read.links[link.name], files, tolerance)
        if triangles is not None:
            points = moved(triangles[0], link.frame) - _center(joints, link.joint)
            link = replace(link, shape=welded((points, triangles[1])))
        solid.append(link)
    if not any(link.shape for link in solid):
        raise FileError(f"{os.fspath(file)}: no link has a <collision>, so nothing could touch: add them")
    named = [] if srdf is None else disabled_pairs(srdf, read.links)
    never = _connected(read, solid) | {frozenset(pair) for pair in named}
    for pair in disabled:
        for link_name in pair:
            if link_name not in read.links:
                raise InvalidOptions(f"disabled names the link {link_name!r}, which {read.name} has not")
        never.add(frozenset(pair))
    leaders = [joint for joint in read.joints if _is_free(joint, values)]
    names = tuple(joint.name for joint in leaders)
    continuous = np.array([joint.is_continuous for joint in leaders], bool)
    called = read.name if name is None else word(name, "name")
    limits = np.array([(joint.lower, joint.upper) for joint in leaders], float).reshape(-1, 2)
    return Robot(called, names, limits, continuous, (joints, solid, never))


def _is_free(joint: FileJoint, values: Mapping[str, float]) -> bool:
    return joint.kind != "fixed" and not joint.mimics and joint.name not in values


def _held(read: RobotFile, held: Mapping[str, float]) -> dict[str, float]:
    """Return the values of all joints that do not move: those held, and those that mimic them."""
    moving = {joint.name: joint for joint in read.joints if joint.kind != "fixed"}
    values: dict[str, float] = {}
    for name, given in held.items():
        joint = moving.get(name)
        if joint is None or joint.mimics:
            free = ", ".join(j.name for j in moving.values() if not j.mimics)
            raise InvalidOptions(f"held names the joint {name!r}: give joints that move by themselves ({free})")
        value = number(given, f"held[{name!r}]")
        if not joint.lower <= value <= joint.upper:
            raise InvalidOptions(
                f"held[{name!r}] is {value:g}, beyond its limits {joint.lower:g} to {joint.upper:g}: keep within them"
            )
        values[name] = value
    return {**values, **{j.name: j.factor * values[j.mimics] + j.offset for j in moving.values() if j.mimics in values}}


def _place(read: RobotFile, values: Mapping[str, float], base: Doubles) -> tuple[list[Joint], list[Link]]:
    """Return joints that move, and links, where they are when every joint is at 0; held joints are at their value."""
    coordinate: dict[str, int] = {}
    for file_joint in read.joints:
        if _is_free(file_joint, values):
            coordinate[file_joint.name] = len(coordinate)
    joints: list[Joint] = []
    links = {read.root: Link(read.root, -1, base, read.root, None)}
    for file_joint in read.joints:
        parent = links[file_joint.parent]
        frame, carrier, rests_on = parent.frame @ file_joint.place, parent.joint, parent.rests_on
        leader = file_joint.mimics or file_joint.name
        if leader in coordinate:
            axis = frame[:3, :3] @ file_joint.axis
            turns, factor, offset = file_joint.kind == "turning", file_joint.factor, file_joint.offset
            joints.append(
                Joint(file_joint.name, turns, carrier, frame[:3, 3], axis, coordinate[leader], factor, offset)
            )
            carrier, rests_on = len(joints) - 1, file_joint.child
        elif file_joint.kind != "fixed":
            way = file_joint.axis * values[file_joint.name]
            turns = file_joint.kind == "turning"
            frame = frame @ (placed(way, np.zeros(3)) if turns else placed(np.eye(3), way))
        links[file_joint.child] = Link(file_joint.child, carrier, frame, rests_on, None)
    return joints, list(links.values())


def _connected(read: RobotFile, links: list[Link]) -> set[frozenset[str]]:
    """Return the pairs that never count: fixed to each other, or joined, also by links that have no shape."""
    by_name = {link.name: link for link in links}
    pairs = {frozenset((a.name, b.name)) for a in links for b in links if a is not b and a.rests_on == b.rests_on}
    nearest: dict[str, set[str]] = {name: set() for name in by_name}  # the first links with a shape towards the root
    for joint in read.joints:
        parent = by_name[joint.parent]
        nearest[joint.child] = {parent.name} if parent.shape else nearest[parent.name]
        pairs |= {frozenset((joint.child, other)) for other in nearest[joint.child]}
    return pairs


def _carriers(joints: list[Joint], last: int) -> list[int]:
    """Return the joints that carry a link, from the base to `last`."""
    found: list[int] = []
    while last >= 0:
        found.append(last)
        last = joints[last].parent
    return found[::-1]


def _center(joints: list[Joint], joint: int) -> Doubles:
    return joints[joint].center if joint >= 0 else np.zeros(3)


def _padded(lists: list[list[int]], filler: int) -> Indices:
    """Return lists of one length as rows: the link number `filler` of a chain does nothing."""
    longest = max((len(entries) for entries in lists), default=0)
    return np.array([entries + [filler] * (longest - len(entries)) for entries in lists], np.int32).reshape(
        len(lists), longest
    )
