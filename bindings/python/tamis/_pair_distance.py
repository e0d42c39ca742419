"""The distances of pairs, and the time until which one pair keeps a fraction of its distance."""

from __future__ import annotations

import numpy.typing as npt

from tamis import _core
from tamis._answers import SafeStep
from tamis._arrays import pair_list, rows
from tamis._checks import number
from tamis._errors import InvalidStep
from tamis._tables._near import NearPairs
from tamis._tables._table import bracket_of


def distance_of(kind: npt.ArrayLike, vertices: npt.ArrayLike, positions: npt.ArrayLike) -> NearPairs:
    """Measure the distance of each of some pairs of features in one pose.

    Parameters
    ----------
    kind : array_like of PairKind, shape (n,)
        As in `Contacts` or `NearPairs`; one kind may serve for all pairs.
    vertices : array_like of int, shape (n, 4)
        Rows of the positions, ordered as in `Contact`. Entries that a kind does not use are not read. One pair may have
        the shape (4,).
    positions : array_like, shape (m, 3)
        Where each vertex is, at the start of a step for example.

    Returns
    -------
    NearPairs
        In the order of the input; the distances have the proven error of `NearPair.distance`.

    Raises
    ------
    InvalidStep
        An array of another shape or type, no such kind, an index that is not a row of the positions, or a
        coordinate that is not finite. The message names the pair.

    Examples
    --------
    >>> positions = [[0, 0, 1], [0, 0, 0], [1, 0, 0], [0, 1, 0]]
    >>> distance_of(PairKind.VERTEX_FACE, [0, 1, 2, 3], positions).distance
    array([1.])
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
    """Find how far one pair may go while it keeps a fraction of its distance: `Detector.safe_step` for one pair.

    Parameters
    ----------
    kind : PairKind
        The kind of the pair.
    vertices : array_like of int, shape (4,)
        Rows of the positions, ordered as in `Contact`.
    start, end : array_like, shape (m, 3)
        Where each vertex is at the start and at the end of the step.
    keep : float
        The fraction to keep, 0 <= keep < 1, of the distance as far as it exceeds the minimum separation. 0: only
        contact counts.
    min_separation : float
        d >= 0, in the unit of the positions: contact means Euclidean distance <= d.
    latest : float
        The latest time of interest, in [0, 1]. If the pair keeps its fraction until then, `toi_lower` is this time.

    Returns
    -------
    SafeStep
        On [0, toi_lower] the pair keeps the fraction, proven.

    Raises
    ------
    InvalidStep
        As in `distance_of`.
    InvalidOptions
        An option outside its range.
    """
    pair = pair_list(kind, vertices, InvalidStep)
    if len(pair[1]) != 1:
        raise InvalidStep(f"vertices has {len(pair[1])} rows: give one pair, (4,)")
    both = rows(start, "start"), rows(end, "end")
    kept, d, until = number(keep, "keep"), number(min_separation, "min_separation"), number(latest, "latest")
    return SafeStep(*bracket_of(_core.safe_step(*pair, *both, kept, d, until), NearPairs))
