"""Answers about edges, with names."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles

Flags = npt.NDArray[np.bool_]


class Edges(NamedTuple):
    """Answers about n edges: how far each is free, and what touches first.

    `is_free` (n,): a proof. `fraction` (n,): the edge is free before this part of it; 1 if it is free, 0 if its start
    overlaps. `overlaps_at_start` (n,). `pairs`: for each edge the names of both bodies that touch or overlap, None if
    it is free. `points` (n, 3): where they touch, in the world's frame; else not a number.
    """

    is_free: Flags
    fraction: Doubles
    overlaps_at_start: Flags
    pairs: list[tuple[str, str] | None]
    points: Doubles

    def __repr__(self) -> str:
        return f"Edges({len(self.is_free)} edges, {int(self.is_free.sum())} of them free)"


class TrajectoryAnswer(NamedTuple):
    """The first edge of a trajectory that is not free: its number, how far it is free, what touches there and where.

    All are None if the whole trajectory is free, and `fraction` is 1.
    """

    is_free: bool
    edge: int | None
    fraction: float
    pair: tuple[str, str] | None
    point: Doubles | None
