"""Converts answers of Tamis for ipctk: near pairs become candidates for its barriers.

>>> from tamis.bridge import ipctk as bridge
>>> detector = tamis.Detector(bridge.mesh(collision_mesh))
>>> near = detector.pairs_within(vertices, dhat)
>>> collisions.build(bridge.candidates(near, collision_mesh), collision_mesh, vertices, dhat)
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any
from weakref import WeakKeyDictionary

import numpy as np
import numpy.typing as npt

from tamis._arrays import Indices
from tamis._checks import instance
from tamis._errors import InvalidMesh
from tamis._kinds import PairKind
from tamis._mesh import Mesh
from tamis._tables._columns import NamedPairs
from tamis._versions import needed

with needed("ipctk", "tamis.bridge.ipctk"):
    import ipctk

__all__ = ["candidates", "mesh"]

_Edges = npt.NDArray[np.int64]  # for each of Tamis's edges its number in ipctk


def mesh(collision_mesh: ipctk.CollisionMesh) -> Mesh:
    """Return a collision mesh of ipctk as a mesh of Tamis: the same vertices, faces, edges and loose points.

    Parameters
    ----------
    collision_mesh : ipctk.CollisionMesh
        Three-dimensional, without planes. Its positions are not used, nor is its `can_collide`: give the detector
        `groups` instead.

    Returns
    -------
    Mesh
        The same object in every call with this collision mesh. Its `edges` have another order than ipctk's.

    Raises
    ------
    InvalidMesh
        The argument is not an `ipctk.CollisionMesh`, is two-dimensional, or has planes, which Tamis does not support.
    """
    return _known(collision_mesh).mesh


def candidates(pairs: NamedPairs[Any], collision_mesh: ipctk.CollisionMesh) -> ipctk.Candidates:
    """Return pairs as candidates with ipctk's numbers of edges and faces, for `ipctk.NormalCollisions.build`.

    Parameters
    ----------
    pairs : NearPairs or Contacts
        The answer of a detector of `mesh(collision_mesh)`, or of another mesh that numbers its vertices in the same way
        and lists the vertices of each face in the same order.
    collision_mesh : ipctk.CollisionMesh
        As in `mesh`.

    Returns
    -------
    ipctk.Candidates
        One candidate for each pair: a list for each kind, in the order of the pairs.

    Raises
    ------
    InvalidMesh
        As in `mesh`; or the mesh lacks a feature of a pair.
    InvalidOptions
        `pairs` is not a table of pairs.
    """
    known = _known(collision_mesh)
    given = instance(pairs, NamedPairs, "pairs", "the NearPairs or Contacts of a detector")
    places = given.features(known.mesh)
    result = ipctk.Candidates()
    for kind, of_kind in known.kinds.items():
        setattr(result, of_kind.name, of_kind.candidates(places[given.kind == kind]))
    return result


class _Made(dict[int, Any]):
    """Cache of candidates, by the numbers of both features in one integer. Making one takes several times a look-up."""

    _MOST = 1 << 18

    def __init__(self, make: Callable[[int, int], Any]) -> None:
        super().__init__()
        self._make = make

    def __missing__(self, both: int) -> Any:
        if len(self) == self._MOST:
            self.clear()
        made = self[both] = self._make(both >> 32, both & 0xFFFFFFFF)
        return made


class _Kind:
    """Makes candidates of one kind of pairs. `first`, `second`: ipctk's edge numbers if that feature is an edge."""

    def __init__(self, name: str, make: Callable[[int, int], Any], first: _Edges | None, second: _Edges | None) -> None:
        self.name = name
        self._made, self._first, self._second = _Made(make), first, second

    def candidates(self, places: Indices) -> list[Any]:
        first, second = (
            column.astype(np.int64) if edges is None else edges[column]
            for column, edges in zip(places.T, (self._first, self._second))
        )
        return list(map(self._made.__getitem__, (first << 32 | second).tolist()))


class _Known:
    """A collision mesh as a mesh of Tamis, and the makers of its candidates by kind."""

    def __init__(self, given: ipctk.CollisionMesh) -> None:
        self.mesh = Mesh(given.faces, given.num_vertices, given.edges, given.codim_vertices)
        edges = np.empty(len(self.mesh.edges), np.int64)
        places = self.mesh.find_edges(given.edges)  # -1: from a vertex to itself, which is an edge only for ipctk
        edges[places[places >= 0]] = np.flatnonzero(places >= 0)
        self.kinds = {
            PairKind.VERTEX_FACE: _Kind("fv_candidates", _second_first(ipctk.FaceVertexCandidate), None, None),
            PairKind.EDGE_EDGE: _Kind("ee_candidates", ipctk.EdgeEdgeCandidate, edges, edges),
            PairKind.VERTEX_EDGE: _Kind("ev_candidates", _second_first(ipctk.EdgeVertexCandidate), None, edges),
            PairKind.VERTEX_VERTEX: _Kind("vv_candidates", ipctk.VertexVertexCandidate, None, None),
        }


def _second_first(make: Callable[[int, int], Any]) -> Callable[[int, int], Any]:
    """Swap the arguments of `make`: pairs of a vertex and a face or edge begin with the vertex, ipctk's end with it."""
    return lambda first, second: make(second, first)


_meshes: WeakKeyDictionary[ipctk.CollisionMesh, _Known] = WeakKeyDictionary()


def _known(given: ipctk.CollisionMesh) -> _Known:
    instance(given, ipctk.CollisionMesh, "collision_mesh", "an ipctk.CollisionMesh", InvalidMesh)
    if given.dim != 3:
        raise InvalidMesh(f"collision_mesh has {given.dim} dimensions: give one of three, with z = 0 for the plane")
    if given.planes:
        raise InvalidMesh(f"collision_mesh has {len(given.planes)} planes: give two large triangles for each")
    if given not in _meshes:
        _meshes[given] = _Known(given)
    return _meshes[given]
