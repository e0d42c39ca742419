"""The scenes of evidence.py: robots of example-robot-data among obstacles, and random edges between valid configurations."""

from __future__ import annotations

import dataclasses
import pathlib
import typing

import numpy as np
import scipy.optimize
import scipy.spatial
import trimesh

import tamis
from tamis import robots

DATA = pathlib.Path(trimesh.__file__).parents[1] / "cmeel.prefix/share/example-robot-data/robots"
HOME = np.array([0, -0.785, 0, -2.356, 0, 1.571, 0.785])


@dataclasses.dataclass
class Case:
    """A scene, with the configurations that its edges begin near."""

    name: str
    scene: robots.Scene
    obstacles: list[tuple[str, tamis.Shape]]
    near: np.ndarray
    spread: float
    length: float


def solid(mesh: trimesh.Trimesh) -> tamis.Shape:
    return tamis.Shape(tamis.Mesh(mesh.faces), mesh.vertices)


def box(size: typing.Sequence[float], at: typing.Sequence[float]) -> tamis.Shape:
    return solid(trimesh.creation.box(size, trimesh.transformations.translation_matrix(at)))


def panda(**options: typing.Any) -> robots.Robot:
    folder = DATA / "panda_description"
    held = {"panda_finger_joint1": 0.03}
    return robots.load(folder / "urdf/panda.urdf", srdf=folder / "srdf/panda.srdf", held=held, **options)


def reaching(robot: robots.Robot, place: typing.Sequence[float]) -> np.ndarray:
    """Return a configuration with the hand at a place, pointing along x, its fingers beside each other."""

    def off(q: np.ndarray) -> np.ndarray:
        pose = robot.pose("panda_hand", q)
        turn = scipy.spatial.transform.Rotation.from_rotvec(pose[1]).as_matrix()
        return np.concatenate([pose[0] - place, 0.3 * (turn[:, 2] - [1, 0, 0]), 0.3 * (turn[:, 1] - [0, 1, 0])])

    inside = robot.limits.T + [[0.05], [-0.05]]
    rng = np.random.default_rng(2)
    for _ in range(30):
        found = scipy.optimize.least_squares(off, np.clip(HOME + rng.normal(0, 0.4, 7), *inside), bounds=inside)
        if found.cost < 1e-6:
            return found.x
    raise RuntimeError(f"no configuration reaches {place}")


def shelf() -> Case:
    """A shelf of six compartments, with eighteen cans, boxes and balls."""
    obstacles = [(f"board {i}", box((0.35, 1.2, 0.02), (0.72, 0, z))) for i, z in enumerate((0.15, 0.5, 0.85))]
    obstacles += [(f"side {i}", box((0.35, 0.02, 0.72), (0.72, y, 0.5))) for i, y in enumerate((-0.6, 0.0, 0.6))]
    obstacles.append(("back", box((0.02, 1.2, 0.72), (0.9, 0, 0.5))))
    rng = np.random.default_rng(5)
    for i in range(18):
        x, y = rng.uniform(0.6, 0.85), rng.choice([-0.3, 0.3]) + rng.uniform(-0.22, 0.22)
        z = (0.16, 0.51)[i % 2]
        kind, size = i % 3, rng.uniform(0.02, 0.035)
        if kind == 0:
            mesh = trimesh.creation.cylinder(size, 0.13, sections=32)
        elif kind == 1:
            mesh = trimesh.creation.box((2 * size, 2 * size, 0.13))
        else:
            mesh = trimesh.creation.icosphere(2, size)
        mesh.apply_translation((x, y, z + (0.065 if kind < 2 else size) + 0.002))
        obstacles.append((f"item {i}", solid(mesh)))
    robot = panda()
    return case("Panda, shelf", [robot], obstacles, reaching(robot, (0.48, 0.3, 0.34)), 0.5, 2.0)


def slot() -> Case:
    """A wall with a slot, through which the hand reaches."""
    wide, high = 0.28, 0.13
    obstacles = [
        ("left", box((0.03, 0.8, 1.2), (0.5, 0.4 + wide / 2, 0.6))),
        ("right", box((0.03, 0.8, 1.2), (0.5, -0.4 - wide / 2, 0.6))),
        ("above", box((0.03, wide, 0.6), (0.5, 0, 0.5 + high / 2 + 0.3))),
        ("below", box((0.03, wide, 0.4), (0.5, 0, 0.5 - high / 2 - 0.2))),
    ]
    robot = panda()
    return case("Panda, slot", [robot], obstacles, reaching(robot, (0.43, 0, 0.5)), 0.3, 1.5)


def two_arms() -> Case:
    """Two Pandas side by side above a table."""
    arms = [
        panda(name=name, base=tamis.pose_of([0, 0, turn], [0, y, 0]))
        for name, y, turn in (("left", 0.3, -0.4), ("right", -0.3, 0.4))
    ]
    obstacles = [("table", box((1.0, 1.4, 0.04), (0.6, 0, -0.03)))]
    return case("two Pandas", arms, obstacles, np.concatenate([HOME, HOME]), 0.7, 3.0)


def hand() -> Case:
    """An Allegro hand with a pen among its fingers, and a ball before its palm."""
    robot = robots.load(DATA / "allegro_hand_description/urdf/allegro_left_hand.urdf")
    probe = robots.Scene(robot)
    middle = robot.limits.mean(1)
    never = set(probe.overlapping(middle)) | set(probe.overlapping(np.clip(0, *robot.limits.T)))
    robot = robots.load(DATA / "allegro_hand_description/urdf/allegro_left_hand.urdf", disabled=never)
    pen = trimesh.creation.cylinder(0.004, 0.16, sections=24)
    pen.apply_transform(trimesh.transformations.rotation_matrix(np.pi / 2, (1, 0, 0)))
    pen.apply_translation((0.07, 0, 0.07))
    ball = trimesh.creation.icosphere(3, 0.02)
    ball.apply_translation((0.09, -0.02, 0.02))
    obstacles = [("pen", solid(pen)), ("ball", solid(ball))]
    return case("Allegro hand, pen", [robot], obstacles, middle, 0.5, 1.5)


def humanoid() -> Case:
    """A G1 with three-fingered hands, which stands; its arms and hands move before a table with cans."""
    file = DATA / "g1_description/urdf/g1_29dof_with_hand_rev_1_0.urdf"
    whole = robots.load(file)
    arms = ("shoulder", "elbow", "wrist", "hand")
    held = {joint: 0.0 for joint in whole.joints if not any(word in joint for word in arms)}
    home = {joint: 0.0 for joint in whole.joints if joint not in held}
    robot = robots.load(file, held=held)
    values = np.array([home[j] + (0.25 if "left_shoulder_roll" in j else -0.25 if "right_shoulder_roll" in j else 0) for j in robot.joints])
    values = np.clip(values, *robot.limits.T)
    never = robots.Scene(robot).overlapping(values)
    robot = robots.load(file, held=held, disabled=never)
    obstacles = [("table", box((0.5, 1.0, 0.03), (0.45, 0, -0.05)))]
    for i, y in enumerate((-0.35, -0.15, 0.1, 0.3)):
        can = trimesh.creation.cylinder(0.033, 0.12, sections=48)
        can.apply_translation((0.32, y, 0.03))
        obstacles.append((f"can {i}", solid(can)))
    return case("G1 with hands, table", [robot], obstacles, values, 0.5, 3.0)


def case(
    name: str, arms: list[robots.Robot], obstacles: list[tuple[str, tamis.Shape]], near: np.ndarray, spread: float,
    length: float,
) -> Case:
    scene = robots.Scene(*arms, threads=1)
    for obstacle, shape in obstacles:
        scene.add(obstacle, shape)
    return Case(name, scene, obstacles, np.clip(near, *scene.limits.T), spread, length)


def edges_of(made: Case, count: int, seed: int = 1) -> tuple[np.ndarray, np.ndarray]:
    """Return random edges between valid configurations."""
    rng, starts, ends = np.random.default_rng(seed), [], []
    while len(starts) < count:
        first = made.near + rng.normal(0, made.spread, (4 * count, len(made.near)))
        way = rng.normal(0, 1, first.shape)
        way *= rng.uniform(0.1, made.length, (len(way), 1)) / np.linalg.norm(way, axis=1, keepdims=True)
        first, last = np.clip(first, *made.scene.limits.T), np.clip(first + way, *made.scene.limits.T)
        good = made.scene.is_valid(first)
        good[good] = made.scene.is_valid(last[good])
        starts += list(first[good])
        ends += list(last[good])
    return np.array(starts[:count]), np.array(ends[:count])


CASES = {"shelf": shelf, "slot": slot, "two_arms": two_arms, "hand": hand, "humanoid": humanoid}
