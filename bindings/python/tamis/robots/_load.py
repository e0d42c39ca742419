"""`load`: makes a robot of its files."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from dataclasses import replace

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles
from tamis._checks import number, number_from_zero, word
from tamis._errors import FileError, InvalidOptions
from tamis.robots._coordinates import Coordinates
from tamis.robots._frames import frame_of, moved, placed
from tamis.robots._robot import Joint, Link, Robot, center_of
from tamis.robots._solids import MeshFiles, link_triangles, welded
from tamis.robots._srdf import disabled_pairs
from tamis.robots._urdf import FileJoint, RobotFile, read_urdf


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
    disabled : iterable of tuple of two str
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
            points = moved(triangles[0], link.frame) - center_of(joints, link.joint)
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
    return Robot(called, Coordinates(names, limits, continuous), joints, solid, never)


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
