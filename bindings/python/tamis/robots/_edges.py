"""Answers about edges, with names."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles

Flags = npt.NDArray[np.bool_]


class Edges(NamedTuple):
    """How far each of n edges is free, and what touches first.

    Attributes
    ----------
    is_free : array of bool, shape (n,)
        Whether the edge is free, which is a proof.
    fraction : array of float64, shape (n,)
        The edge is free before this part of it: 1 if it is free, 0 if its start overlaps.
    overlaps_at_start : array of bool, shape (n,)
        Whether two bodies pass through each other at the start, or one is inside another.
    pairs : list of n, each a tuple of two str, or None
        The names of the bodies that touch or overlap; None if the edge is free.
    points : array of float64, shape (n, 3)
        Where they touch, in the world's frame; NaN where nothing touches.
    """

    is_free: Flags
    fraction: Doubles
    overlaps_at_start: Flags
    pairs: list[tuple[str, str] | None]
    points: Doubles

    def __repr__(self) -> str:
        return f"Edges({len(self.is_free)} edges, {int(self.is_free.sum())} of them free)"


class TrajectoryAnswer(NamedTuple):
    """The first edge of a trajectory that is not free.

    Attributes
    ----------
    is_free : bool
        Whether the whole trajectory is free, which is a proof.
    edge : int or None
        Its number: from waypoint `edge` to the next. None if all edges are free.
    fraction : float
        This edge is free before this part of it; 1 if all edges are free.
    pair : tuple of two str, or None
        The names of the bodies that touch or overlap.
    point : array of float64, shape (3,), or None
        Where they touch, in the world's frame.
    """

    is_free: bool
    edge: int | None
    fraction: float
    pair: tuple[str, str] | None
    point: Doubles | None
