"""The cost of the last question of `tamis.distributed.Detector`."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class Statistics:
    """The cost of the last question on this rank.

    Attributes
    ----------
    owned, borrowed : int
        The number of elements (a triangle with its edges and corners, a loose edge, a loose point) that this rank
        searches, and of those that other ranks sent to it because boxes meet.
    pairs_tested : int
        Pairs of features whose boxes meet; some count twice, in two searches.
    boxes : int
        Moving boxes of all ranks together; every rank has all of them.
    messages_sent, bytes_sent : int
        Sent by this rank, collective operations included.
    decomposed_anew : bool
        Whether this question divided the elements among the ranks anew.
    seconds : mapping of str to float
        Wall-clock seconds of positions, decompose, borrow, interior, border, deliver, and the total; waiting included.
    """

    owned: int
    borrowed: int
    pairs_tested: int
    boxes: int
    messages_sent: int
    bytes_sent: int
    decomposed_anew: bool
    seconds: Mapping[str, float]


@dataclass(frozen=True)
class Balance:
    """How evenly ranks share the work: the largest number of a rank over the mean of all ranks; 1 is even.

    Attributes
    ----------
    pairs : float
        Of `Statistics.pairs_tested`.
    owned : float
        Of `Statistics.owned`.
    """

    pairs: float
    owned: float
