"""Robots from URDF files that need no other package: what moves how, what counts, and each fault's sentence."""

from __future__ import annotations

import pathlib
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from conftest import CUBE, CUBE_FACES, at

import tamis
from tamis import robots
from tamis.robots import _frames

Write = Callable[..., pathlib.Path]
BOX = '<collision><geometry><box size="1 0.1 0.1"/></geometry></collision>'
LINKS = f'<link name="base"/><link name="upper">{BOX}</link><link name="lower">{BOX}</link>'
LIMIT = '<limit lower="-3" upper="3"/>'


def joint(name: str, parent: str, child: str, more: str = LIMIT, kind: str = "revolute", xyz: str = "0.5 0 0") -> str:
    return (
        f'<joint name="{name}" type="{kind}"><origin xyz="{xyz}"/><parent link="{parent}"/><child link="{child}"/>'
        f'<axis xyz="0 0 1"/>{more}</joint>'
    )


SHOULDER, ELBOW = joint("shoulder", "base", "upper"), joint("elbow", "upper", "lower", xyz="1 0 0.2")


@pytest.fixture
def write(tmp_path: pathlib.Path) -> Write:
    """Return a function that writes a robot's elements into a URDF file."""

    def writes(*elements: str, name: str = "arm.urdf") -> pathlib.Path:
        path = tmp_path / name
        path.write_text(f'<robot name="arm">{"".join(elements)}</robot>')
        return path

    return writes


@pytest.fixture
def arm(write: Write) -> robots.Robot:
    return robots.load(write(LINKS, SHOULDER, ELBOW))


def matrix(pose: Any) -> npt.NDArray[np.float64]:
    return _frames.frame_of(pose)


def test_a_chain_is_straight_in_joint_space(arm: robots.Robot) -> None:
    """Would catch a wrong frame, and a motion other than the planners'."""
    assert arm.joints == ("shoulder", "elbow") and arm.links == ("upper", "lower")
    start, end = np.array([-1.0, 0.5]), np.array([2.0, -2.5])
    scene = robots.Scene(arm)
    scene.world.move_many([0, 1], arm.chain(start, end))
    for time in (0.0, 0.3, 1.0):
        at = (1 - time) * start + time * end
        for body, link in enumerate(arm.links):
            points, error = scene.world.points_at(body, time)
            expected = _frames.moved(CUBE * [1, 0.1, 0.1], matrix(arm.pose(link, at)))
            gaps = np.linalg.norm(points[:, np.newaxis] - expected, axis=2)
            assert error < 1e-12 and gaps.min(1).max() < 1e-12 and gaps.min(0).max() < 1e-12


def test_many_chains_are_those_of_one(arm: robots.Robot) -> None:
    rng = np.random.default_rng(1)
    starts, ends = rng.uniform(-3, 3, (2, 5, 2))
    many = arm.chain(starts, ends)
    assert many.shape == (5, 2, 2, 4, 3)
    assert all((many[i] == arm.chain(starts[i], ends[i])).all() for i in range(5))


def test_sliding_mimicking_and_held_joints(write: Write) -> None:
    """Would catch a factor or an offset that is not used, and a held joint at another value."""
    fingers = "".join(f'<link name="{name}">{BOX}</link>' for name in ("left", "right"))
    slides = joint("open", "lower", "left", '<limit lower="0" upper="0.5"/>', "prismatic", "0 0 1")
    follows = joint("too", "lower", "right", LIMIT + '<mimic joint="open" multiplier="-2" offset="0.1"/>', "prismatic")
    path = write(LINKS, fingers, SHOULDER, ELBOW, slides, follows)
    robot = robots.load(path)
    assert robot.joints == ("shoulder", "elbow", "open")
    place = matrix(robot.pose("right", [0, 0, 0.25]))
    assert np.allclose(place[:3, 3], [0.5 + 1 + 0.5, 0, 0.2 + 0.1 - 2 * 0.25])
    held = robots.load(path, held={"open": 0.25})
    assert held.joints == ("shoulder", "elbow")
    for q in ([0.3, -0.8], [0, 0]):
        for link in ("left", "right"):
            assert np.allclose(matrix(held.pose(link, q)), matrix(robot.pose(link, [*q, 0.25])))
    assert ("left", "right") in held.ignored_pairs and ("left", "right") not in robot.ignored_pairs


def test_joined_links_never_count_also_across_links_without_a_shape(write: Write) -> None:
    between = joint("a", "upper", "empty", kind="fixed", more="") + joint("b", "empty", "lower")
    robot = robots.load(write(LINKS, '<link name="empty"/>', f'<link name="hook">{BOX}</link>', SHOULDER, between,
                              joint("c", "base", "hook")))  # fmt: skip
    assert robot.ignored_pairs == [("upper", "lower")]
    assert robots.load(write(LINKS, SHOULDER, joint("b", "base", "lower"))).ignored_pairs == []


def test_srdf_and_disabled(write: Write, tmp_path: pathlib.Path) -> None:
    path = write(LINKS, SHOULDER, joint("b", "base", "lower"))
    srdf = tmp_path / "arm.srdf"
    srdf.write_text('<robot name="arm"><disable_collisions link1="upper" link2="lower" reason="Never"/></robot>')
    assert robots.load(path, srdf=srdf).ignored_pairs == [("upper", "lower")]
    assert robots.load(path, disabled=[("lower", "upper")]).ignored_pairs == [("upper", "lower")]
    with pytest.raises(tamis.InvalidOptions, match="disabled names the link 'hand', which arm has not"):
        robots.load(path, disabled=[("lower", "hand")])
    srdf.write_text('<robot name="arm"><disable_collisions link1="upper" link2="hand"/></robot>')
    with pytest.raises(tamis.FileError, match="disables the link 'hand', which the robot has not"):
        robots.load(path, srdf=srdf)


@pytest.mark.parametrize("tolerance", [0.05, 1e-3])
@pytest.mark.parametrize(
    ("text", "kind", "size"),
    [
        ('<cylinder radius="0.2" length="0.6"/>', "cylinder", (0.2, 0.6)),
        ('<capsule radius="0.2" length="0.6"/>', "capsule", (0.2, 0.6)),
        ('<sphere radius="0.3"/>', "capsule", (0.3, 0.0)),
    ],
)
def test_triangles_are_outside_primitives_within_the_tolerance(
    write: Write, text: str, kind: str, size: tuple[float, float], tolerance: float
) -> None:
    """Would catch inscribed triangles, which miss contacts."""
    links = f'<link name="base"><collision><geometry>{text}</geometry></collision></link>'
    shape = robots.load(write(links), tolerance=tolerance).shapes[0]
    rng = np.random.default_rng(2)
    a, b, c = shape.points[shape.mesh.faces].transpose(1, 0, 2)
    weights = rng.dirichlet([1, 1, 1], 40)
    samples = np.concatenate([w[0] * a + w[1] * b + w[2] * c for w in weights])
    radius, half = size[0], size[1] / 2
    across = np.hypot(samples[:, 0], samples[:, 1])
    beyond = np.abs(samples[:, 2]) - half
    if kind == "cylinder":
        outside = np.maximum(across - radius, beyond)
    else:
        outside = np.hypot(across, np.maximum(beyond, 0)) - radius
    assert outside.min() > -1e-12 and outside.max() < tolerance + 1e-12


FAULTS = {
    "axis": (
        joint("a", "base", "upper").replace('"0 0 1"', '"0 0 2"'),
        "joint 'a' has an axis of length 2: give one of",
    ),
    "no axis": (joint("a", "base", "upper").replace('"0 0 1"', '"0 0 0"'), "joint 'a' has an axis of length 0"),
    "limits": (
        joint("a", "base", "upper", '<limit lower="2" upper="1"/>'),
        "joint 'a' has limits that cross, from 2 to 1",
    ),
    "no limits": (joint("a", "base", "upper", ""), "joint 'a' has no <limit>: add it"),
    "quaternion": (
        joint("a", "base", "upper").replace("<origin", '<origin quat_xyzw="0 0 1 1"'),
        "joint 'a' has quat_xyzw='0 0 1 1', which has not the length 1: normalise it",
    ),
    "two rotations": (
        joint("a", "base", "upper").replace("<origin", '<origin rpy="0 0 0" quat_xyzw="0 0 0 1"'),
        "joint 'a' has rpy and quat_xyzw in <origin>: leave one",
    ),
    "numbers": (joint("a", "base", "upper", xyz="1 2"), "joint 'a' has xyz='1 2' in <origin>: give 3 finite numbers"),
    "not finite": (joint("a", "base", "upper", xyz="1 2 nan"), "joint 'a' has xyz='1 2 nan'"),
    "floating": (
        joint("a", "base", "upper", kind="floating"),
        "joint 'a' has the type 'floating': only fixed, revolute",
    ),
    "no parent": (joint("a", "hip", "upper"), "joint 'a' names the link 'hip', which is not there"),
    "mimic": (
        joint("a", "base", "upper", LIMIT + '<mimic joint="b"/>'),
        "joint 'a' mimics 'b', which is no joint that",
    ),
    "circle": (joint("a", "upper", "lower") + joint("b", "lower", "upper"), "joint 'a' is in a circle of joints"),
    "twice": (SHOULDER + SHOULDER, "two elements are called joint 'shoulder': rename one"),
    "two parents": (
        SHOULDER + joint("b", "lower", "upper"),
        "link 'upper' hangs on two joints: a robot must be a tree",
    ),
    "cut off": (SHOULDER, r"2 links hang on no joint \(base, lower\): there must be one root"),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_each_fault_of_a_joint_names_it(write: Write, fault: str) -> None:
    element, sentence = FAULTS[fault]
    with pytest.raises(tamis.FileError, match=sentence):
        robots.load(write(LINKS, element))


LINK_FAULTS = {
    '<cone radius="1"/>': "link 'base' has a <cone> in <collision>: give a mesh, box, cylinder, capsule or sphere",
    '<sphere radius="-1"/>': "link 'base' has a <sphere> with a size that is not positive",
    '<sphere radius="x"/>': "link 'base' has radius='x' in <sphere>: give 1 finite numbers",
    "": "link 'base' has 0 shapes in a <geometry> of <collision>: give one",
    '<mesh filename="gone.stl"/>': "link 'base' names the mesh 'gone.stl', which is not there",
    '<mesh filename="package://none/gone.stl"/>': "link 'base' names the mesh 'package://none/gone.stl', which is not",
    '<mesh filename="gone.stl" scale="1 0 1"/>': "link 'base' has a mesh with the scale '1 0 1': give numbers that",
}


@pytest.mark.parametrize("text", LINK_FAULTS)
def test_each_fault_of_a_link_names_it(write: Write, text: str) -> None:
    path = write(f'<link name="base"><collision><geometry>{text}</geometry></collision></link>')
    with pytest.raises(tamis.FileError, match=LINK_FAULTS[text]):
        robots.load(path)


def test_files_that_are_no_robots(tmp_path: pathlib.Path, write: Write) -> None:
    path = tmp_path / "bad.urdf"
    for text, sentence in (
        ("<robot><link", "bad.urdf: is no XML"),
        ("<model/>", "bad.urdf: begins with <model>, not <robot>"),
        ('<robot xmlns:xacro="x"><xacro:arm/></robot>', "has macros of xacro: run `xacro` on it"),
        ("<robot/>", "bad.urdf: has no <link>"),
        ('<robot><link name="a"/></robot>', "no link has a <collision>, so nothing could touch"),
    ):
        path.write_text(text)
        with pytest.raises(tamis.FileError, match=sentence):
            robots.load(path)
    with pytest.raises(tamis.FileError, match="give a URDF file that can be read"):
        robots.load(tmp_path / "none.urdf")


def test_configurations_that_are_refused(write: Write, arm: robots.Robot) -> None:
    with pytest.raises(tamis.InvalidPath, match=r"joint 'elbow' is at 3\.5 in row 1 of end, beyond its limits -3 to 3"):
        arm.chain(np.zeros((2, 2)), np.array([[0, 0], [0, 3.5]]))
    with pytest.raises(tamis.InvalidPath, match=r"give a number for each of the 2 joints \(shoulder, elbow\)"):
        arm.chain([0, 0, 0], [0, 0, 0])
    with pytest.raises(tamis.InvalidPath, match="start holds a number that is not finite"):
        arm.chain([0, np.nan], [0, 0])
    with pytest.raises(tamis.InvalidOptions, match=r"held\['elbow'\] is 4, beyond its limits -3 to 3"):
        robots.load(write(LINKS, SHOULDER, ELBOW), held={"elbow": 4})
    with pytest.raises(tamis.InvalidOptions, match="held names the joint 'wrist': give joints that move by themselves"):
        robots.load(write(LINKS, SHOULDER, ELBOW), held={"wrist": 4})
    with pytest.raises(tamis.InvalidOptions, match="arm has no link 'hand': it has base, upper, lower"):
        arm.pose("hand", [0, 0])


def test_a_continuous_joint_goes_the_shorter_way_or_says_so(write: Write) -> None:
    """Would catch a joint that turns the long way around in silence."""
    robot = robots.load(write(LINKS, joint("spin", "base", "upper", "", "continuous"), ELBOW))
    start, end = [3.0, 1.0], [-3.0, 2.0]
    with pytest.raises(tamis.InvalidPath, match="the continuous joint 'spin' goes from 3 to -3, by more"):
        robot.chain(start, end)
    short = robot.shorter_way(start, end)
    assert np.allclose(short, [2 * np.pi - 3, 2])
    assert np.allclose(matrix(robot.pose("lower", short)), matrix(robot.pose("lower", end)))
    assert np.allclose(robot.chain(start, short)[0, 0, 3], [0, 0, 2 * np.pi - 3])
    assert np.allclose(robot.chain(start, end, whole_turns=True)[0, 0, 3], [0, 0, -3])


class Cube:
    """A cube as trimesh has it."""

    def __init__(self, size: float, center: Any) -> None:
        self.vertices, self.faces = CUBE * size + center, CUBE_FACES


def test_a_scene_answers_about_edges(arm: robots.Robot) -> None:
    scene = robots.Scene(arm, threads=1)
    scene.add("post", Cube(0.3, [0, 1.4, 0.17]))
    assert scene.open_bodies == []
    start, end = np.array([0.0, 0.5]), np.array([2.0, 0.5])
    found = scene.last_valid([start, end], [end, start])
    assert found.is_free.tolist() == [False, False] and set(found.pairs[0] or ()) == {"lower", "post"}
    assert np.abs(found.points[0] - [0, 1.4, 0.17]).max() < 0.2
    reached = start + found.fraction[0] * (end - start)
    bit = np.array([1e-6, 0])
    assert scene.is_free(start, reached - bit) and not scene.is_free(start, reached + bit)
    assert scene.is_free([start, start], [reached - bit, end]).tolist() == [True, False]
    way = scene.first_bad_edge([start, reached / 2, end])
    assert (way.is_free, way.edge) == (False, 1) and set(way.pair or ()) == {"lower", "post"}
    assert scene.first_bad_edge([start, reached / 2]).is_free


def test_inside_counts(arm: robots.Robot) -> None:
    """Would catch a link inside an obstacle that is called free."""
    scene = robots.Scene(arm)
    scene.add("room", Cube(20, [0, 0, 0]))
    assert not scene.is_valid([0, 0]) and not scene.is_free([0, 0], [1, 1])
    found = scene.last_valid([0, 0], [1, 1])
    assert found.overlaps_at_start[0] and found.fraction[0] == 0
    assert ("upper", "room") in scene.overlapping([0, 0])
    with pytest.raises(tamis.InvalidStep, match="'upper' and 'room' overlap at this configuration, and 1 other pair"):
        scene.check([0, 0])
    scene.ignore([("upper", "room"), ("lower", "room")])
    scene.check([0, 0])
    assert scene.is_valid([[0, 0], [1, 1]]).tolist() == [True, True]


def test_self_collision_at_the_start_names_the_links(write: Write) -> None:
    robot = robots.load(write(LINKS, SHOULDER, joint("b", "base", "lower", xyz="0.5 0.3 0")))
    scene = robots.Scene(robot)
    with pytest.raises(tamis.InvalidStep, match="'upper' and 'lower' overlap at this configuration: move the robot"):
        scene.check([0, 1])
    scene.check([0, 0])


def test_an_attached_object_moves_along(arm: robots.Robot) -> None:
    loaded = arm.attach("load", Cube(0.2, [0.7, 0, 0]), "lower")
    assert loaded.links == ("upper", "lower", "load") and arm.links == ("upper", "lower")
    assert ("lower", "load") in loaded.ignored_pairs and ("upper", "load") not in loaded.ignored_pairs
    touching = arm.attach("load", Cube(0.2, [0.7, 0, 0]), "lower", touching=["upper"])
    assert ("upper", "load") in touching.ignored_pairs
    for robot, free in ((arm, True), (loaded, False)):
        scene = robots.Scene(robot)
        scene.add("post", Cube(0.2, [0.5, 1.75, 0.2]))
        assert scene.is_free([0, 0], [2, 0]) is free
    turned = arm.attach("load", Cube(0.2, [0, 0, 0]), "lower", tamis.pose_of([0, 0, 1.0], [0.7, 0, 0]))
    box = robots.Scene(turned).world
    assert abs(box.points_at(2, 0.0)[0].mean(0) - [0.5 + 1 + 0.7, 0, 0.2]).max() < 1e-12
    with pytest.raises(tamis.InvalidOptions, match="name is 'upper', which arm has already"):
        arm.attach("upper", Cube(1, [0, 0, 0]), "lower")


def test_obstacles_that_move_do_so_during_an_edge(arm: robots.Robot) -> None:
    scene = robots.Scene(arm)
    ball = scene.add("ball", Cube(0.2, [0, 0, 0]), tamis.pose_of([0, 0, 0.0], [0, 1.0, 0]))
    still = [0.0, 0.0]
    assert scene.is_free(still, still)
    scene.world.move(ball, tamis.interpolated_chain(*at((0.5, 1, 0), (0.5, -1, 0))))
    assert not scene.is_free(still, still)


def test_two_robots_in_one_scene(write: Write) -> None:
    path = write(LINKS, SHOULDER, ELBOW)
    left = robots.load(path, name="left")
    right = robots.load(path, name="right", base=tamis.pose_of([0, 0, np.pi], [3, 0, 0]))
    scene = robots.Scene(left, right)
    assert scene.joints == ("left/shoulder", "left/elbow", "right/shoulder", "right/elbow")
    apart, there = [2, 0, 2, 0], [0, 0, 0, 0]
    assert scene.is_valid(apart)
    found = scene.last_valid(apart, there)
    names = found.pairs[0]
    assert names is not None and {name.partition("/")[0] for name in names} == {"left", "right"}
    with pytest.raises(tamis.InvalidOptions, match="robots are called left, left: give one or more, each another name"):
        robots.Scene(left, left)


def test_clearance_counts(arm: robots.Robot) -> None:
    for separation, free in ((0.0, True), (0.1, False)):
        scene = robots.Scene(arm, min_separation=separation)
        scene.add("post", Cube(0.2, [0.9, 0.2, 0]))
        assert scene.is_free([0, -1], [0, 1]) is free and scene.is_valid([0, 0]) is free
