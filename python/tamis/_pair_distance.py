"""How far apart single pairs are, and how long one keeps a part of that."""

from __future__ import annotations

import numpy.typing as npt

from tamis import _core
from tamis._answers import SafeStep, safe_step_of
from tamis._arrays import pair_list, rows
from tamis._checks import number
from tamis._errors import InvalidStep
from tamis._tables._near import NearPairs


def distance_of(kind: npt.ArrayLike, vertices: npt.ArrayLike, positions: npt.ArrayLike) -> NearPairs:
    """Measure how far apart pairs of features are at rest, each by itself.

    Parameters
    ----------
    kind : array_like of PairKind, shape (n,)
        As in `Contacts` or `NearPairs`; one may serve for all.
    vertices : array_like of int, shape (n, 4)
        Rows of the positions, ordered as in `Contact`; what a kind does not use is not read. One pair may come as (4,).
    positions : array_like, shape (m, 3)
        Where each vertex is, at the start of a step for example.

    Returns
    -------
    NearPairs
        In the order of the input, with the proven error that `Detector.pairs_within` has.

    Raises
    ------
    InvalidStep
        A wrong shape or type, a kind that is none, an index that is no row, a coordinate that is not finite; the
        message names the pair.
    """
    return NearPairs(_core.distances_of(*pair_list(kind, vertices, InvalidStep), rows(positions, "positions")))


def safe_step(
    kind: int,
    vertices: npt.ArrayLike,
    start: npt.ArrayLike,
    end: npt.ArrayLike,
    keep: float = 0.1,
    *,
    min_separation: float = 0.0,
    latest: float = 1.0,
) -> SafeStep:
    """Find how far one pair may go so that it keeps a fraction of its distance: `Detector.safe_step` of a pair.

    Parameters
    ----------
    kind : PairKind
        What the vertices are.
    vertices : array_like of int, shape (4,)
        Rows of the positions, ordered as in `Contact`.
    start, end : array_like, shape (m, 3)
        Where each vertex is at the start and at the end of the step.
    keep : float
        0 <= keep < 1, of what exceeds the minimum separation. 0: only contact counts.
    min_separation : float
        d >= 0: contact means Euclidean distance <= d.
    latest : float
        The latest time of interest, in [0, 1]: the search ends there, and `lower` is then this time.

    Returns
    -------
    SafeStep
        On [0, lower] the pair keeps the fraction: proven.

    Raises
    ------
    InvalidStep, InvalidOptions
        As of `distance_of`, and an option outside its range.
    """
    pair = pair_list(kind, vertices, InvalidStep)
    if len(pair[1]) != 1:
        raise InvalidStep(f"vertices has {len(pair[1])} rows: give one pair, (4,)")
    both = rows(start, "start"), rows(end, "end")
    kept, d, until = number(keep, "keep"), number(min_separation, "min_separation"), number(latest, "latest")
    return safe_step_of(_core.safe_step(*pair, *both, kept, d, until))
