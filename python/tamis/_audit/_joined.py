"""Several meshes as one, each an object by its name."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tamis import _core
from tamis._arrays import Indices
from tamis._audit._shared import shared_mesh
from tamis._mesh import Mesh


class Part(NamedTuple):
    """One of them."""

    name: str
    vertex_count: int
    faces: Indices


def joined(parts: list[Part]) -> _core.SharedMesh:
    """Make one mesh of them, their vertices one behind the other."""
    ends = np.cumsum([part.vertex_count for part in parts])
    starts = ends - [part.vertex_count for part in parts]
    faces = np.concatenate([part.faces + int(start) for part, start in zip(parts, starts)])
    objects = {part.name: slice(int(start), int(end)) for part, start, end in zip(parts, starts, ends)}
    return shared_mesh(Mesh(faces, int(ends[-1])), objects)
