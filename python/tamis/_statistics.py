"""What the last question to a detector cost."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class Statistics:
    """What the last question cost.

    Attributes
    ----------
    isa : str
        The instruction set that ran.
    threads : int
        How many were used.
    stages : mapping of str to (int, int, int, int)
        Pairs of each `PairKind` that entered each stage, in the pipeline's order. The first counts the pairs whose
        boxes meet, and some more, which depend on earlier questions.
    decided_by : mapping of str to int
        Pairs decided by each arithmetic: lanes, scalar, exact; and unresolved, of paths alone.
    seconds : mapping of str to float
        Wall-clock time of bounds, build, traverse, filter, solve, and the total.
    ignored : int
        With ``at_start="ignore"``, of contacts, earliest and is_free: pairs that touch at the start, and not again once
        they are apart; earliest and is_free count those that they looked at.
    nodes_visited : int
        Of the hierarchy.
    rebuilt : bool
        The hierarchy was built, not refitted.
    memory_bytes : int
        Held by the detector.
    """

    isa: str
    threads: int
    stages: Mapping[str, tuple[int, int, int, int]]
    decided_by: Mapping[str, int]
    seconds: Mapping[str, float]
    ignored: int
    nodes_visited: int
    rebuilt: bool
    memory_bytes: int
