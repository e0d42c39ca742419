"""What a question of `tamis.distributed.Detector` cost."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

__all__ = ["Balance", "Statistics"]


@dataclass(frozen=True)
class Statistics:
    """What the last question cost this rank.

    Attributes
    ----------
    owned, borrowed : int
        Elements (a triangle with its edges and corners, a loose edge, a loose point) that are this rank's to search,
        and those that others sent because boxes meet.
    pairs_tested : int
        Pairs of features whose boxes meet, some of them in two searches.
    boxes : int
        Moving boxes of all ranks, which every rank has.
    messages_sent, bytes_sent : int
        Collective operations included.
    decomposed_anew : bool
        Work was shared out anew.
    seconds : mapping of str to float
        Wall-clock time of positions, decompose, borrow, interior, border, deliver, and the total; with waiting.
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
    """Largest over mean, of all ranks: 1 where work is shared evenly."""

    pairs: float
    owned: float
