"""Audits of glTF files; skipped where pygltflib is not installed."""

from __future__ import annotations

import pathlib
from typing import Any

import numpy as np
import pytest

import tamis

gltf = pytest.importorskip("pygltflib")

# A square whose two triangles share no vertex, as in files where normals differ.
_FLOOR = np.array([[-1, -1, 0], [2, -1, 0], [2, 2, 0], [-1, -1, 0], [2, 2, 0], [-1, 2, 0]], "<f4")
_SPIKE = np.array([[0, 0.1, 1], [0.3, 0, 1.5], [0, 0.3, 1.5]], "<f4")
_TURN = [0.0, 0.0, np.sin(np.pi / 4), np.cos(np.pi / 4)]


class _File:
    """Builds a file."""

    def __init__(self) -> None:
        self.blob = bytearray()
        self.gltf = gltf.GLTF2(scene=0, scenes=[gltf.Scene(nodes=[0, 1])], accessors=[], bufferViews=[])
        self.gltf.nodes = [gltf.Node(mesh=0, name="floor"), gltf.Node(mesh=1, name="spike")]
        floor = gltf.Primitive(attributes=gltf.Attributes(POSITION=self.add(_FLOOR)))
        corners = self.add(np.array([[0], [1], [2]], "<u2"))
        self.spike = gltf.Primitive(attributes=gltf.Attributes(POSITION=self.add(_SPIKE)), indices=corners)
        self.gltf.meshes = [gltf.Mesh(primitives=[floor]), gltf.Mesh(primitives=[self.spike])]

    def add(self, array: Any) -> int:
        """Add an accessor."""
        kind = {1: "SCALAR", 3: "VEC3", 4: "VEC4", 16: "MAT4"}[array.shape[1]]
        number = {"f4": gltf.FLOAT, "u2": gltf.UNSIGNED_SHORT, "u1": gltf.UNSIGNED_BYTE}[array.dtype.str[1:]]
        view = gltf.BufferView(buffer=0, byteOffset=len(self.blob), byteLength=array.nbytes)
        self.gltf.bufferViews.append(view)
        self.blob += array.tobytes() + bytes(-array.nbytes % 4)
        place = len(self.gltf.bufferViews) - 1
        self.gltf.accessors.append(gltf.Accessor(bufferView=place, componentType=number, count=len(array), type=kind))
        return len(self.gltf.accessors) - 1

    def animate(self, node: int, path: str, values: Any, how: str = "LINEAR", seconds: float = 1.0) -> None:
        """Animate a property of a node, from the first value to the last."""
        keys = len(values) // (3 if how == "CUBICSPLINE" else 1)
        times = np.linspace(0, seconds, keys, dtype="<f4")[:, np.newaxis]
        sampler = gltf.AnimationSampler(
            input=self.add(times), output=self.add(np.array(values, "<f4")), interpolation=how
        )
        channel = gltf.AnimationChannel(sampler=0, target=gltf.AnimationChannelTarget(node=node, path=path))
        self.gltf.animations.append(gltf.Animation(name=path, samplers=[sampler], channels=[channel]))

    def save(self, path: pathlib.Path) -> pathlib.Path:
        self.gltf.buffers = [gltf.Buffer(byteLength=len(self.blob))]
        self.gltf.set_binary_blob(bytes(self.blob))
        if path.suffix == ".gltf":
            self.gltf.convert_buffers(gltf.BufferFormat.DATAURI)
        self.gltf.save(str(path))
        return path


def _check(path: pathlib.Path) -> tamis.AuditReport:
    """The spike goes down by 2 in a second, and meets the floor after half a second."""
    report = tamis.audit(tamis.read_gltf(path, frames_per_second=5))
    assert report.frames.names == ["0 s", "0.2 s", "0.4 s", "0.6 s", "0.8 s", "1 s"]
    assert report.first_bad is not None and report.first_bad.frame == 3
    first = report.pairs[(report.pairs.kind == tamis.AuditKind.VERTEX_FACE) & (report.pairs.frame == 3)]
    assert abs(first.toi_upper[0] - 0.5) < 1e-5
    assert {frozenset(pair.objects) for pair in report.pairs} == {frozenset({"floor", "spike"})}
    return report


def test_nodes_that_move(tmp_path: pathlib.Path) -> None:
    file = _File()
    file.animate(1, "translation", [[0, 0, 0], [0, 0, -2]])
    _check(file.save(tmp_path / "a.glb"))
    _check(file.save(tmp_path / "a.gltf"))


def test_morph_targets(tmp_path: pathlib.Path) -> None:
    file = _File()
    file.spike.targets = [{"POSITION": file.add(np.array([[0, 0, -2]] * 3, "<f4"))}]
    file.animate(1, "weights", [[0], [1]])
    _check(file.save(tmp_path / "a.glb"))


def test_skins(tmp_path: pathlib.Path) -> None:
    file = _File()
    file.gltf.nodes += [gltf.Node(name="bone", translation=[0, 0, 7]), gltf.Node(name="root", children=[2])]
    inverse = np.eye(4, dtype="<f4")
    inverse[3, 2] = -7  # columns are stored one after the other: the bone's rest is at z = 7
    file.gltf.skins = [
        gltf.Skin(
            joints=[2, 3], inverseBindMatrices=file.add(np.stack([inverse, np.eye(4, dtype="<f4")]).reshape(2, 16))
        )
    ]
    file.gltf.nodes[1].skin = 0
    file.spike.attributes.JOINTS_0 = file.add(np.zeros((3, 4), "u1"))
    file.spike.attributes.WEIGHTS_0 = file.add(np.array([[1, 0, 0, 0]] * 3, "<f4"))
    file.animate(2, "translation", [[0, 0, 7], [0, 0, 5]])
    _check(file.save(tmp_path / "a.glb"))


def test_rotations_and_splines(tmp_path: pathlib.Path) -> None:
    turned = _File()
    turned.animate(1, "rotation", [[0, 0, 0, 1], _TURN])
    motion = tamis.read_gltf(turned.save(tmp_path / "a.glb"), frames_per_second=2)
    middle = list(motion._frames())[1].positions
    assert middle is not None
    angle = np.pi / 4
    expected = [_SPIKE[1, 0] * np.cos(angle), _SPIKE[1, 0] * np.sin(angle), 1.5]
    assert np.allclose(middle[len(middle) - 2], expected, atol=1e-6)
    spline = _File()
    flat = [0, 0, 0]
    spline.animate(1, "translation", [flat, flat, flat, flat, [0, 0, -2], flat], "CUBICSPLINE")
    quarter = list(tamis.read_gltf(spline.save(tmp_path / "b.glb"), frames_per_second=4)._frames())[1].positions
    assert quarter is not None and np.isclose(quarter[-1, 2], 1.5 - 2 * (3 / 16 - 2 / 64))


def test_vertices_that_stand_at_one_place_are_joined(tmp_path: pathlib.Path) -> None:
    file = _File()
    file.gltf.nodes.pop()
    file.gltf.scenes[0].nodes = [0]
    report = tamis.audit(file.save(tmp_path / "a.glb"))
    assert report.is_free and len(report.frames) == 1, "two triangles that share an edge would touch"


def test_nodes_outside_of_the_scene(tmp_path: pathlib.Path) -> None:
    file = _File()
    file.animate(1, "translation", [[0, 0, 0], [0, 0, -2]])
    file.gltf.nodes += [gltf.Node(name="spare", mesh=1), gltf.Node(name="both", children=[0, 1])]
    file.gltf.scenes = [gltf.Scene(nodes=[2]), gltf.Scene(nodes=[3])]
    file.gltf.scene = 1
    _check(file.save(tmp_path / "a.glb"))


def test_what_is_not_followed_is_said(tmp_path: pathlib.Path) -> None:
    file = _File()
    file.animate(1, "translation", [[0, 0, 0], [0, 0, -2]])
    file.gltf.animations[0].channels.append(
        gltf.AnimationChannel(sampler=0, target=gltf.AnimationChannelTarget(path="pointer"))
    )
    file.gltf.extensionsUsed = ["EXT_mesh_gpu_instancing", "KHR_animation_pointer"]
    note = _check(file.save(tmp_path / "a.glb")).notes[0]
    assert "EXT_mesh_gpu_instancing" in note and "KHR_animation_pointer" in note


def test_what_cannot_be_used(tmp_path: pathlib.Path) -> None:
    with pytest.raises(tamis.FileError, match="cannot be read as glTF"):
        tamis.audit(tmp_path / "none.glb")
    file = _File()
    file.animate(1, "translation", [[0, 0, 0], [0, 0, -2]])
    path = file.save(tmp_path / "a.glb")
    with pytest.raises(tamis.InvalidOptions, match="no animation 'walk'"):
        tamis.read_gltf(path, animation="walk")
    with pytest.raises(tamis.InvalidOptions, match="frames_per_second"):
        tamis.read_gltf(path, frames_per_second=0)
    file.gltf.extensionsRequired = ["KHR_draco_mesh_compression"]
    with pytest.raises(tamis.FileError, match="KHR_draco_mesh_compression"):
        tamis.read_gltf(file.save(tmp_path / "b.glb"))
    file.gltf.extensionsRequired = []
    file.gltf.accessors[0].count = 1000
    with pytest.raises(tamis.FileError, match="accessor 0 is not sound"):
        tamis.read_gltf(file.save(tmp_path / "c.glb"))


def test_nodes_that_are_no_tree(tmp_path: pathlib.Path) -> None:
    file = _File()
    nodes = file.gltf.nodes
    nodes += [gltf.Node(children=[len(nodes) + i + 1]) for i in range(3000)]  # more than Python's recursion limit
    nodes[-1].children = [1]
    file.animate(2, "translation", [[0, 0, 0], [0, 0, -2]])
    file.gltf.scenes = [gltf.Scene(nodes=[0, 2, 0])]
    _check(file.save(tmp_path / "deep.glb"))
    nodes[1].children = [2]
    with pytest.raises(tamis.FileError, match="is below itself"):
        tamis.read_gltf(file.save(tmp_path / "round.glb"))
    nodes[1].children = [9999]
    with pytest.raises(tamis.FileError, match="do not fit each other"):
        tamis.read_gltf(file.save(tmp_path / "none.glb"))


def test_version_1_is_refused_with_a_sentence(tmp_path: pathlib.Path) -> None:
    (tmp_path / "old.gltf").write_text('{"asset": {"version": "1.0"}, "meshes": {"a": {"primitives": []}}}')
    (tmp_path / "bare.gltf").write_text('{"meshes": {"a": {"primitives": []}}}')
    (tmp_path / "old.glb").write_bytes(b"glTF\1\0\0\0" + bytes(20))
    for name in ("old.gltf", "bare.gltf", "old.glb"):
        with pytest.raises(tamis.FileError, match="glTF 1 is not read: export it as glTF 2"):
            tamis.read_gltf(tmp_path / name)
