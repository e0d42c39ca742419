"""Single pairs by ipctk's names."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles
from tamis._pairs import Pairs, edge_edge, vertex_edge, vertex_face, vertex_vertex


def point_triangle_ccd(
    p_t0: npt.ArrayLike,
    t0_t0: npt.ArrayLike,
    t1_t0: npt.ArrayLike,
    t2_t0: npt.ArrayLike,
    p_t1: npt.ArrayLike,
    t0_t1: npt.ArrayLike,
    t1_t1: npt.ArrayLike,
    t2_t1: npt.ArrayLike,
    min_distance: float = 0.0,
    tmax: float = 1.0,
) -> tuple[bool, float]:
    """Tell whether a point meets a triangle until tmax, and before which time it does not."""
    start, end = _points(p_t0, t0_t0, t1_t0, t2_t0), _points(p_t1, t0_t1, t1_t1, t2_t1)
    return _found(vertex_face(start, end, min_separation=min_distance, latest=tmax))


def edge_edge_ccd(
    ea0_t0: npt.ArrayLike,
    ea1_t0: npt.ArrayLike,
    eb0_t0: npt.ArrayLike,
    eb1_t0: npt.ArrayLike,
    ea0_t1: npt.ArrayLike,
    ea1_t1: npt.ArrayLike,
    eb0_t1: npt.ArrayLike,
    eb1_t1: npt.ArrayLike,
    min_distance: float = 0.0,
    tmax: float = 1.0,
) -> tuple[bool, float]:
    """Tell whether two edges meet until tmax, and before which time they do not."""
    start, end = _points(ea0_t0, ea1_t0, eb0_t0, eb1_t0), _points(ea0_t1, ea1_t1, eb0_t1, eb1_t1)
    return _found(edge_edge(start, end, min_separation=min_distance, latest=tmax))


def point_edge_ccd(
    p_t0: npt.ArrayLike,
    e0_t0: npt.ArrayLike,
    e1_t0: npt.ArrayLike,
    p_t1: npt.ArrayLike,
    e0_t1: npt.ArrayLike,
    e1_t1: npt.ArrayLike,
    min_distance: float = 0.0,
    tmax: float = 1.0,
) -> tuple[bool, float]:
    """Tell whether a point meets an edge until tmax, and before which time it does not."""
    start, end = _points(p_t0, e0_t0, e1_t0), _points(p_t1, e0_t1, e1_t1)
    return _found(vertex_edge(start, end, min_separation=min_distance, latest=tmax))


def point_point_ccd(
    p0_t0: npt.ArrayLike,
    p1_t0: npt.ArrayLike,
    p0_t1: npt.ArrayLike,
    p1_t1: npt.ArrayLike,
    min_distance: float = 0.0,
    tmax: float = 1.0,
) -> tuple[bool, float]:
    """Tell whether two points meet until tmax, and before which time they do not."""
    start, end = _points(p0_t0, p1_t0), _points(p0_t1, p1_t1)
    return _found(vertex_vertex(start, end, min_separation=min_distance, latest=tmax))


def _points(*points: npt.ArrayLike) -> Doubles:
    return np.stack([np.asarray(point, dtype=np.float64).ravel() for point in points])


def _found(pair: Pairs) -> tuple[bool, float]:
    """What ipctk returns: does it touch, and when; infinity if not."""
    return (True, float(pair.toi_lower[0])) if pair.touches[0] else (False, float("inf"))
