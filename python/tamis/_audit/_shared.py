"""The mesh of an audit, with its objects."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import Indices, indices
from tamis._checks import instance, shown, word
from tamis._errors import InvalidMesh
from tamis._mesh import Mesh


def shared_mesh(
    mesh: Mesh, objects: npt.ArrayLike | dict[str, Any] | None = None
) -> tuple[_core.SharedMesh, list[str]]:
    """Return the mesh as frames share it, and the names of its objects."""
    known = instance(mesh, Mesh, "mesh", "a tamis.Mesh, as of tamis.Mesh(faces)", InvalidMesh)
    names = [word(name, "a name in objects") for name in objects] if isinstance(objects, dict) else []
    numbers = _of_names(objects, known.vertex_count) if isinstance(objects, dict) else _of_array(objects)
    return _core.shared_mesh(known._mesh, numbers, names), names


def _of_array(objects: npt.ArrayLike | None) -> Indices:
    return np.empty(0, np.int32) if objects is None else indices(objects, 0, "objects", InvalidMesh)


def _of_names(objects: dict[str, Any], count: int) -> Indices:
    numbers = np.full(count, -1, np.int32)
    for number, (name, vertices) in enumerate(objects.items()):
        chosen = vertices if isinstance(vertices, slice) else indices(vertices, 0, f"objects[{name!r}]", InvalidMesh)
        try:
            numbers[chosen] = number
        except IndexError:
            raise InvalidMesh(
                f"objects[{name!r}] is {shown(vertices)}, and the mesh has {count} vertices: give vertices that it has"
            ) from None
    return numbers
