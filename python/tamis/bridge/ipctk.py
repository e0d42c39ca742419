"""What Tamis finds, as ipctk takes it: near pairs become the candidates of its barriers.

>>> from tamis.bridge import ipctk as bridge
>>> detector = tamis.Detector(bridge.mesh(collision_mesh))
>>> near = detector.pairs_within(vertices, dhat)
>>> collisions.build(bridge.candidates(near, collision_mesh), collision_mesh, vertices, dhat)
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any
from weakref import WeakKeyDictionary

import ipctk
import numpy as np
import numpy.typing as npt

from tamis._arrays import Indices
from tamis._checks import instance
from tamis._errors import InvalidMesh
from tamis._kinds import PairKind
from tamis._mesh import Mesh
from tamis._tables._columns import NamedPairs

__all__ = ["candidates", "mesh"]

_Edges = npt.NDArray[np.int64]  # ipctk's number of each edge


def mesh(collision_mesh: ipctk.CollisionMesh) -> Mesh:
    """Return a collision mesh of ipctk as a mesh of Tamis: the same vertices, faces, edges and loose points.

    Parameters
    ----------
    collision_mesh : ipctk.CollisionMesh
        In three dimensions and without planes. Its positions, and whatever `can_collide` says, are not looked at: give
        the detector `groups` for that.

    Returns
    -------
    Mesh
        The same object in every call. Its `edges` have another order than ipctk's.

    Raises
    ------
    InvalidMesh
        It is no `ipctk.CollisionMesh`, is flat, or has planes, which Tamis does not know.
    """
    return _known(collision_mesh).mesh


def candidates(pairs: NamedPairs[Any], collision_mesh: ipctk.CollisionMesh) -> ipctk.Candidates:
    """Return pairs as candidates, by ipctk's numbers of edges and faces: for `ipctk.NormalCollisions.build`.

    Parameters
    ----------
    pairs : NearPairs or Contacts
        That a detector of `mesh` has found, or one of another mesh whose vertices have the same numbers, and whose
        faces list theirs in the same order.
    collision_mesh : ipctk.CollisionMesh
        As of `mesh`.

    Returns
    -------
    ipctk.Candidates
        One for each pair, in their order.

    Raises
    ------
    InvalidMesh
        As of `mesh`; or a pair has a feature that the mesh has not.
    InvalidOptions
        These are no pairs.
    """
    known = _known(collision_mesh)
    given = instance(pairs, NamedPairs, "pairs", "the NearPairs or Contacts of a detector")
    places = given.features(known.mesh)
    result = ipctk.Candidates()
    for kind, of_kind in known.kinds.items():
        setattr(result, of_kind.name, of_kind.candidates(places[given.kind == kind]))
    return result


class _Made(dict[int, Any]):
    """Candidates that were made before, by both numbers in one: to make one costs ipctk several times as much."""

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
    """The candidates of one kind of pairs: of which class, and which of its numbers are Tamis's of edges."""

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
    """A collision mesh as Tamis has it, and how its pairs become candidates."""

    def __init__(self, given: ipctk.CollisionMesh) -> None:
        self.mesh = Mesh(given.faces, given.num_vertices, given.edges, given.codim_vertices)
        edges = np.empty(len(self.mesh.edges), np.int64)
        places = self.mesh.find_edges(given.edges)  # -1: from a vertex to itself, which is an edge in ipctk alone
        edges[places[places >= 0]] = np.flatnonzero(places >= 0)
        self.kinds = {
            PairKind.VERTEX_FACE: _Kind("fv_candidates", _second_first(ipctk.FaceVertexCandidate), None, None),
            PairKind.EDGE_EDGE: _Kind("ee_candidates", ipctk.EdgeEdgeCandidate, edges, edges),
            PairKind.VERTEX_EDGE: _Kind("ev_candidates", _second_first(ipctk.EdgeVertexCandidate), None, edges),
            PairKind.VERTEX_VERTEX: _Kind("vv_candidates", ipctk.VertexVertexCandidate, None, None),
        }


def _second_first(make: Callable[[int, int], Any]) -> Callable[[int, int], Any]:
    """What has a vertex first in Tamis has it last in ipctk."""
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
