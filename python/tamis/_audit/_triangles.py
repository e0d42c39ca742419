"""Polygons as triangles."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from tamis._arrays import Indices


def fans(counts: npt.NDArray[np.integer], corners: npt.NDArray[np.integer]) -> Indices:
    """Cut polygons, given by their numbers of corners and all their corners, into fans: shape (t, 3)."""
    counts = np.asarray(counts, np.int64)
    first = np.concatenate([[0], np.cumsum(counts)[:-1]]) if len(counts) else np.empty(0, np.int64)
    of_polygon = np.maximum(counts - 2, 0)
    start = np.repeat(first, of_polygon)
    place = np.arange(of_polygon.sum()) - np.repeat(np.cumsum(of_polygon) - of_polygon, of_polygon)
    corner = np.stack([start, start + place + 1, start + place + 2], axis=1)
    triangles: Indices = np.asarray(corners, np.int32)[corner]
    return triangles
