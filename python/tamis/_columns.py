"""Columns that tables of pairs have in common."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles, Indices
from tamis._table import Table


class NamedPairs(Table):
    """Pairs of features by kind and vertices."""

    __slots__ = ()

    @property
    def kind(self) -> npt.NDArray[np.uint8]:
        """`PairKind` of each, shape (n,)."""
        return self._table["kind"]

    @property
    def vertices(self) -> Indices:
        """Vertex indices, shape (n, 4), ordered as in `Contact`."""
        return self._table["vertices"]


class WeightedPairs(Table):
    """Pairs of features with a point on each."""

    __slots__ = ()

    @property
    def u(self) -> Doubles:
        """First weight, as in `Contact`, shape (n,)."""
        return self._table["u"]

    @property
    def v(self) -> Doubles:
        """Second weight, shape (n,)."""
        return self._table["v"]


class TimedPairs(WeightedPairs):
    """What pairs do during a step."""

    __slots__ = ()

    @property
    def toi_lower(self) -> Doubles:
        """Before this fraction of the step the pair is proven apart, shape (n,); 1 if it is free."""
        return self._table["toi_lower"]

    @property
    def toi_upper(self) -> Doubles:
        """By this fraction of the step a certified pair has touched, shape (n,); 1 if it is free."""
        return self._table["toi_upper"]

    @property
    def normal(self) -> Doubles:
        """Unit normals, shape (n, 3)."""
        return self._table["normal"]
