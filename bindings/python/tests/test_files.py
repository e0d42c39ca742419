"""Mesh files, sequences of frames, and scenes."""

from __future__ import annotations

import pathlib

import numpy as np
import pytest

import tamis


def test_a_mesh_written_and_read(falling: tamis.Scene, tmp_path: pathlib.Path) -> None:
    tamis.write_mesh(tmp_path / "a.ply", falling.start / 3, falling.mesh.faces, edges=[[0, 3]], points=[4])
    read = tamis.read_mesh(tmp_path / "a.ply")
    assert np.array_equal(read.positions, falling.start / 3)
    assert np.array_equal(read.mesh.faces, falling.mesh.faces) and read.mesh.loose_edges.tolist() == [[0, 3]]
    assert read.mesh.loose_points.tolist() == [4]
    assert read.notes == ()


def test_notes_say_what_was_cut(tmp_path: pathlib.Path) -> None:
    (tmp_path / "quad.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
    read = tamis.read_mesh(str(tmp_path / "quad.obj"))
    assert len(read.mesh.faces) == 2 and len(read.notes) == 1


def test_frames_in_natural_order(falling: tamis.Scene, tmp_path: pathlib.Path) -> None:
    for i in (10, 2, 1):
        tamis.write_mesh(tmp_path / f"f{i}.ply", falling.start + i, falling.mesh.faces)
    frames = list(tamis.read_frames(tmp_path))
    assert [frame.positions[0, 0] for frame in frames] == [1, 2, 10]
    assert all(frame.mesh is frames[0].mesh for frame in frames)
    assert len(list(tamis.read_frames(tmp_path / "f1.ply", tmp_path / "f2.ply"))) == 2


def test_polygons_are_cut_inside(tmp_path: pathlib.Path) -> None:
    corners = "v 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\n"
    (tmp_path / "l.obj").write_text(corners + "f 1 2 3 4 5 6\n")
    read = tamis.read_mesh(tmp_path / "l.obj")
    assert not tamis.Detector(read.mesh).has_intersection(read.positions)


def test_frames_share_the_triangles_of_the_first(tmp_path: pathlib.Path) -> None:
    for i, corner in ((1, "2 2"), (2, "0.1 0.1"), (4, "2 2")):
        (tmp_path / f"f{i}.obj").write_text(f"v 0 0 0\nv 2 0 0\nv {corner} 0\nv 0 2 0\nf 2 3 4 1\n")
    frames = list(tamis.read_frames(tmp_path))
    assert all(frame.mesh is frames[0].mesh for frame in frames)
    assert frames[2].notes[-1] == "frame 3 is missing before this one: no step leads here"


def test_welding(tmp_path: pathlib.Path) -> None:
    split = tamis.Mesh([[0, 1, 2], [3, 4, 5]], edges=[[3, 0]], points=[5])
    start = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0], [0, 1.25, 0]])
    assert tamis.weld(split, start).faces.tolist() == [[0, 1, 2], [1, 4, 5]]
    welded = tamis.weld(split, [start, start + 1], distance=0.25)
    assert welded.faces.tolist() == [[0, 1, 2], [1, 4, 2]] and welded.loose_edges.tolist() == [[1, 0]]
    assert welded.loose_points.tolist() == [2] and welded.vertex_count == 6
    apart = start.copy()
    apart[3] += 1
    assert tamis.weld(split, [start, apart]).faces.tolist() == split.faces.tolist()
    for wrong in (start[:5], np.zeros((0, 6, 3)), start[0]):
        with pytest.raises(tamis.InvalidMesh):
            tamis.weld(split, wrong)
    with pytest.raises(tamis.InvalidOptions):
        tamis.weld(split, start, distance=-1)


def test_frames_of_two_meshes(falling: tamis.Scene, tmp_path: pathlib.Path) -> None:
    tamis.write_mesh(tmp_path / "a1.ply", falling.start, falling.mesh.faces)
    tamis.write_mesh(tmp_path / "a2.ply", falling.start, falling.mesh.faces[:, ::-1])
    with pytest.raises(tamis.FileError, match=r"a2\.ply"):
        list(tamis.read_frames(tmp_path))


def test_files_that_cannot_be_used(falling: tamis.Scene, tmp_path: pathlib.Path) -> None:
    (tmp_path / "bad.ply").write_text("ply\nformat ascii 1.0\nelement vertex 9\n")
    for name in ("bad.ply", "nowhere.ply"):
        with pytest.raises(tamis.FileError, match=name):
            tamis.read_mesh(tmp_path / name)
    with pytest.raises(tamis.FileError, match="nowhere"):
        list(tamis.read_frames(tmp_path / "nowhere"))
    with pytest.raises(tamis.FileError):
        tamis.write_mesh(tmp_path / "nowhere" / "a.ply", falling.start, falling.mesh.faces)
    with pytest.raises(tamis.FileError, match="a name that ends in"):
        tamis.write_mesh(tmp_path / "a.obj", falling.start, falling.mesh.faces)
    with pytest.raises(tamis.InvalidMesh):
        tamis.write_mesh(tmp_path / "a.ply", falling.start, [[0, 1, 6]])
    assert not (tmp_path / "a.ply").exists()


@pytest.mark.parametrize("name", tamis.scene_names())
def test_every_scene(name: str) -> None:
    made = tamis.scene(name, 60, seed=2)
    assert made.start.shape == made.end.shape == (made.mesh.vertex_count, 3)
    assert made.groups.shape == (made.mesh.vertex_count,)
    again = tamis.scene(name, 60, seed=2)
    assert np.array_equal(made.end, again.end)


def test_scenes_that_are_not_there() -> None:
    for arguments in (("moon", 10), ("soup", 0)):
        with pytest.raises(tamis.InvalidOptions):
            tamis.scene(*arguments)


def test_simulated_frames(tmp_path: pathlib.Path) -> None:
    assert "cloth-ball" in tamis.simulated_scenes()
    frames = list(tamis.simulate("cloth-ball", tmp_path / "run", triangles=500, frames=2))
    assert len(frames) == 3 and frames[0].mesh is frames[2].mesh
    assert not np.array_equal(frames[0].positions, frames[2].positions)
    detector = tamis.Detector(frames[0].mesh)
    assert not any(detector.has_intersection(frame.positions) for frame in frames)
    again = list(tamis.simulate("cloth-ball", tmp_path / "run", triangles=500, frames=3))
    assert np.array_equal(again[2].positions, frames[2].positions) and len(again) == 4


def test_bad_simulations(tmp_path: pathlib.Path) -> None:
    with pytest.raises(tamis.InvalidOptions, match="cloth-ball"):
        tamis.simulate("unknown", tmp_path)
    for wrong in ({"triangles": 3}, {"frames": -1}, {"seed": -1}):
        with pytest.raises(tamis.InvalidOptions, match="give a whole number"):
            tamis.simulate("cloth-ball", tmp_path, **wrong)
