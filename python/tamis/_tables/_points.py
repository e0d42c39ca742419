"""Where the points of pairs are, by weights."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles, Indices, finite
from tamis._errors import Error, InvalidStep
from tamis._kinds import FIRST_COUNTS

Corners = npt.NDArray[np.float64]  # of each pair, (n, corners, 3)


def both_points(kinds: npt.NDArray[np.uint8], weights: Doubles, corners: Corners) -> Doubles:
    """Return the points on the first and on the second feature, shape (n, 2, 3)."""
    of_first = FIRST_COUNTS[kinds][:, np.newaxis] > np.arange(weights.shape[1])
    shares = np.stack([np.where(of_first, weights, 0), np.where(of_first, 0, -weights)], 1)
    points: Doubles = np.einsum("nfi,nij->nfj", shares, corners)
    return points


def corners_at_rest(positions: Doubles, vertices: Indices, name: str) -> Corners:
    """Return where the vertices of each pair are. What a kind does not use stands where its first vertex is."""
    return finite(positions, name, InvalidStep)[used_vertices(len(positions), vertices, InvalidStep)]


def used_vertices(count: int, vertices: Indices, error: type[Error]) -> Indices:
    """Return the first vertex of a pair in place of those that it has not. Of `count` vertices there are positions."""
    most = int(vertices.max(initial=-1))
    if most >= count:
        raise error(f"vertex {most} is none of the {count} that are given: give positions of all vertices of the mesh")
    return np.where(vertices < 0, vertices[:, :1], vertices)
