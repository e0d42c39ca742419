"""Nodes of a glTF file that have a mesh, and where its vertices are in a pose."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles, Indices
from tamis._audit._gltf_animation import Pose
from tamis._audit._gltf_buffers import Buffers
from tamis._errors import FileError

_Whole = npt.NDArray[np.int64]


class _Skin:
    """The joints of a mesh, and the joints and weights of each vertex."""

    def __init__(self, given: Any, buffers: Buffers, joints: _Whole, weights: Doubles) -> None:
        self.nodes: list[int] = list(given.joints)
        count = len(self.nodes)
        unbound = given.inverseBindMatrices is None
        rows = np.tile(np.eye(4).reshape(16), (count, 1)) if unbound else buffers.doubles(given.inverseBindMatrices)
        self.inverse = rows.reshape(count, 4, 4).transpose(0, 2, 1)
        self.joints, self.weights = joints, weights / weights.sum(axis=1, keepdims=True)

    def points(self, pose: Pose, points: Doubles) -> Doubles:
        matrices = np.stack([pose.world(node) for node in self.nodes]) @ self.inverse
        mixed = np.einsum("vj,vjab->vab", self.weights, matrices[self.joints])
        moved: Doubles = np.einsum("vab,vb->va", mixed[:, :3, :3], points) + mixed[:, :3, 3]
        return moved


class MovingNode:
    """A node with its mesh: triangles over joined vertices, morph targets, perhaps a skin."""

    def __init__(self, gltf: Any, node: int, buffers: Buffers, file: str) -> None:
        given = gltf.nodes[node]
        mesh = gltf.meshes[given.mesh]
        self._node = node
        self.name = given.name or mesh.name or f"node {node}"
        parts = [_Primitive(primitive, buffers, f"{file}: {self.name}") for primitive in mesh.primitives]
        parts = [part for part in parts if len(part.faces)]
        ends = np.cumsum([0] + [len(part.base) for part in parts])
        columns = _stacked([part.columns() for part in parts], f"{file}: {self.name}")
        kept, place = _joined(columns)
        faces = [place[part.faces + first] for part, first in zip(parts, ends[:-1])]
        self.faces: Indices = np.concatenate(faces).astype(np.int32) if parts else np.empty((0, 3), np.int32)
        self.vertex_count = len(kept)
        self._base = columns[kept, :3]
        count = len(parts[0].targets) if parts else 0
        self._targets = columns[kept, 3 : 3 + 3 * count].reshape(self.vertex_count, count, 3)
        self._default = np.asarray(getattr(given, "weights", None) or mesh.weights or [0.0] * count, np.float64)
        rest = columns[kept, 3 + 3 * count :]
        half = rest.shape[1] // 2
        is_skinned = given.skin is not None and half > 0
        self._skin = (
            _Skin(gltf.skins[given.skin], buffers, rest[:, :half].astype(int), rest[:, half:]) if is_skinned else None
        )

    def points(self, pose: Pose) -> Doubles:
        """Return where the vertices are in world space."""
        points = self._base
        if self._targets.shape[1]:
            points = points + np.einsum("t,vtx->vx", pose.weights(self._node, self._default), self._targets)
        if self._skin is not None:
            return self._skin.points(pose, points)
        matrix = pose.world(self._node)
        placed: Doubles = points @ matrix[:3, :3].T + matrix[:3, 3]
        return points if np.array_equal(matrix, np.eye(4)) else placed


class _Primitive:
    """A part of a mesh that has one material."""

    def __init__(self, given: Any, buffers: Buffers, where: str) -> None:
        attributes = given.attributes
        if attributes.POSITION is None:
            raise FileError(f"{where}: a part of it has no positions: export the file again")
        self.base = buffers.doubles(attributes.POSITION)
        self.targets = [_delta(target, buffers, len(self.base)) for target in given.targets or []]
        self.joints = [buffers.whole(a).astype(float) for a in _numbered(attributes, "JOINTS_")]
        self.weights = [buffers.doubles(a) for a in _numbered(attributes, "WEIGHTS_")]
        corners = np.arange(len(self.base)) if given.indices is None else buffers.whole(given.indices)[:, 0]
        if len(corners) and not 0 <= corners.min() <= corners.max() < len(self.base):
            raise FileError(f"{where}: an index is none of its {len(self.base)} vertices: export the file again")
        self.faces = _triangles(corners, 4 if given.mode is None else given.mode)

    def columns(self) -> Doubles:
        """Return one row a vertex with all data that decide where it is: position, morph targets, joints, weights."""
        return np.concatenate([self.base, *self.targets, *self.joints, *self.weights], axis=1)


def _stacked(parts: list[Doubles], where: str) -> Doubles:
    if len({part.shape[1] for part in parts}) > 1:
        raise FileError(f"{where}: its parts have other morph targets or joints than each other: export the file again")
    return np.concatenate(parts) if parts else np.empty((0, 3))


def _delta(target: Any, buffers: Buffers, count: int) -> Doubles:
    accessor = target.get("POSITION") if isinstance(target, dict) else target.POSITION
    return np.zeros((count, 3)) if accessor is None else buffers.doubles(accessor)


def _numbered(attributes: Any, name: str) -> list[int]:
    """Return the accessors of JOINTS_0, JOINTS_1 and so on."""
    found = [getattr(attributes, f"{name}{i}", None) for i in range(8)]
    return [accessor for accessor in found if accessor is not None]


def _triangles(corners: _Whole, mode: int) -> _Whole:
    """Return the triangles of a list (mode 4), a strip (5) or a fan (6); points and lines have none."""
    if mode == 4:
        return corners[: len(corners) // 3 * 3].reshape(-1, 3)
    if mode not in (5, 6) or len(corners) < 3:
        return np.empty((0, 3), np.int64)
    i = np.arange(len(corners) - 2)
    if mode == 6:
        return np.stack([corners[i + 1], corners[i + 2], np.full(len(i), corners[0])], axis=1)
    return np.stack([corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]], axis=1)


def _joined(columns: Doubles) -> tuple[_Whole, _Whole]:
    """Join vertices with equal rows, which no motion separates: return the rows to keep, and each vertex' new place."""
    _, kept, place = np.unique(columns, axis=0, return_index=True, return_inverse=True)
    order = np.argsort(kept)
    place_of = np.empty_like(order)
    place_of[order] = np.arange(len(order))
    return kept[order], place_of[place.reshape(-1)]


def moving_nodes(gltf: Any, buffers: Buffers, file: str) -> list[MovingNode]:
    """Return the nodes of the scene whose mesh has triangles, with different names; raise if there is none."""
    placed = [i for i in _nodes_of_scene(gltf) if gltf.nodes[i].mesh is not None]
    nodes = [node for node in (MovingNode(gltf, i, buffers, file) for i in placed) if len(node.faces)]
    if not nodes:
        raise FileError(f"{file}: no node with triangles in it: give a file that has meshes in a scene")
    names: dict[str, int] = {}
    for node in nodes:
        names[node.name] = names.get(node.name, 0) + 1
        if names[node.name] > 1:
            node.name = f"{node.name} ({names[node.name]})"
    return nodes


def _nodes_of_scene(gltf: Any) -> list[int]:
    """Return the nodes of the default scene, else of the first scene; all nodes if the file has no scenes."""
    if not gltf.scenes:
        return list(range(len(gltf.nodes or [])))
    found: set[int] = set()
    left = list(gltf.scenes[gltf.scene or 0].nodes or [])
    while left:
        node = left.pop()
        if node not in found:
            found.add(node)
            left += gltf.nodes[node].children or []
    return sorted(found)
