"""What is said of a mesh at rest: which features are near each other, and which pass through each other."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import Doubles, Indices
from tamis._columns import NamedPairs, WeightedPairs
from tamis._table import Table


class NearPairs(NamedPairs, WeightedPairs):
    """Pairs of features that are near each other at rest, by kind, then vertices; arrays of length n.

    The columns of `table` are kind, corners, vertices, distance, u, v, direction.
    """

    __slots__ = ()
    _dtype = np.dtype(_core.near_layout())

    @property
    def corners(self) -> npt.NDArray[np.uint8]:
        """Bit i is set if vertex i has a share in the closest points: which corners, borders or insides they lie on."""
        return self._table["corners"]

    @property
    def distance(self) -> Doubles:
        """Between the closed features, in the unit of the positions; correct to 2^-41 of the pair's extent."""
        return self._table["distance"]

    @property
    def direction(self) -> Doubles:
        """Unit vectors from the second feature's closest point to the first's, shape (n, 3)."""
        return self._table["direction"]

    def __repr__(self) -> str:
        nearest = f", nearest {self.distance.min():g}" if len(self) else ""
        return f"NearPairs({len(self)} pairs{nearest})"


class Intersections(Table):
    """Edges that pass through triangles or touch them, by edge, then face; arrays of length n.

    The columns of `table` are edge, face, s_lower, s_upper, u, v.
    """

    __slots__ = ()
    _dtype = np.dtype(_core.intersection_layout())

    @property
    def edge(self) -> Indices:
        """Vertex indices of each edge, ascending, shape (n, 2)."""
        return self._table["edge"]

    @property
    def face(self) -> Indices:
        """Vertex indices of each triangle, in the mesh's order, shape (n, 3)."""
        return self._table["face"]

    @property
    def s_lower(self) -> Doubles:
        """The first common point along the edge has a parameter of at least this, counted from the first vertex."""
        return self._table["s_lower"]

    @property
    def s_upper(self) -> Doubles:
        """And of at most this."""
        return self._table["s_upper"]

    @property
    def u(self) -> Doubles:
        """Weight of the triangle's second corner at that point, rounded."""
        return self._table["u"]

    @property
    def v(self) -> Doubles:
        """Weight of the triangle's third corner, rounded."""
        return self._table["v"]

    def __repr__(self) -> str:
        return f"Intersections({len(self)} of edges with triangles)"
