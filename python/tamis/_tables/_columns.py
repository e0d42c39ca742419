"""What tables of pairs have in common: their columns, and what follows from these."""

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
    """Make a column of each of an array's: v0, v1, ..., or nx, ny, nz."""
    return {letter + number: array[:, i] for i, number in enumerate(numbers[: array.shape[1]])}


class FeaturePairs(Table[Row]):
    """Pairs of features with a point on each."""

    __slots__ = ()

    kind = Column[npt.NDArray[np.uint8]]("`PairKind` of each, shape (n,).")
    vertices = Column[Indices]("Vertex indices, shape (n, 4), ordered as in `Contact`.")
    u = Column[Doubles]("First weight, as in `Contact`, shape (n,).")
    v = Column[Doubles]("Second weight, shape (n,).")

    @property
    def weights(self) -> Doubles:
        """Signed weights of each pair's vertices, shape (n, 4): of the first feature positive, of the second negative.

        ``np.einsum("ni,nij->nj", pairs.weights, x[pairs.vertices])`` is the vector from the second feature's point to
        the first's. 0 where a kind has no vertex.
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
        """Find both features of each pair among those of the mesh: `Mesh.features_of` of all rows.

        Parameters
        ----------
        mesh : Mesh
            The one that was asked about.

        Returns
        -------
        array of int, shape (n, 2)
            Of each feature the row of `Mesh.faces` or of `Mesh.edges`, or the index of a vertex.

        Raises
        ------
        InvalidMesh
            The mesh has no such vertex, edge or face.
        """
        known = instance(mesh, Mesh, "mesh", "the tamis.Mesh that was asked about", InvalidMesh)
        return _core.features_of(known._mesh, self._kinds(), np.ascontiguousarray(self.vertices))


class TimedPairs(FeaturePairs[Row]):
    """What pairs do during a step."""

    __slots__ = ()

    toi_lower = Column[Doubles](
        "Before this fraction of the step the pair is proven apart, shape (n,); 1 if it is free."
    )
    toi_upper = Column[Doubles](
        "By this fraction of the step a certified pair has touched, shape (n,); 1 if it is free."
    )
    normal = Column[Doubles](
        "Unit vectors along which the first feature leaves the second, shape (n, 3): as `Contact.normal`."
    )

    @property
    def certified(self) -> npt.NDArray[np.bool_]:
        """True where touching is proven, False where it is unresolved, as on a path alone, shape (n,)."""
        proven: npt.NDArray[np.bool_] = np.equal(self._table["certainty"], 0)
        return proven

    def _status(self) -> npt.NDArray[np.str_]:
        return np.where(self.certified, "certified", "unresolved")

    def _columns(self) -> Columns:
        times = {name: self._table[name] for name in ("toi_lower", "toi_upper", "u", "v")}
        return {**self._names(), **times, "status": self._status(), **numbered("n", self.normal, "xyz")}


class MovingPairs(NamedPairs[Row], TimedPairs[Row]):
    """What pairs of features of one mesh do during a step."""

    __slots__ = ()

    @overload
    def points(self, start: npt.ArrayLike, end: npt.ArrayLike) -> Doubles: ...
    @overload
    def points(self, start: Path) -> Doubles: ...
    def points(self, start: npt.ArrayLike | Path, end: npt.ArrayLike | None = None) -> Doubles:
        """Tell where both features of each pair meet, at its `toi_upper`.

        Parameters
        ----------
        start, end : array_like, shape (m, 3)
            Both ends of the step that was asked about. Or its `Path` alone.

        Returns
        -------
        array, shape (n, 2, 3)
            A point on the first feature and one on the second, by `weights`; a separation lies between them.
        """
        return self._points(motion(start, end).corners(self.toi_upper, self.vertices))
