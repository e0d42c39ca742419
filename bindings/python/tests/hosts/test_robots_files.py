"""Robots with meshes: frames as yourdfpy computes them, scaled and mirrored meshes, and files that cannot be used."""

from __future__ import annotations

import logging
import pathlib
import sys
from typing import Any

import numpy as np
import pytest

import tamis
from tamis import robots
from tamis.robots import _frames

trimesh = pytest.importorskip("trimesh", reason="trimesh is not installed: bindings/python/requirements-hosts.txt")
yourdfpy = pytest.importorskip("yourdfpy", reason="yourdfpy is not installed: bindings/python/requirements-hosts.txt")

pytestmark = pytest.mark.filterwarnings("default")
DATA = pathlib.Path(trimesh.__file__).parents[1] / "cmeel.prefix/share/example-robot-data/robots"
logging.getLogger("yourdfpy.urdf").setLevel(logging.CRITICAL)


def needs(path: str) -> pathlib.Path:
    if not DATA.is_dir():
        pytest.skip("example-robot-data is not installed: bindings/python/requirements-hosts.txt")
    return DATA / path


@pytest.mark.parametrize(
    ("path", "joints", "links"),
    [
        ("panda_description/urdf/panda.urdf", 8, 11),
        ("allegro_hand_description/urdf/allegro_left_hand.urdf", 16, 21),
        ("anymal_b_simple_description/robots/anymal.urdf", 12, 22),
        ("so_arm_description/urdf/so100.urdf", 6, 5),
        ("g1_description/urdf/g1_29dof_with_hand_rev_1_0.urdf", 43, 46),
        ("pr2_description/urdf/pr2.urdf", 20, 32),
        ("talos_data/robots/talos_reduced.urdf", 32, 52),
        ("ur_description/urdf/ur5_gripper.urdf", 6, 9),
    ],
)
def test_frames_are_those_of_yourdfpy(path: str, joints: int, links: int) -> None:
    """Would catch a frame, an axis, a mimic joint or a solid that is read in another way than by others."""
    robot = robots.load(needs(path))
    assert (len(robot.joints), len(robot.links)) == (joints, links)
    other = yourdfpy.URDF.load(str(needs(path)), load_meshes=False)
    rng = np.random.default_rng(3)
    for _ in range(3):
        q = rng.uniform(robot.limits[:, 0].clip(-9, 9), robot.limits[:, 1].clip(-9, 9))
        other.update_cfg(dict(zip(robot.joints, q)))
        for link in robot.links:
            assert np.abs(other.get_transform(link) - _frames.frame_of(robot.pose(link, q))).max() < 1e-13


def test_panda_in_the_pose_of_its_srdf() -> None:
    path = needs("panda_description/urdf/panda.urdf")
    srdf = needs("panda_description/srdf/panda.srdf")
    robot = robots.load(path, srdf=srdf, held={"panda_finger_joint1": 0.04})
    scene = robots.Scene(robot)
    assert scene.open_bodies == [] and len(robot.ignored_pairs) == 35
    scene.check([0, -0.785, 0, -2.356, 0, 1.571, 0.785])
    with pytest.raises(tamis.InvalidStep, match="overlap at this configuration"):
        scene.check([0, 1.7, 0, -3.0, 0, 0, 0])


def wedge() -> Any:
    """Return a solid that no reflection maps to itself."""
    points = [[0, 0, 0], [3, 0, 0], [0, 2, 0], [0, 0, 1]]
    return trimesh.Trimesh(points, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])


@pytest.mark.parametrize("scale", [(1, 1, 1), (-1, 1, 1), (2, -0.5, 1), (-1, -1, -1), (0.001, 0.001, 0.001)])
@pytest.mark.parametrize("suffix", ["stl", "obj", "ply"])
def test_scaled_and_mirrored_meshes_are_solids(tmp_path: pathlib.Path, scale: tuple[float, ...], suffix: str) -> None:
    """Would catch a mirrored mesh that is inside out, or an STL file whose triangles are not joined."""
    wedge().export(str(tmp_path / f"wedge.{suffix}"))
    text = " ".join(str(s) for s in scale)
    mesh = f'<geometry><mesh filename="wedge.{suffix}" scale="{text}"/></geometry>'
    (tmp_path / "r.urdf").write_text(f'<robot name="r"><link name="base"><collision>{mesh}</collision></link></robot>')
    robot = robots.load(tmp_path / "r.urdf")
    shape = robot.shapes[0]
    assert (shape.mesh.vertex_count, len(shape.mesh.faces)) == (4, 4)
    a, b, c = shape.points[shape.mesh.faces].transpose(1, 0, 2)
    volume = np.linalg.det(np.stack([a, b, c], 1)).sum() / 6
    assert np.isclose(volume, abs(np.prod(scale)))  # positive: its faces look outward
    world = tamis.World()
    assert world.is_closed(world.add(shape))
    grain = trimesh.creation.box([np.abs(scale).min() * 0.01] * 3)
    inside = tamis.pose_of([0, 0, 0.0], np.array(scale) * [0.3, 0.3, 0.2])
    world.add(tamis.Shape(tamis.Mesh(grain.faces), grain.vertices), inside)
    assert world.has_overlap(include_static=True)


def test_a_package_is_found_around_the_file_or_where_it_is_said(tmp_path: pathlib.Path) -> None:
    (tmp_path / "ws/arm/meshes").mkdir(parents=True)
    (tmp_path / "ws/arm/urdf").mkdir()
    wedge().export(str(tmp_path / "ws/arm/meshes/w.stl"))
    mesh = '<collision><geometry><mesh filename="package://arm/meshes/w.stl"/></geometry></collision>'
    text = f'<robot name="r"><link name="base">{mesh}</link></robot>'
    (tmp_path / "ws/arm/urdf/r.urdf").write_text(text)
    (tmp_path / "r.urdf").write_text(text)
    assert robots.load(tmp_path / "ws/arm/urdf/r.urdf").links == ("base",)
    assert robots.load(tmp_path / "r.urdf", package_dirs=[tmp_path / "ws"]).links == ("base",)
    with pytest.raises(tamis.FileError, match=r"link 'base' names the mesh 'package://arm/meshes/w.stl', which is not"):
        robots.load(tmp_path / "r.urdf")


def test_meshes_that_cannot_be_used_name_their_link(tmp_path: pathlib.Path) -> None:
    mesh = '<collision><geometry><mesh filename="{}"/></geometry></collision>'
    for name, content, sentence in (
        ("w.stl", b"solid nothing", "link 'base': .*w.stl"),
        ("w.obj", b"v 0 0 0\nv 1 0 0\n", "link 'base': .*w.obj"),
        ("w.xyz", b"what", "link 'base': .*w.xyz"),
    ):
        (tmp_path / name).write_bytes(content)
        (tmp_path / "r.urdf").write_text(f'<robot name="r"><link name="base">{mesh.format(name)}</link></robot>')
        with pytest.raises(tamis.FileError, match=sentence):
            robots.load(tmp_path / "r.urdf")


def test_collada_in_other_units(tmp_path: pathlib.Path) -> None:
    """Would catch a file in inches that is read as metres, and one whose up axis programs disagree about."""
    pytest.importorskip("collada", reason="pycollada is not installed: bindings/python/requirements-hosts.txt")
    wedge().export(str(tmp_path / "w.dae"))
    mesh = '<collision><geometry><mesh filename="w.dae"/></geometry></collision>'
    (tmp_path / "r.urdf").write_text(f'<robot name="r"><link name="base">{mesh}</link></robot>')
    text = (tmp_path / "w.dae").read_text()
    up = "<up_axis>Z_UP</up_axis>"
    assert "<asset>" in text
    for unit, size in (("1.0", 3.0), ("0.0254", 3 * 0.0254)):
        start, _, rest = text.partition("<asset>")
        inside, _, after = rest.partition("</asset>")
        dates = inside[: inside.rindex("</modified>") + len("</modified>")]
        (tmp_path / "w.dae").write_text(f'{start}<asset>{dates}<unit name="u" meter="{unit}"/>{up}</asset>{after}')
        assert np.isclose(np.ptp(robots.load(tmp_path / "r.urdf").shapes[0].points[:, 0]), size)
    (tmp_path / "w.dae").write_text((tmp_path / "w.dae").read_text().replace("Z_UP", "Y_UP"))
    with pytest.raises(tamis.FileError, match=r"link 'base': .*w.dae does not say <up_axis>Z_UP"):
        robots.load(tmp_path / "r.urdf")


def test_without_trimesh_a_sentence_says_what_to_install(
    tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    wedge().export(str(tmp_path / "w.stl"))
    mesh = '<collision><geometry><mesh filename="w.stl"/></geometry></collision>'
    (tmp_path / "r.urdf").write_text(f'<robot name="r"><link name="base">{mesh}</link></robot>')
    monkeypatch.setitem(sys.modules, "trimesh", None)
    with pytest.raises(ModuleNotFoundError, match=r"tamis.robots needs trimesh\. trimesh is not installed"):
        robots.load(tmp_path / "r.urdf")
