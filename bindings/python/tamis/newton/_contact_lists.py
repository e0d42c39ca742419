"""The lists of near pairs that Newton sums contact forces over, in arrays of exactly their size."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from tamis._arrays import Indices
from tamis._pair_distance import distance_of
from tamis._tables._near import NearPairs
from tamis.newton._surface import Surface, keys


class ContactLists:
    """Fills the solver's `TriMeshCollisionInfo`, without the pairs that Newton skips in its forces."""

    def __init__(self, solver: Any, surface: Surface) -> None:
        self._solver = solver
        self._surface = surface
        theirs = solver.trimesh_collision_detector
        self._without = (
            _filtered(theirs.vertex_triangle_filtering_list, theirs.vertex_triangle_filtering_list_offsets),
            _filtered(theirs.edge_filtering_list, theirs.edge_filtering_list_offsets),
        )

    def fill(self, near: NearPairs) -> None:
        """Replace the lists by lists of these pairs."""
        vertex_face, edge_edge = self._surface.pairs(self._beyond_rest(near))
        vertex_face = _without(vertex_face, self._without[0])
        edge_edge = _without(np.concatenate([edge_edge, edge_edge[:, ::-1]]), self._without[1])
        self._put("vertex_colliding_triangles", vertex_face, self._surface.mesh.vertex_count)
        self._put("edge_colliding_edges", edge_edge, self._surface.edge_count)

    def _beyond_rest(self, near: NearPairs) -> NearPairs:
        """Return the pairs without those near each other in the rest shape, if Newton's options leave these out."""
        radius: float = self._solver.particle_rest_shape_contact_exclusion_radius
        if not radius > 0:
            return near
        rest = self._solver.particle_q_rest.numpy()
        return near[distance_of(near.kind, near.vertices, rest).distance >= radius]

    def _put(self, name: str, pairs: Indices, rows: int) -> None:
        """Write pairs (row, neighbour), sorted by row, with the count and the offset of each row."""
        import warp as wp

        counts = np.bincount(pairs[:, 0], minlength=rows).astype(np.int32)
        ordered = pairs[np.argsort(pairs[:, 0], kind="stable")]
        arrays = {
            "": ordered.ravel(),
            "_count": counts,
            "_buffer_sizes": counts,
            "_offsets": np.concatenate([[0], np.cumsum(counts)]),
        }
        for suffix, values in arrays.items():
            array = wp.array(values, dtype=wp.int32, device=self._solver.device)
            setattr(self._solver.trimesh_collision_info, name + suffix, array)


def _filtered(values: Any, offsets: Any) -> npt.NDArray[np.int64]:
    """Return the sorted keys of the pairs that a filter of Newton's skips: row i has values[offsets[i]...]."""
    if values is None:
        return np.zeros(0, np.int64)
    rows = np.repeat(np.arange(len(offsets) - 1), np.diff(offsets.numpy()))
    return np.sort(keys(np.stack([rows, values.numpy()], axis=1)))


def _without(pairs: Indices, filtered: npt.NDArray[np.int64]) -> Indices:
    if len(filtered) == 0:
        return pairs
    wanted = keys(pairs)
    places = np.minimum(np.searchsorted(filtered, wanted), len(filtered) - 1)
    left: Indices = pairs[filtered[places] != wanted]
    return left
