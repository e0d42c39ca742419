"""Single pairs by ipctk's names."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles, finite, numbers
from tamis._checks import number
from tamis._errors import InvalidStep
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
    start = _points(p_t0=p_t0, t0_t0=t0_t0, t1_t0=t1_t0, t2_t0=t2_t0)
    end = _points(p_t1=p_t1, t0_t1=t0_t1, t1_t1=t1_t1, t2_t1=t2_t1)
    return _found(vertex_face, start, end, min_distance, tmax)


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
    start = _points(ea0_t0=ea0_t0, ea1_t0=ea1_t0, eb0_t0=eb0_t0, eb1_t0=eb1_t0)
    end = _points(ea0_t1=ea0_t1, ea1_t1=ea1_t1, eb0_t1=eb0_t1, eb1_t1=eb1_t1)
    return _found(edge_edge, start, end, min_distance, tmax)


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
    start = _points(p_t0=p_t0, e0_t0=e0_t0, e1_t0=e1_t0)
    end = _points(p_t1=p_t1, e0_t1=e0_t1, e1_t1=e1_t1)
    return _found(vertex_edge, start, end, min_distance, tmax)


def point_point_ccd(
    p0_t0: npt.ArrayLike,
    p1_t0: npt.ArrayLike,
    p0_t1: npt.ArrayLike,
    p1_t1: npt.ArrayLike,
    min_distance: float = 0.0,
    tmax: float = 1.0,
) -> tuple[bool, float]:
    """Tell whether two points meet until tmax, and before which time they do not."""
    start = _points(p0_t0=p0_t0, p1_t0=p1_t0)
    end = _points(p0_t1=p0_t1, p1_t1=p1_t1)
    return _found(vertex_vertex, start, end, min_distance, tmax)


def _points(**points: npt.ArrayLike) -> Doubles:
    return np.stack([_point(point, name) for name, point in points.items()])


def _point(given: npt.ArrayLike, name: str) -> Doubles:
    """One point, as a row or as a column."""
    array = numbers(given, name, InvalidStep)
    if array.shape not in ((3,), (1, 3), (3, 1)):
        advice = "give three numbers in a row; points in the plane have a z of 0"
        raise InvalidStep(f"{name} has {array.size} numbers in {array.ndim} dimensions: {advice}")
    return finite(array.ravel().astype(np.float64), name, InvalidStep)


def _found(
    decide: Callable[..., Pairs], start: Doubles, end: Doubles, min_distance: float, tmax: float
) -> tuple[bool, float]:
    """What ipctk returns: does it touch, and when; infinity if not."""
    pair = decide(start, end, min_separation=number(min_distance, "min_distance"), latest=number(tmax, "tmax"))
    return (True, float(pair.toi_lower[0])) if pair.touches[0] else (False, float("inf"))
