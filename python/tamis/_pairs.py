"""Many single pairs at once: for callers who have a broad phase of their own."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import Doubles, finite, pairs
from tamis._checks import number
from tamis._columns import Columns, TimedPairs, numbered
from tamis._errors import InvalidStep
from tamis._kinds import SHORT_NAMES, PairKind, one_kind

_CORNERS = {PairKind.VERTEX_FACE: 4, PairKind.EDGE_EDGE: 4, PairKind.VERTEX_EDGE: 3, PairKind.VERTEX_VERTEX: 2}


class PairResult(NamedTuple):
    """What one pair does during the step. Only where `touches` have the others a meaning.

    Attributes
    ----------
    kind : PairKind
        What was asked about.
    touches : bool
        False: proven free.
    certified : bool
        True: proven to touch. False: free, or, on a path alone, unresolved.
    toi_lower, toi_upper, u, v, normal
        As in `Contact`.
    """

    kind: PairKind
    touches: bool
    certified: bool
    toi_lower: float
    toi_upper: float
    u: float
    v: float
    normal: tuple[float, float, float]


class Pairs(TimedPairs[PairResult]):
    """What each pair does during the step, as arrays of length n. Only where `touches` have the others a meaning.

    `len()` counts them; an integer index gives a `PairResult`, anything else that indexes an array gives `Pairs`.
    The columns of `table` are touches, certainty, toi_lower, toi_upper, u, v, normal.
    """

    __slots__ = ("_kind",)
    _dtype = np.dtype(_core.pair_layout())

    def __init__(self, table: npt.NDArray[np.void] | npt.NDArray[np.uint8], kind: PairKind) -> None:
        super().__init__(table)
        self._kind = one_kind(kind)

    @property
    def kind(self) -> PairKind:
        """Of all of them."""
        return self._kind

    @property
    def touches(self) -> npt.NDArray[np.bool_]:
        """False: proven free."""
        return self._table["touches"]

    @property
    def certified(self) -> npt.NDArray[np.bool_]:
        """True: proven to touch. False: free, or, on a path alone, unresolved."""
        return super().certified & self.touches

    @property
    def weights(self) -> Doubles:
        """Signed weights of the points as given, shape (n, k): of the first feature positive, of the second negative.

        ``np.einsum("ni,nij->nj", pairs.weights, x)`` is the vector from the second feature's point to the first's.
        """
        return super().weights[:, : _CORNERS[self._kind]]

    def points(self, start: npt.ArrayLike, end: npt.ArrayLike) -> Doubles:
        """Tell where both features of each pair meet, at its `toi_upper`.

        Parameters
        ----------
        start, end : array_like, shape (n, k, 3)
            That were asked about.

        Returns
        -------
        array, shape (n, 2, 3)
            A point on the first feature and one on the second, by `weights`.
        """
        first, last = _both(start, end, _CORNERS[self._kind])
        finite(first, "start", InvalidStep), finite(last, "end", InvalidStep)
        if len(first) != len(self):
            raise InvalidStep(f"start has {len(first)} pairs, and these are {len(self)}: give those that were asked")
        t = self.toi_upper[:, np.newaxis, np.newaxis]
        return self._points((1 - t) * first + t * last)

    def _kinds(self) -> npt.NDArray[np.uint8]:
        return np.full(len(self), self._kind, np.uint8)

    def _columns(self) -> Columns:
        kind, touching = (
            np.full(len(self), SHORT_NAMES[self._kind]),
            np.where(self.certified, "certified", "unresolved"),
        )
        status = np.where(self.touches, touching, "free")
        return {"kind": kind, **self._times(), "status": status, **numbered("n", self.normal, "xyz")}

    def _row(self, values: Any) -> PairResult:
        touches, certainty, toi_lower, toi_upper, u, v, normal = values
        certified = touches and certainty == 0
        return PairResult(self._kind, touches, certified, toi_lower, toi_upper, u, v, tuple(normal.tolist()))

    def _part(self, table: npt.NDArray[np.void]) -> Pairs:
        return Pairs(table, self._kind)

    def __eq__(self, other: object) -> bool:
        return super().__eq__(other) and self._kind == other._kind  # type: ignore[attr-defined]

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[type[Pairs], tuple[Any, ...]]:
        return Pairs, (self._table, self._kind)

    def __repr__(self) -> str:
        return f"Pairs({len(self)} {self._kind.long_name}, {int(self.touches.sum())} touch)"


def vertex_face(
    start: npt.ArrayLike,
    end: npt.ArrayLike,
    *,
    min_separation: float = 0.0,
    latest: float = 1.0,
) -> Pairs:
    """Decide vertices against faces, each pair by itself.

    Parameters
    ----------
    start, end : array_like, shape (n, 4, 3)
        At the start and at the end of the step: the vertex, then the face's corners. One pair may come as (4, 3).
        Contiguous doubles are read where they are; anything else is copied once.
    min_separation : float
        d >= 0: contact means Euclidean distance <= d.
    latest : float
        The latest time of interest, in [0, 1]: a pair that is proven apart until then is free. Of others it changes
        nothing.

    Returns
    -------
    Pairs
        In the order of the input.

    Raises
    ------
    InvalidStep
        A wrong shape or type, or a coordinate that is not finite; the message names the pair.
    InvalidOptions
        An option outside its range.
    """
    return _decided(PairKind.VERTEX_FACE, _core.vertex_face, start, end, min_separation, latest)


def edge_edge(
    start: npt.ArrayLike,
    end: npt.ArrayLike,
    *,
    min_separation: float = 0.0,
    latest: float = 1.0,
) -> Pairs:
    """Decide edges against edges, each pair by itself.

    Parameters
    ----------
    start, end : array_like, shape (n, 4, 3)
        At the start and at the end of the step: points 0 and 1 are one edge, 2 and 3 the other.
    min_separation, latest
        As of `vertex_face`.

    Returns
    -------
    Pairs
        In the order of the input.

    Raises
    ------
    InvalidStep, InvalidOptions
        As of `vertex_face`.
    """
    return _decided(PairKind.EDGE_EDGE, _core.edge_edge, start, end, min_separation, latest)


def vertex_edge(
    start: npt.ArrayLike,
    end: npt.ArrayLike,
    *,
    min_separation: float = 0.0,
    latest: float = 1.0,
) -> Pairs:
    """Decide points against segments, each pair by itself.

    Parameters
    ----------
    start, end : array_like, shape (n, 3, 3)
        At the start and at the end of the step: the point, then the segment's ends.
    min_separation, latest
        As of `vertex_face`.

    Returns
    -------
    Pairs
        In the order of the input; u is the weight on the segment.

    Raises
    ------
    InvalidStep, InvalidOptions
        As of `vertex_face`.
    """
    return _decided(PairKind.VERTEX_EDGE, _core.vertex_edge, start, end, min_separation, latest)


def vertex_vertex(
    start: npt.ArrayLike,
    end: npt.ArrayLike,
    *,
    min_separation: float = 0.0,
    latest: float = 1.0,
) -> Pairs:
    """Decide points against points, each pair by itself.

    Parameters
    ----------
    start, end : array_like, shape (n, 2, 3)
        At the start and at the end of the step.
    min_separation, latest
        As of `vertex_face`.

    Returns
    -------
    Pairs
        In the order of the input.

    Raises
    ------
    InvalidStep, InvalidOptions
        As of `vertex_face`.
    """
    return _decided(PairKind.VERTEX_VERTEX, _core.vertex_vertex, start, end, min_separation, latest)


def _decided(
    kind: PairKind,
    decide: Callable[[Doubles, Doubles, float, float], npt.NDArray[np.uint8]],
    start: npt.ArrayLike,
    end: npt.ArrayLike,
    min_separation: float,
    latest: float,
) -> Pairs:
    d, until = number(min_separation, "min_separation"), number(latest, "latest")
    return Pairs(decide(*_both(start, end, _CORNERS[kind]), d, until), kind)


def _both(start: npt.ArrayLike, end: npt.ArrayLike, corners: int) -> tuple[Doubles, Doubles]:
    first, last = pairs(start, corners, "start"), pairs(end, corners, "end")
    if len(first) != len(last):
        raise InvalidStep(f"start has {len(first)} pairs, end {len(last)}: give as many")
    return first, last
