"""The deformable surface of Newton's model as a mesh of Tamis, and the rows of its features in Newton's arrays."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from tamis._arrays import Indices
from tamis._detector._detector import Detector
from tamis._kinds import PairKind
from tamis._mesh import Mesh
from tamis._tables._near import NearPairs


def _two_columns(edge_indices: Any) -> Indices:
    """Return the ends of Newton's edges, shape (e, 2). Newton's rows are the two opposite vertices, then the ends."""
    rows: Indices = np.zeros((0, 4), np.int32) if edge_indices is None else edge_indices.numpy().reshape(-1, 4)
    return rows[:, 2:]


class Surface:
    """The triangles, edges and particles of a model, and the worlds that they are in.

    Attributes
    ----------
    mesh : Mesh
        Newton's triangles in their order; edges of no triangle are loose edges, other particles loose points.
    edge_count : int
        The number of rows of Newton's list of edges.
    held : array of int, shape (h,)
        The particles that no step moves and that no edge joins to one that moves.
    """

    def __init__(self, model: Any) -> None:
        faces = model.tri_indices.numpy().reshape(-1, 3)
        edges = _two_columns(model.edge_indices)
        of_faces = Mesh(faces, vertex_count=model.particle_count)
        loose = edges[of_faces.find_edges(edges) < 0]
        points = np.setdiff1d(np.arange(model.particle_count), np.concatenate([faces.ravel(), loose.ravel()]))
        self.mesh = Mesh(faces, vertex_count=model.particle_count, edges=loose, points=points)
        self.edge_count = len(edges)
        self._newton_edge = np.full(len(self.mesh.edges), -1)
        self._newton_edge[self.mesh.find_edges(edges)] = np.arange(len(edges))
        self._worlds = model.particle_world.numpy()
        self.held = self._find_held(model)

    def _find_held(self, model: Any) -> npt.NDArray[np.int64]:
        """Return the particles that no step moves and that no edge joins to one that moves."""
        from newton import ParticleFlags

        is_active = model.particle_flags.numpy() & ParticleFlags.ACTIVE != 0
        may_move = is_active & (model.particle_mass.numpy() > 0)
        edges = self.mesh.edges
        is_joined = may_move.copy()
        is_joined[edges[may_move[edges].any(axis=1)]] = True
        return np.flatnonzero(~is_joined)

    def detector(self, *, one_ring: bool, min_separation: float, threads: int) -> Detector:
        """Return a detector of all pairs within one world; particles that are in all worlds belong to each of them.

        Pairs are skipped if no step moves any of their vertices.
        """
        groups = 2 * (self._worlds + 1)  # world -1 is in all worlds
        groups[self.held] += 1  # if a feature's first vertex is held, no step moves any of its vertices
        of_group, groups = np.unique(groups, return_inverse=True)
        world, is_held = of_group // 2, of_group % 2 == 1
        share_world = (world[:, None] == world) | (world == 0) | (world == 0)[:, None]
        return Detector(
            self.mesh,
            groups=groups,
            may_touch=share_world & ~(is_held & is_held[:, None]),
            rings=1 if one_ring else 2,
            min_separation=min_separation,
            threads=threads,
        )

    def pairs(self, near: NearPairs) -> tuple[Indices, Indices]:
        """Return vertex and triangle of each vertex-face pair, and Newton's rows of both edges of each edge-edge pair.

        Pairs are skipped if Newton has no row of their edge: such edges exert no force there.
        """
        features = near.features(self.mesh)
        edges = self._newton_edge[features[near.kind == PairKind.EDGE_EDGE]]
        return features[near.kind == PairKind.VERTEX_FACE], edges[(edges >= 0).all(1)].astype(np.int32)


def keys(pairs: npt.NDArray[Any]) -> npt.NDArray[np.int64]:
    """Return an integer for each pair of rows: the first in the upper 32 bits, the second in the lower."""
    return (pairs[:, 0].astype(np.int64) << 32) | pairs[:, 1].astype(np.int64)
