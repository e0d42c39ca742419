"""Reads the joints and links of a URDF file. What cannot be understood is refused by a sentence that names it."""

from __future__ import annotations

import os
import pathlib
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field

import numpy as np

from tamis._arrays import Doubles
from tamis._errors import FileError, InvalidPath
from tamis._paths._rigid_path import pose_of
from tamis.robots._frames import placed

KINDS = {"fixed": "fixed", "revolute": "turning", "continuous": "turning", "prismatic": "sliding"}
SHAPES = {"box": ("size",), "cylinder": ("radius", "length"), "capsule": ("radius", "length"), "sphere": ("radius",)}
_UNIT = 1e-3  # how far the length of an axis may be off 1: files round to three digits


@dataclass(frozen=True)
class Solid:
    """One <collision>: a mesh file or a primitive, at a place (4, 4) in its link's frame."""

    place: Doubles
    kind: str
    size: Doubles  # of a primitive its numbers, of a mesh its scale
    file: str = ""


@dataclass
class FileLink:
    """A link with its collision solids."""

    name: str
    solids: list[Solid] = field(default_factory=list)


@dataclass(frozen=True)
class FileJoint:
    """A joint. Its value is `factor` * value of the joint `mimics` + `offset`, or its own if `mimics` is empty."""

    name: str
    kind: str
    is_continuous: bool
    parent: str
    child: str
    place: Doubles
    axis: Doubles
    lower: float
    upper: float
    mimics: str = ""
    factor: float = 1.0
    offset: float = 0.0


@dataclass(frozen=True)
class RobotFile:
    """Motion and collision of a URDF file. Joints stand after the joints that carry them."""

    name: str
    root: str
    links: dict[str, FileLink]
    joints: list[FileJoint]


class Element:
    """An XML element, and the words that say in errors where it is."""

    def __init__(self, element: ElementTree.Element, file: str, where: str) -> None:
        self.element, self.file, self.where = element, file, where

    def fail(self, fault: str) -> FileError:
        """Return an error about this element."""
        return FileError(f"{self.file}: {self.where} {fault}")

    def child(self, tag: str) -> Element | None:
        """Return the only child with a tag, or None."""
        found = self.element.findall(tag)
        if len(found) > 1:
            raise self.fail(f"has {len(found)} elements <{tag}>: leave one")
        return Element(found[0], self.file, self.where) if found else None

    def needed(self, tag: str) -> Element:
        """Return the only child with a tag."""
        child = self.child(tag)
        if child is None:
            raise self.fail(f"has no <{tag}>: add it")
        return child

    def word(self, name: str) -> str:
        """Return an attribute that must be there."""
        text = self.element.get(name)
        if not text:
            raise self.fail(f"has no {name} in <{self.element.tag}>: add it")
        return text

    def numbers(self, name: str, count: tuple[int, ...], default: tuple[float, ...] | None = None) -> Doubles:
        """Return the numbers of an attribute; blanks or commas part them."""
        text = self.element.get(name)
        if text is None and default is not None:
            return np.array(default, float)
        parts = self.word(name).replace(",", " ").split()
        try:
            numbers = np.array([float(part) for part in parts])
        except ValueError:
            numbers = np.empty(0)
        if len(numbers) not in count or not np.isfinite(numbers).all():
            wanted = " or ".join(str(n) for n in count)
            raise self.fail(f"has {name}={text!r} in <{self.element.tag}>: give {wanted} finite numbers")
        return numbers

    def number(self, name: str, default: float | None = None) -> float:
        """Return the only number of an attribute."""
        return float(self.numbers(name, (1,), None if default is None else (default,))[0])

    def place(self) -> Doubles:
        """Return the <origin> as a matrix (4, 4)."""
        origin = self.child("origin")
        if origin is None:
            return np.eye(4)
        position, rotation = origin.numbers("xyz", (3,), (0, 0, 0)), origin.numbers("rpy", (3,), (0, 0, 0))
        quaternion = origin.element.get("quat_xyzw")
        if quaternion is None:
            return placed(_turn(rotation), position)
        if origin.element.get("rpy") is not None:
            raise self.fail("has rpy and quat_xyzw in <origin>: leave one")
        try:
            return placed(pose_of(origin.numbers("quat_xyzw", (4,))[[3, 0, 1, 2]], position)[1], position)
        except InvalidPath:
            raise self.fail(f"has quat_xyzw={quaternion!r}, which has not the length 1: normalise it") from None


def _turn(rpy: Doubles) -> Doubles:
    """Return the rotation of roll, pitch and yaw as a matrix: about x, then y, then z, all fixed."""
    (r, p, y), matrix = rpy, np.eye(3)
    for axis, angle in ((0, r), (1, p), (2, y)):
        i, j = (axis + 1) % 3, (axis + 2) % 3
        one = np.eye(3)
        one[i, i] = one[j, j] = np.cos(angle)
        one[j, i] = np.sin(angle)
        one[i, j] = -one[j, i]
        matrix = one @ matrix
    return matrix


def read_urdf(file: str | os.PathLike[str]) -> RobotFile:
    """Read a file; raise FileError with a sentence for everything that is not understood."""
    name = os.fspath(file)
    try:
        root = ElementTree.fromstring(pathlib.Path(name).read_bytes())
    except OSError as error:
        raise FileError(f"{name}: {error.strerror}: give a URDF file that can be read") from None
    except ElementTree.ParseError as error:
        raise FileError(f"{name}: is no XML ({error}): give a URDF file; xacro files become one by `xacro`") from None
    if root.tag != "robot":
        raise FileError(f"{name}: begins with <{root.tag}>, not <robot>: give a URDF file")
    if any("}" in tag or "xacro:" in tag for tag in (element.tag for element in root) if isinstance(tag, str)):
        raise FileError(f"{name}: has macros of xacro: run `xacro` on it, and give its output")
    links = _once([_link(element, name) for element in root.findall("link")], "link", name)
    joints = _once([_joint(element, name) for element in root.findall("joint")], "joint", name)
    return _tree(name, root.get("name") or "robot", links, joints)


def _named(element: ElementTree.Element, file: str) -> Element:
    name = element.get("name")
    if not name:
        raise FileError(f"{file}: a <{element.tag}> has no name: add it")
    return Element(element, file, f"{element.tag} {name!r}")


def _once(parts: list, kind: str, file: str) -> dict:  # type: ignore[type-arg]
    found = {part.name: part for part in parts}
    if len(found) < len(parts):
        names = [part.name for part in parts]
        twice = next(name for name in names if names.count(name) > 1)
        raise FileError(f"{file}: two elements are called {kind} {twice!r}: rename one")
    return found


def _link(element: ElementTree.Element, file: str) -> FileLink:
    link = _named(element, file)
    return FileLink(
        str(element.get("name")), [_solid(Element(e, file, link.where)) for e in element.findall("collision")]
    )


def _solid(collision: Element) -> Solid:
    geometry = collision.needed("geometry")
    shapes = [Element(e, collision.file, collision.where) for e in geometry.element if isinstance(e.tag, str)]
    if len(shapes) != 1:
        raise collision.fail(f"has {len(shapes)} shapes in a <geometry> of <collision>: give one")
    shape, kind = shapes[0], shapes[0].element.tag
    if kind == "mesh":
        scale = shape.numbers("scale", (1, 3), (1, 1, 1)) * np.ones(3)
        if not scale.all():
            raise collision.fail(
                f"has a mesh with the scale {shape.element.get('scale')!r}: give numbers that are not 0"
            )
        return Solid(collision.place(), kind, scale, shape.word("filename"))
    if kind not in SHAPES:
        raise collision.fail(f"has a <{kind}> in <collision>: give a mesh, box, cylinder, capsule or sphere")
    size = np.concatenate([shape.numbers(name, (3,) if name == "size" else (1,)) for name in SHAPES[kind]])
    if not (size > 0).all():
        raise collision.fail(f"has a <{kind}> with a size that is not positive: give sizes > 0")
    return Solid(collision.place(), kind, size)


def _joint(element: ElementTree.Element, file: str) -> FileJoint:
    joint = _named(element, file)
    kind = joint.word("type")
    if kind not in KINDS:
        raise joint.fail(f"has the type {kind!r}: only fixed, revolute, continuous and prismatic joints move here")
    lower, upper = _limits(joint, kind)
    mimic = joint.child("mimic")
    return FileJoint(
        name=str(element.get("name")),
        kind=KINDS[kind],
        is_continuous=kind == "continuous",
        parent=joint.needed("parent").word("link"),
        child=joint.needed("child").word("link"),
        place=joint.place(),
        axis=np.array([0.0, 0, 1]) if kind == "fixed" else _axis(joint),
        lower=lower,
        upper=upper,
        mimics="" if mimic is None or kind == "fixed" else mimic.word("joint"),
        factor=1.0 if mimic is None else mimic.number("multiplier", 1),
        offset=0.0 if mimic is None else mimic.number("offset", 0),
    )


def _axis(joint: Element) -> Doubles:
    child = joint.child("axis")
    axis = np.array([1.0, 0, 0]) if child is None else child.numbers("xyz", (3,), (1, 0, 0))
    length = float(np.linalg.norm(axis))
    if abs(length - 1) > _UNIT:
        raise joint.fail(f"has an axis of length {length:.6g}: give one of length 1")
    return axis / length


def _limits(joint: Element, kind: str) -> tuple[float, float]:
    """Return the limits. As the specification says, a missing one is 0; a continuous joint has none."""
    if kind in ("fixed", "continuous"):
        return -np.inf, np.inf
    limit = joint.needed("limit")
    lower, upper = limit.number("lower", 0), limit.number("upper", 0)
    if lower > upper:
        raise joint.fail(f"has limits that cross, from {lower:g} to {upper:g}: exchange them")
    return lower, upper


def _tree(file: str, name: str, links: dict[str, FileLink], joints: dict[str, FileJoint]) -> RobotFile:
    """Sort the joints from the root, and check that they make one tree of all links."""
    parent: dict[str, str] = {}
    for joint in joints.values():
        for link in (joint.parent, joint.child):
            if link not in links:
                raise FileError(f"{file}: joint {joint.name!r} names the link {link!r}, which is not there: add it")
        if joint.child in parent:
            raise FileError(f"{file}: link {joint.child!r} hangs on two joints: a robot must be a tree")
        parent[joint.child] = joint.name
        leader = joints.get(joint.mimics)
        if joint.mimics and (leader is None or leader.mimics or leader.kind == "fixed"):
            raise FileError(
                f"{file}: joint {joint.name!r} mimics {joint.mimics!r}, which is no joint that moves by itself"
            )
    if not links:
        raise FileError(f"{file}: has no <link>: give a URDF file of a robot")
    roots = [link for link in links if link not in parent]
    if len(roots) != 1:
        raise FileError(f"{file}: {len(roots)} links hang on no joint ({', '.join(roots[:4])}): there must be one root")
    children: dict[str, list[FileJoint]] = {link: [] for link in links}
    for joint in joints.values():
        children[joint.parent].append(joint)
    ordered: list[FileJoint] = []
    waiting = list(reversed(children[roots[0]]))
    while waiting:
        ordered.append(waiting.pop())
        waiting += reversed(children[ordered[-1].child])
    if len(ordered) < len(joints):
        lost = next(joint.name for joint in joints.values() if joint not in ordered)
        raise FileError(f"{file}: joint {lost!r} is in a circle of joints: a robot must be a tree")
    return RobotFile(name, roots[0], links, ordered)
