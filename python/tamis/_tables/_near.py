"""What is said of a mesh at rest: which features are near each other, and which pass through each other."""

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
    """A pair of features that are near each other at rest.

    Attributes
    ----------
    kind : PairKind
        As in `Contact`.
    vertices : tuple of four int
        As in `Contact`.
    distance : float
        Between the closed features, in the unit of the positions; correct to 2^-41 of the pair's extent.
    u, v : float
        Weights of two closest points, as in `Contact`. A vertex without a share in them has the weight 0.
    direction : tuple of three float
        Of unit length: from the second feature's closest point to the first's. Where they touch: their normal, or zero
        where they have none.
    """

    kind: PairKind
    vertices: tuple[int, int, int, int]
    distance: float
    u: float
    v: float
    direction: tuple[float, float, float]


class ClosePairs(FeaturePairs[Row]):
    """Pairs of features that are near each other at rest: of one mesh, or of bodies."""

    __slots__ = ()

    distance = Column[Doubles](
        "Between the closed features, in the unit of the positions, shape (n,).\n\n"
        "Correct to 2^-41 of the pair's extent, and where it is no normal double to half the smallest one more."
    )
    direction = Column[Doubles]("Unit vectors from the second feature's closest point to the first's, shape (n, 3).")

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
    """Pairs of features that are near each other at rest, by kind, then vertices; arrays of length n.

    `len()` counts them; an integer index gives a `NearPair`, anything else that indexes an array gives `NearPairs`.

    The columns of `table` are kind, vertices, distance, u, v, direction.
    """

    __slots__ = ()
    _dtype = np.dtype(_core.near_layout())
    _record = NearPair

    def points(self, positions: npt.ArrayLike) -> Doubles:
        """Tell where the closest points of each pair are.

        Parameters
        ----------
        positions : array_like, shape (n, 3)
            Those that were asked about.

        Returns
        -------
        array, shape (n, 2, 3)
            The point on the first feature and that on the second, by `weights`.
        """
        return self._points(corners_at_rest(rows(positions, "positions"), self.vertices, "positions"))


class Intersection(NamedTuple):
    """An edge that passes through a triangle, or touches it.

    Attributes
    ----------
    edge, face : tuple of int
        Vertex indices: of the edge ascending, of the face in the mesh's order.
    s_lower, s_upper : float
        The first common point along the edge, from its first vertex, has a parameter between these.
    u, v : float
        Weights of that point in the face, as of a vertex-face `Contact`.
    """

    edge: tuple[int, int]
    face: tuple[int, int, int]
    s_lower: float
    s_upper: float
    u: float
    v: float


class CrossingPairs(Table[Row]):
    """Edges with triangles that they pass through or touch: of one mesh, or of bodies."""

    __slots__ = ()

    edge = Column[Indices]("Vertex indices of each edge, ascending, shape (n, 2).")
    face = Column[Indices]("Vertex indices of each triangle, in the mesh's order, shape (n, 3).")
    s_lower = Column[Doubles](
        "The first common point along the edge has at least this parameter, 0 at its first vertex, shape (n,)."
    )
    s_upper = Column[Doubles]("The first common point along the edge has at most this parameter, shape (n,).")
    u = Column[Doubles]("Weight of the triangle's second vertex in that point, rounded, shape (n,).")
    v = Column[Doubles]("Weight of the triangle's third vertex in that point, rounded, shape (n,).")

    @property
    def vertices(self) -> Indices:
        """The edge's vertices, then the face's, shape (n, 5)."""
        return np.concatenate([self.edge, self.face], axis=1)

    @property
    def weights(self) -> Doubles:
        """Signed weights of these vertices, shape (n, 5): of the edge positive, of the face negative."""
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
    """Edges that pass through triangles or touch them, by edge, then face; arrays of length n.

    `len()` counts them; an integer index gives an `Intersection`, anything else that indexes an array `Intersections`.

    The columns of `table` are edge, face, s_lower, s_upper, u, v.
    """

    __slots__ = ()
    _dtype = np.dtype(_core.intersection_layout())
    _record = Intersection

    def points(self, positions: npt.ArrayLike) -> Doubles:
        """Tell where each common point is.

        Parameters
        ----------
        positions : array_like, shape (n, 3)
            Those that were asked about.

        Returns
        -------
        array, shape (n, 2, 3)
            The point as one of the edge and as one of the face, by `weights`: the same but for rounding.
        """
        corners = corners_at_rest(rows(positions, "positions"), self.vertices, "positions")
        shares = self.weights[:, :, np.newaxis] * corners
        return np.stack([shares[:, :2].sum(1), -shares[:, 2:].sum(1)], axis=1)

    def features(self, mesh: Mesh) -> Indices:
        """Find each edge and face among those of the mesh.

        Parameters
        ----------
        mesh : Mesh
            The one that was asked about.

        Returns
        -------
        array of int, shape (n, 2)
            The rows of `Mesh.edges` and of `Mesh.faces`.

        Raises
        ------
        InvalidMesh
            The mesh has no such edge or face.
        """
        known = instance(mesh, Mesh, "mesh", "the tamis.Mesh that was asked about", InvalidMesh)
        places = np.stack([known.find_edges(self.edge), known.find_faces(self.face)], axis=1)
        if (places < 0).any():
            first = self[int(np.argmax((places < 0).any(1)))]
            raise InvalidMesh(
                f"the mesh has no edge {first.edge} or no face {first.face}: give the mesh that was asked"
            )
        return places
