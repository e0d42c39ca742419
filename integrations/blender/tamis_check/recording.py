# SPDX-License-Identifier: GPL-3.0-or-later
"""What objects look like in one frame, modifiers and caches applied: one mesh of all of them, in world coordinates."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import bpy
import numpy as np

from .library import Trouble

# What Blender makes meshes of; and what has none and may be in the way of the cloth all the same.
_WITH_MESH = {"MESH", "CURVE", "SURFACE", "FONT"}
_WITHOUT_SHAPE = {"ARMATURE", "CAMERA", "LATTICE", "LIGHT", "LIGHT_PROBE", "SPEAKER"}


def readable(selected: list[Any]) -> tuple[list[Any], list[str]]:
    """Return the objects that have a mesh or are converted to one, and the names of those that show something else."""
    shows = [thing for thing in selected if thing.type not in _WITH_MESH | _WITHOUT_SHAPE]
    other = [thing.name for thing in shows if thing.type != "EMPTY" or thing.instance_type == "COLLECTION"]
    other += [f"hair of {thing.name}" for thing in selected if any(map(_is_hair, thing.particle_systems))]
    return [thing for thing in selected if thing.type in _WITH_MESH], other


def _is_hair(system: Any) -> bool:
    return system.settings.type == "HAIR" and system.settings.render_type == "PATH"


def besides_meshes(objects: list[Any], depsgraph: Any) -> list[str]:
    """What objects show in this frame that is in none of their meshes: instances, or curves, points and volumes."""
    names = {thing.name_full for thing in objects}
    found = {}
    for shown in depsgraph.object_instances:
        if not shown.is_instance or not shown.parent or _is_mesh_of_curve(shown):
            continue
        kind = "instances" if shown.object.type in _WITH_MESH - {"CURVE"} else shown.object.type.lower()
        if shown.parent.original.name_full in names:
            found[f"{kind} of {shown.parent.original.name}"] = True
    return list(found)


def _is_mesh_of_curve(shown: Any) -> bool:
    """Blender lists the mesh that it makes of a curve as an instance of the curve, not within another one."""
    not_within = 0x7FFFFFFF
    return shown.parent.type != "MESH" and shown.object.type == "MESH" and shown.persistent_id[1] == not_within


class Selection:
    """What is checked, by name: once the user has undone something, Python's references to it lead nowhere."""

    def __init__(self, scene: Any, view_layer: Any, objects: list[Any]) -> None:
        self._scene, self._view_layer = scene.name_full, view_layer.name
        self.names = [thing.name_full for thing in objects]

    def scene(self) -> Any:
        """Return it, or None once it is gone."""
        return next((scene for scene in bpy.data.scenes if scene.name_full == self._scene), None)

    def at(self, frame: int) -> tuple[list[Any], Any]:
        """Go to a frame; return the objects that are shown there, and what evaluates them.

        Raises
        ------
        Trouble
            One of them is gone.
        """
        scene = self.scene()
        if scene is None or self._view_layer not in scene.view_layers:
            raise Trouble("the scene was removed or renamed while it was checked: check it again")
        scene.frame_set(frame)
        view_layer = scene.view_layers[self._view_layer]
        view_layer.update()
        there = {thing.name_full: thing for thing in scene.objects}
        gone = [name for name in self.names if name not in there]
        if gone:
            raise Trouble(f"{gone[0]} was removed or renamed while it was checked: select what is there, check again")
        objects = [there[name] for name in self.names]
        # Blender leaves an object where it was when it was hidden.
        return [thing for thing in objects if thing.visible_get(view_layer=view_layer)], view_layer.depsgraph


@dataclass(frozen=True)
class Topology:
    """The topology of all objects together; the vertices of each follow those of the one before."""

    names: list[str]
    vertex_counts: list[int]
    triangles: np.ndarray
    face_of_triangle: np.ndarray  # numbered in each object from 0
    loose_edges: np.ndarray

    @property
    def first_vertices(self) -> np.ndarray:
        """The first vertex of each object, and the number of all vertices."""
        return np.concatenate([[0], np.cumsum(self.vertex_counts)])

    @property
    def is_empty(self) -> bool:
        """Tell whether there are neither faces nor edges."""
        return len(self.triangles) + len(self.loose_edges) == 0

    def vertices_of(self) -> dict[str, Any]:
        """Return the range of each object's vertices, by the object's name."""
        first = self.first_vertices
        return {name: range(int(a), int(b)) for name, a, b in zip(self.names, first[:-1], first[1:])}


def frame_of(objects: list[Any], depsgraph: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return the world positions of all vertices, shape (n, 3), and an array that changes only if the topology does."""
    parts = [_with_mesh(thing, depsgraph, lambda *of: (_points(*of), _corners(*of))) for thing in objects]
    points, corners = [[part[i] for part in parts] for i in (0, 1)]
    return np.vstack([np.empty((0, 3)), *points]), np.concatenate([np.empty(0, np.int32), *corners])


_NO_ROWS = np.empty((0, 3), np.int32)  # where no object is shown


def topology_of(objects: list[Any], depsgraph: Any) -> Topology:
    """Return the topology, with faces cut into triangles as in this frame; later frames keep these triangles."""
    parts = [_with_mesh(thing, depsgraph, _part) for thing in objects]
    counts = [part["vertices"] for part in parts]
    first = np.concatenate([[0], np.cumsum(counts)])
    return Topology(
        names=[thing.name_full for thing in objects],
        vertex_counts=counts,
        triangles=np.vstack([_NO_ROWS[:, :3], *(part["triangles"] + n for part, n in zip(parts, first))]),
        face_of_triangle=np.concatenate([_NO_ROWS[:, 0], *(part["face_of_triangle"] for part in parts)]),
        loose_edges=np.vstack([_NO_ROWS[:, :2], *(part["loose_edges"] + n for part, n in zip(parts, first))]),
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
