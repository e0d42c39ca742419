"""The cost of a detector's last question."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class Statistics:
    """The cost of the last question.

    Attributes
    ----------
    isa : str
        The instruction set that ran.
    threads : int
        The number of threads that were used.
    stages : mapping of str to (int, int, int, int)
        For each stage, in the pipeline's order, the number of pairs of each `PairKind` that entered it. The first stage
        counts the pairs whose boxes meet, and some more, which depend on earlier questions.
    decided_by : mapping of str to int
        The number of pairs that each arithmetic decided: lanes, scalar, exact; and unresolved, on paths only.
    seconds : mapping of str to float
        Wall-clock seconds of bounds, build, traverse, filter, solve, and the total.
    ignored : int
        With ``at_start="ignore"``, the number of pairs that touch at the start and do not touch again once they are
        apart. `contacts` counts all such pairs; `earliest` and `is_free` count those that they look at.
    nodes_visited : int
        Nodes of the hierarchy's trees; 0 if pairs had been listed ahead.
    rebuilt : bool
        Whether the hierarchy was built, not refitted.
    memory_bytes : int
        Memory that the detector holds.
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
