"""Joins meshes into one. Each becomes an object with a name."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tamis import _core
from tamis._arrays import Indices
from tamis._audit._shared import shared_mesh
from tamis._mesh import Mesh


class Part(NamedTuple):
    """One of the meshes to join."""

    name: str
    vertex_count: int
    faces: Indices


def joined(parts: list[Part]) -> _core.SharedMesh:
    """Return one mesh with the vertices of all parts, in their order."""
    ends = np.cumsum([part.vertex_count for part in parts])
    starts = ends - [part.vertex_count for part in parts]
    faces = np.concatenate([part.faces + int(start) for part, start in zip(parts, starts)])
    objects = {part.name: slice(int(start), int(end)) for part, start, end in zip(parts, starts, ends)}
    return shared_mesh(Mesh(faces, int(ends[-1])), objects)
