"""The points of pairs of features, computed from weights and positions."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles, Indices, finite
from tamis._errors import Error, InvalidStep
from tamis._kinds import FIRST_COUNTS

Corners = npt.NDArray[np.float64]  # positions of the vertices of each pair, shape (n, vertices, 3)


def both_points(kinds: npt.NDArray[np.uint8], weights: Doubles, corners: Corners) -> Doubles:
    """Return the points on the first and on the second feature of each pair, shape (n, 2, 3)."""
    of_first = FIRST_COUNTS[kinds][:, np.newaxis] > np.arange(weights.shape[1])
    shares = np.stack([np.where(of_first, weights, 0), np.where(of_first, 0, -weights)], 1)
    points: Doubles = np.einsum("nfi,nij->nfj", shares, corners)
    return points


def corners_at_rest(positions: Doubles, vertices: Indices, name: str) -> Corners:
    """Return the positions of the vertices of each pair. Unused entries have the position of the first vertex."""
    return finite(positions, name, InvalidStep)[used_vertices(len(positions), vertices, InvalidStep)]


def used_vertices(count: int, vertices: Indices, error: type[Error]) -> Indices:
    """Return `vertices` with each pair's first vertex instead of unused entries; raise for an index >= `count`."""
    most = int(vertices.max(initial=-1))
    if most >= count:
        raise error(f"vertex {most} is none of the {count} that are given: give positions of all vertices of the mesh")
    return np.where(vertices < 0, vertices[:, :1], vertices)
