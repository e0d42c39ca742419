"""Bases of tables of pairs: their common columns, and values computed from these."""

from __future__ import annotations

from typing import Any, overload

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import Doubles, Indices
from tamis._checks import instance
from tamis._errors import InvalidMesh
from tamis._kinds import SHORT_NAMES
from tamis._mesh import Mesh
from tamis._motion import motion
from tamis._paths._path import Path
from tamis._tables._points import Corners, both_points
from tamis._tables._table import Column, Row, Table

Columns = dict[str, npt.NDArray[Any]]


def numbered(letter: str, array: npt.NDArray[Any], numbers: str = "0123") -> Columns:
    """Return the columns of an array (n, k) by name: v0, v1, ..., or nx, ny, nz."""
    return {letter + number: array[:, i] for i, number in enumerate(numbers[: array.shape[1]])}


class FeaturePairs(Table[Row]):
    """Pairs of features, with the weights of a point on each feature."""

    __slots__ = ()

    kind = Column[npt.NDArray[np.uint8]]("The `PairKind` of each pair, shape (n,).")
    vertices = Column[Indices]("Vertex indices, shape (n, 4), ordered as in `Contact`.")
    u = Column[Doubles]("First weight, as in `Contact`, shape (n,).")
    v = Column[Doubles]("Second weight, shape (n,).")

    @property
    def weights(self) -> Doubles:
        """Signed weights of each pair's vertices, shape (n, 4): the first feature's add up to 1, the second's to -1.

        ``np.einsum("ni,nij->nj", pairs.weights, x[pairs.vertices])`` is the vector from the second feature's point to
        the first feature's. Entries that a kind does not use are 0.
        """
        return _core.weights_of(self._kinds(), self.u, self.v)

    def _points(self, corners: Corners) -> Doubles:
        return both_points(self._kinds(), self.weights, corners)

    def _kinds(self) -> npt.NDArray[np.uint8]:
        return np.ascontiguousarray(self.kind)

    def _names(self) -> Columns:
        return {"kind": np.asarray(SHORT_NAMES)[self.kind], **numbered("v", self.vertices)}


class NamedPairs(FeaturePairs[Row]):
    """Pairs of features of one mesh."""

    __slots__ = ()

    def features(self, mesh: Mesh) -> Indices:
        """Find both features of each pair in the mesh: `Mesh.features_of` for all rows.

        Parameters
        ----------
        mesh : Mesh
            The mesh of the question.

        Returns
        -------
        array of int32, shape (n, 2)
            For each pair its first and its second feature: for a face its row in `Mesh.faces`, for an edge its row in
            `Mesh.edges`, for a vertex its index.

        Raises
        ------
        InvalidMesh
            The mesh has no such vertex, edge or face.
        """
        known = instance(mesh, Mesh, "mesh", "the tamis.Mesh that was asked about", InvalidMesh)
        return _core.features_of(known._mesh, self._kinds(), np.ascontiguousarray(self.vertices))


class TimedPairs(FeaturePairs[Row]):
    """Pairs of features, with the times and normals of their contacts during a step."""

    __slots__ = ()

    toi_lower = Column[Doubles](
        "Fraction of the step, shape (n,): before it the pair is proven apart; 1 if the pair is free."
    )
    toi_upper = Column[Doubles](
        "Fraction of the step, shape (n,): until then a certified pair has touched; 1 if the pair is free."
    )
    normal = Column[Doubles](
        "Unit vectors, shape (n, 3): the first feature leaves the second along them; as in `Contact.normal`."
    )

    @property
    def certified(self) -> npt.NDArray[np.bool_]:
        """Whether each contact is proven, shape (n,); False where it is unresolved, which happens only on a path."""
        proven: npt.NDArray[np.bool_] = np.equal(self._table["certainty"], 0)
        return proven

    def _status(self) -> npt.NDArray[np.str_]:
        return np.where(self.certified, "certified", "unresolved")

    def _columns(self) -> Columns:
        times = {name: self._table[name] for name in ("toi_lower", "toi_upper", "u", "v")}
        return {**self._names(), **times, "status": self._status(), **numbered("n", self.normal, "xyz")}


class MovingPairs(NamedPairs[Row], TimedPairs[Row]):
    """Pairs of features of one mesh, with their contacts during a step."""

    __slots__ = ()

    @overload
    def points(self, start: npt.ArrayLike, end: npt.ArrayLike) -> Doubles: ...
    @overload
    def points(self, start: Path) -> Doubles: ...
    def points(self, start: npt.ArrayLike | Path, end: npt.ArrayLike | None = None) -> Doubles:
        """Compute where both features of each pair meet, at its `toi_upper`.

        Parameters
        ----------
        start, end : array_like, shape (m, 3)
            Where each vertex is at the start and at the end of the step, as in the question. Or its `Path` alone.

        Returns
        -------
        array of float64, shape (n, 2, 3)
            A point on the first feature and a point on the second, by `weights`. With a separation they lie that far
            apart.

        Raises
        ------
        InvalidStep, InvalidPath
            Arrays of another shape, numbers that are not finite, or positions of too few vertices.
        """
        return self._points(motion(start, end).corners(self.toi_upper, self.vertices))
