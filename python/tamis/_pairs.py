"""Many single pairs at once: for callers who have a broad phase of their own."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import Doubles, pairs
from tamis._columns import TimedPairs
from tamis._errors import InvalidStep
from tamis._options import Guarantee


class Pairs(TimedPairs):
    """What each pair does during the step, as arrays of length n. Only where `touches` have the others a meaning.

    The columns of `table` are touches, certainty, toi_lower, toi_upper, u, v, normal.
    """

    __slots__ = ()
    _dtype = np.dtype(_core.pair_layout())

    @property
    def touches(self) -> npt.NDArray[np.bool_]:
        """False: proven free."""
        return self._table["touches"]

    @property
    def certified(self) -> npt.NDArray[np.bool_]:
        """True: proven to touch. False: free, or unresolved."""
        return np.equal(self._table["certainty"], 0) & self.touches

    def __repr__(self) -> str:
        return f"Pairs({len(self)} pairs, {int(self.touches.sum())} touch)"


def vertex_face(
    start: npt.ArrayLike,
    end: npt.ArrayLike,
    *,
    guarantee: Guarantee = "exact",
    min_separation: float = 0.0,
    latest: float = 1.0,
) -> Pairs:
    """Decide vertices against faces, each pair by itself.

    Parameters
    ----------
    start, end : array_like, shape (n, 4, 3)
        At the start and at the end of the step: the vertex, then the face's corners. One pair may come as (4, 3).
        Contiguous doubles are read where they are; anything else is copied once.
    guarantee : str
        As of `Detector`.
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
    return Pairs(_core.vertex_face(*_both(start, end, 4), guarantee, min_separation, latest))


def edge_edge(
    start: npt.ArrayLike,
    end: npt.ArrayLike,
    *,
    guarantee: Guarantee = "exact",
    min_separation: float = 0.0,
    latest: float = 1.0,
) -> Pairs:
    """Decide edges against edges, each pair by itself.

    Parameters
    ----------
    start, end : array_like, shape (n, 4, 3)
        At the start and at the end of the step: points 0 and 1 are one edge, 2 and 3 the other.
    guarantee, min_separation, latest
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
    return Pairs(_core.edge_edge(*_both(start, end, 4), guarantee, min_separation, latest))


def vertex_edge(
    start: npt.ArrayLike,
    end: npt.ArrayLike,
    *,
    guarantee: Guarantee = "exact",
    min_separation: float = 0.0,
    latest: float = 1.0,
) -> Pairs:
    """Decide points against segments, each pair by itself.

    Parameters
    ----------
    start, end : array_like, shape (n, 3, 3)
        At the start and at the end of the step: the point, then the segment's ends.
    guarantee, min_separation, latest
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
    return Pairs(_core.vertex_edge(*_both(start, end, 3), guarantee, min_separation, latest))


def vertex_vertex(
    start: npt.ArrayLike,
    end: npt.ArrayLike,
    *,
    guarantee: Guarantee = "exact",
    min_separation: float = 0.0,
    latest: float = 1.0,
) -> Pairs:
    """Decide points against points, each pair by itself.

    Parameters
    ----------
    start, end : array_like, shape (n, 2, 3)
        At the start and at the end of the step.
    guarantee, min_separation, latest
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
    return Pairs(_core.vertex_vertex(*_both(start, end, 2), guarantee, min_separation, latest))


def _both(start: npt.ArrayLike, end: npt.ArrayLike, corners: int) -> tuple[Doubles, Doubles]:
    first, last = pairs(start, corners, "start"), pairs(end, corners, "end")
    if len(first) != len(last):
        raise InvalidStep(f"start has {len(first)} pairs, end {len(last)}: give as many")
    return first, last
