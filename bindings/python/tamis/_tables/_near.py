"""Answers about a mesh in one pose: near pairs of features, and intersections."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import Doubles, Indices, rows
from tamis._checks import instance
from tamis._errors import InvalidMesh
from tamis._kinds import PairKind
from tamis._mesh import Mesh
from tamis._tables._columns import Columns, FeaturePairs, NamedPairs, numbered
from tamis._tables._points import corners_at_rest
from tamis._tables._table import Column, Row, Table


class NearPair(NamedTuple):
    """A pair of features that are near each other in one pose.

    Attributes
    ----------
    kind : PairKind
        As in `Contact`.
    vertices : tuple of four int
        As in `Contact`.
    distance : float
        The distance between the closed features, in the unit of the positions. Proven: off by at most 2^-41 of the
        largest component of the differences between the pair's vertices.
    u, v : float
        Weights of two closest points, as in `Contact`. A vertex without a share in them has the weight 0.
    direction : tuple of three float
        Unit vector from the second feature's closest point to the first's. If they touch: along the normal if the
        common point is inside a face or inside two edges, else zero.
    """

    kind: PairKind
    vertices: tuple[int, int, int, int]
    distance: float
    u: float
    v: float
    direction: tuple[float, float, float]


class ClosePairs(FeaturePairs[Row]):
    """Near pairs in one pose: a base of `NearPairs` and `BodyNearPairs`."""

    __slots__ = ()

    distance = Column[Doubles](
        "The distance between the closed features, in the unit of the positions, shape (n,).\n\n"
        "Off by at most 2^-41 of the pair's extent, and by at most 2^-1075 more below the smallest normal double."
    )
    direction = Column[Doubles](
        "Unit vectors from the second feature's closest point to the first's, shape (n, 3), as in `NearPair`."
    )

    def _fields(self, values: Sequence[Any]) -> tuple[Any, ...]:
        kind, vertices, distance, u, v, direction = values
        return PairKind(kind), tuple(vertices.tolist()), distance, u, v, tuple(direction.tolist())

    def _columns(self) -> Columns:
        weights = {"u": self.u, "v": self.v}
        direction = numbered("d", self.direction, "xyz")
        return {**self._names(), "distance": self.distance, **weights, **direction}

    def __repr__(self) -> str:
        nearest = f", nearest {self.distance.min():g}" if len(self) else ""
        return f"{type(self).__name__}({len(self)} pairs{nearest})"


class NearPairs(NamedPairs[NearPair], ClosePairs[NearPair]):
    """Pairs of features that are near each other in one pose, sorted by kind, then vertices; arrays of length n.

    `len()` counts the pairs; an integer index gives a `NearPair`, any other index of an array gives `NearPairs`. The
    columns of `table` are kind, vertices, distance, u, v, direction.
    """

    __slots__ = ()
    _dtype = np.dtype(_core.near_layout())
    _record = NearPair

    def points(self, positions: npt.ArrayLike) -> Doubles:
        """Compute the closest points of each pair.

        Parameters
        ----------
        positions : array_like, shape (m, 3)
            The positions of the question.

        Returns
        -------
        array of float64, shape (n, 2, 3)
            The point on the first feature and the point on the second, by `weights`.

        Raises
        ------
        InvalidStep
            An array of another shape, numbers that are not finite, or positions of too few vertices.
        """
        return self._points(corners_at_rest(rows(positions, "positions"), self.vertices, "positions"))


class Intersection(NamedTuple):
    """An edge that passes through a triangle or touches it, and shares no vertex with it.

    Attributes
    ----------
    edge, face : tuple of int
        Vertex indices: the edge's ascending, the face's in the mesh's order.
    s_lower, s_upper : float
        The first common point along the edge, from ``edge[0]`` on, has a parameter s in [s_lower, s_upper]: the point
        is (1-s) e0 + s e1.
    u, v : float
        Weights of that point in the face, rounded: (1-u-v) f0 + u f1 + v f2.
    """

    edge: tuple[int, int]
    face: tuple[int, int, int]
    s_lower: float
    s_upper: float
    u: float
    v: float


class CrossingPairs(Table[Row]):
    """Edges with triangles that they pass through or touch: a base of `Intersections` and `BodyIntersections`."""

    __slots__ = ()

    edge = Column[Indices]("Vertex indices of each edge, ascending, shape (n, 2).")
    face = Column[Indices]("Vertex indices of each triangle, in the mesh's order, shape (n, 3).")
    s_lower = Column[Doubles](
        "Lower bound of the first common point's parameter on the edge, 0 at the edge's first vertex, shape (n,)."
    )
    s_upper = Column[Doubles]("Upper bound of the first common point's parameter on the edge, shape (n,).")
    u = Column[Doubles]("Weight of the triangle's second vertex in the first common point, rounded, shape (n,).")
    v = Column[Doubles]("Weight of the triangle's third vertex in the first common point, rounded, shape (n,).")

    @property
    def vertices(self) -> Indices:
        """The edge's vertices, then the face's, shape (n, 5)."""
        return np.concatenate([self.edge, self.face], axis=1)

    @property
    def weights(self) -> Doubles:
        """Signed weights of `vertices`, shape (n, 5): the edge's add up to 1, the face's to -1."""
        s = (self.s_lower + self.s_upper) / 2
        return np.stack([1 - s, s, self.u + self.v - 1, -self.u, -self.v], axis=1)

    def _fields(self, values: Sequence[Any]) -> tuple[Any, ...]:
        edge, face, *numbers = values
        return tuple(edge.tolist()), tuple(face.tolist()), *numbers

    def _columns(self) -> Columns:
        lines = {name: self._table[name] for name in ("s_lower", "s_upper", "u", "v")}
        return {**numbered("e", self.edge), **numbered("f", self.face), **lines}

    def __repr__(self) -> str:
        return f"{type(self).__name__}({len(self)} of edges with triangles)"


class Intersections(CrossingPairs[Intersection]):
    """Edges that pass through triangles or touch them, sorted by edge, then face; arrays of length n.

    `len()` counts the rows; an integer index gives an `Intersection`, any other index of an array gives
    `Intersections`. The columns of `table` are edge, face, s_lower, s_upper, u, v.
    """

    __slots__ = ()
    _dtype = np.dtype(_core.intersection_layout())
    _record = Intersection

    def points(self, positions: npt.ArrayLike) -> Doubles:
        """Compute the first common point of each edge and triangle.

        Parameters
        ----------
        positions : array_like, shape (m, 3)
            The positions of the question.

        Returns
        -------
        array of float64, shape (n, 2, 3)
            The point computed on the edge, then on the face, by `weights`: equal except for rounding.

        Raises
        ------
        InvalidStep
            An array of another shape, numbers that are not finite, or positions of too few vertices.
        """
        corners = corners_at_rest(rows(positions, "positions"), self.vertices, "positions")
        shares = self.weights[:, :, np.newaxis] * corners
        return np.stack([shares[:, :2].sum(1), -shares[:, 2:].sum(1)], axis=1)

    def features(self, mesh: Mesh) -> Indices:
        """Find each edge and face in the mesh.

        Parameters
        ----------
        mesh : Mesh
            The mesh of the question.

        Returns
        -------
        array of int32, shape (n, 2)
            For each row the edge's row in `Mesh.edges` and the face's row in `Mesh.faces`.

        Raises
        ------
        InvalidMesh
            The mesh has no such edge or face.
        """
        known = instance(mesh, Mesh, "mesh", "the tamis.Mesh that was asked about", InvalidMesh)
        places = np.stack([known.find_edges(self.edge), known.find_faces(self.face)], axis=1)
        if (places < 0).any():
            first = self[int(np.argmax((places < 0).any(1)))]
            raise InvalidMesh(f"the mesh has no edge {first.edge} or no face {first.face}: give the mesh of the query")
        return places
