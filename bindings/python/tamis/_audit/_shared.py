"""The mesh of an audit with its objects, shared by frames."""

from __future__ import annotations

from typing import Any, Union

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import Indices, indices
from tamis._checks import shown, word
from tamis._errors import InvalidMesh
from tamis._mesh import Mesh, known_mesh

Objects = Union[npt.ArrayLike, "dict[str, Any]"]


def shared_mesh(mesh: Mesh, objects: Objects | None = None) -> _core.SharedMesh:
    """Return the mesh with the caller's objects; for None each connected part is an object, without a name."""
    known = known_mesh(mesh)
    names: list[str] = []
    if isinstance(objects, dict):
        names = [word(name, "a name in objects") for name in objects]
        numbers = _of_names(objects, known.vertex_count)
    else:
        numbers = _of_array(objects, known.vertex_count)
    return _core.shared_mesh(known._mesh, numbers, names)


def _of_array(objects: npt.ArrayLike | None, count: int) -> Indices:
    if objects is None:
        return np.empty(0, np.int32)
    numbers = indices(objects, 0, "objects", InvalidMesh)
    if len(numbers) != count:
        raise InvalidMesh(f"objects has {len(numbers)} numbers for {count} vertices: give the object of each vertex")
    return numbers


def _of_names(objects: dict[str, Any], count: int) -> Indices:
    numbers = np.full(count, -1, np.int32)
    for number, (name, vertices) in enumerate(objects.items()):
        chosen = vertices if isinstance(vertices, slice) else indices(vertices, 0, f"objects[{name!r}]", InvalidMesh)
        try:
            numbers[chosen] = number
        except (IndexError, TypeError):
            raise InvalidMesh(
                f"objects[{name!r}] is {shown(vertices)}, and the mesh has {count} vertices: give vertices that it has"
            ) from None
    return numbers
