"""The features of pairs of bodies, found in the meshes of these bodies."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Union

import numpy as np

from tamis._arrays import Indices
from tamis._checks import instance
from tamis._errors import InvalidMesh
from tamis._mesh import Mesh

Meshes = Union[Mapping[int, Mesh], Sequence[Mesh]]


def places_of(features: Indices, bodies: Indices, meshes: Meshes) -> Indices:
    """Return the row of each feature among the faces or edges of its body's mesh, or the index of a vertex."""
    places = np.empty(len(bodies), np.int32)
    order = np.argsort(bodies, kind="stable")
    for rows in np.split(order, np.flatnonzero(np.diff(bodies[order])) + 1):
        if len(rows):
            places[rows] = _of_one_body(features[rows], int(bodies[rows[0]]), meshes)
    return places


def _of_one_body(features: Indices, body: int, meshes: Meshes) -> Indices:
    try:
        given = meshes[body]
    except (KeyError, IndexError, TypeError):
        raise InvalidMesh(f"meshes has none for body {body}: give the mesh of each body that is in the table") from None
    mesh = instance(given, Mesh, f"meshes[{body}]", "a tamis.Mesh, such as Shape.mesh", InvalidMesh)
    places = np.where(features[:, 0] < mesh.vertex_count, features[:, 0], -1)
    counts = (features >= 0).sum(1)
    for count, find in ((2, mesh.find_edges), (3, mesh.find_faces)):
        rows = counts == count
        places[rows] = find(np.ascontiguousarray(features[rows, :count]))
    if (places < 0).any():
        first = features[int(np.argmax(places < 0))]
        vertices = " ".join(str(vertex) for vertex in first[first >= 0])
        raise InvalidMesh(f"meshes[{body}] has no feature {vertices}: give the mesh of the body's shape")
    return places
