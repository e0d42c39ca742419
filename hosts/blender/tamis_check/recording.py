# SPDX-License-Identifier: GPL-3.0-or-later
"""What objects look like in one frame, all modifiers and caches applied: one mesh of all of them, in world coordinates."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from .library import Trouble


# What Blender makes meshes of; and what has none and may be in the way of the cloth all the same.
_WITH_MESH = {"MESH", "CURVE", "SURFACE", "FONT"}
_WITHOUT_SHAPE = {"ARMATURE", "CAMERA", "LATTICE", "LIGHT", "LIGHT_PROBE", "SPEAKER"}


def readable(selected: list[Any]) -> tuple[list[Any], list[str]]:
    """Objects that have a mesh, or are made one; and the names of those that show something else."""
    shows = [thing for thing in selected if thing.type not in _WITH_MESH | _WITHOUT_SHAPE]
    other = [thing.name for thing in shows if thing.type != "EMPTY" or thing.instance_type == "COLLECTION"]
    return [thing for thing in selected if thing.type in _WITH_MESH], other


def instancers(objects: list[Any], depsgraph: Any) -> list[str]:
    """Names of objects that show others, or parts, in many places: these instances are in none of their meshes."""
    found = set()
    for shown in depsgraph.object_instances:
        # The mesh of a curve is an instance of the curve.
        if shown.is_instance and shown.parent and shown.instance_object.original != shown.parent.original:
            found.add(shown.parent.original.name)
    return [thing.name for thing in objects if thing.name in found]


@dataclass(frozen=True)
class Topology:
    """Of all objects together; vertices of each follow those of the one before."""

    names: list[str]
    vertex_counts: list[int]
    triangles: np.ndarray
    face_of_triangle: np.ndarray  # of each object from 0
    loose_edges: np.ndarray

    @property
    def first_vertices(self) -> np.ndarray:
        """Where each object begins, and where the last one ends."""
        return np.concatenate([[0], np.cumsum(self.vertex_counts)])

    def vertices_of(self) -> dict[str, Any]:
        """The range of each object's vertices, by its name."""
        first = self.first_vertices
        return {name: range(int(a), int(b)) for name, a, b in zip(self.names, first[:-1], first[1:])}


def frame_of(objects: list[Any], depsgraph: Any) -> tuple[np.ndarray, np.ndarray]:
    """World positions of all vertices, (n, 3); and how faces and edges are made of them: the same while topology is."""
    parts = [_with_mesh(thing, depsgraph, lambda *of: (_points(*of), _corners(*of))) for thing in objects]
    points, corners = zip(*parts)
    return np.vstack(points), np.concatenate(corners)


def topology_of(objects: list[Any], depsgraph: Any) -> Topology:
    """Triangles as Blender cuts faces in this frame; they stay so in all later ones."""
    parts = [_with_mesh(thing, depsgraph, _part) for thing in objects]
    counts = [part["vertices"] for part in parts]
    first = np.concatenate([[0], np.cumsum(counts)])
    if not sum(len(part["triangles"]) + len(part["loose_edges"]) for part in parts):
        raise Trouble("what is selected has no faces and no edges in this frame: select meshes that have some")
    return Topology(
        names=[thing.name for thing in objects],
        vertex_counts=counts,
        triangles=np.vstack([part["triangles"] + n for part, n in zip(parts, first)]),
        face_of_triangle=np.concatenate([part["face_of_triangle"] for part in parts]),
        loose_edges=np.vstack([part["loose_edges"] + n for part, n in zip(parts, first)]),
    )


def _with_mesh(thing: Any, depsgraph: Any, read: Any) -> Any:
    evaluated = thing.evaluated_get(depsgraph)
    mesh = evaluated.to_mesh()
    try:
        return read(mesh, evaluated)
    finally:
        evaluated.to_mesh_clear()


def _get(things: Any, name: str, columns: int, kind: Any) -> np.ndarray:
    values = np.empty(len(things) * columns, kind)
    things.foreach_get(name, values)
    return values.reshape(-1, columns) if columns > 1 else values


def _points(mesh: Any, evaluated: Any) -> np.ndarray:
    local = _get(mesh.vertices, "co", 3, np.float32).astype(float)
    world = np.array(evaluated.matrix_world, dtype=float)
    return local @ world[:3, :3].T + world[:3, 3]


def _corners(mesh: Any, evaluated: Any) -> np.ndarray:
    sizes = _get(mesh.polygons, "loop_total", 1, np.int32)
    ends = _get(mesh.edges, "vertices", 2, np.int32)
    corners = _get(mesh.loops, "vertex_index", 1, np.int32)
    return np.concatenate([[len(mesh.vertices), len(sizes), len(ends)], sizes, ends.ravel(), corners])


def _part(mesh: Any, evaluated: Any) -> dict[str, Any]:
    mesh.calc_loop_triangles()
    used = _get(mesh.loops, "edge_index", 1, np.int32)
    ends = _get(mesh.edges, "vertices", 2, np.int32)
    return {
        "vertices": len(mesh.vertices),
        "triangles": _get(mesh.loop_triangles, "vertices", 3, np.int32),
        "face_of_triangle": _get(mesh.loop_triangles, "polygon_index", 1, np.int32),
        "loose_edges": np.delete(ends, np.unique(used), axis=0),
    }
