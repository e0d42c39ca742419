"""The numbers of a configuration: their names and limits, and checks of configurations that users give."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles, doubles, finite, numbers, shape_text
from tamis._checks import truth
from tamis._errors import InvalidPath

_BEYOND = 1e-9  # how far a value may be beyond a limit: planners round


@dataclass(frozen=True)
class Coordinates:
    """The joints that a configuration moves: a name, limits (d, 2) and whether it turns without limits, for each."""

    names: tuple[str, ...]
    limits: Doubles
    is_continuous: npt.NDArray[np.bool_]

    def some(self, given: npt.ArrayLike, name: str) -> Doubles:
        """Return configurations within the limits, shape (d,) or (n, d)."""
        array = numbers(given, name, InvalidPath)
        if array.ndim not in (1, 2) or array.shape[-1] != len(self.names):
            raise InvalidPath(
                f"{name} has the shape {shape_text(array)}: give a number for each of the {len(self.names)} joints "
                f"({', '.join(self.names)})"
            )
        values = finite(doubles(array), name, InvalidPath)
        beyond = (values < self.limits[:, 0] - _BEYOND) | (values > self.limits[:, 1] + _BEYOND)
        if beyond.any():
            place = tuple(np.argwhere(beyond)[0])
            low, high = self.limits[place[-1]]
            row = f"row {place[0]} of {name}" if values.ndim == 2 else name
            raise InvalidPath(
                f"joint {self.names[place[-1]]!r} is at {values[place]:.6g} in {row}, beyond its limits "
                f"{low:g} to {high:g}: keep within them"
            )
        return values

    def one(self, given: npt.ArrayLike, name: str) -> Doubles:
        """Return one configuration within the limits, shape (d,)."""
        values = self.some(given, name)
        if values.ndim != 1:
            raise InvalidPath(f"{name} has the shape {shape_text(values)}: give one configuration")
        return values

    def edges(self, start: npt.ArrayLike, end: npt.ArrayLike, whole_turns: bool) -> tuple[Doubles, Doubles]:
        """Return both ends of edges; raise if a continuous joint goes by more than half a turn in silence."""
        first, last = self.some(start, "start"), self.some(end, "end")
        if first.shape != last.shape:
            raise InvalidPath(f"start has the shape {shape_text(first)}, end {shape_text(last)}: give the same")
        long = self.is_continuous & (np.abs(last - first) > np.pi + _BEYOND)
        if not truth(whole_turns, "whole_turns") and long.any():
            place = tuple(np.argwhere(long)[0])
            raise InvalidPath(
                f"the continuous joint {self.names[place[-1]]!r} goes from {first[place]:.6g} to {last[place]:.6g}, "
                "by more than half a turn: pass shorter_way(start, end) as the end, or whole_turns=True if it shall"
            )
        return first, last

    def shorter_way(self, start: npt.ArrayLike, end: npt.ArrayLike) -> Doubles:
        """Return the ends, with continuous joints moved by whole turns."""
        first, last = self.some(start, "start"), self.some(end, "end")
        turns = np.round((last - first) / (2 * np.pi))
        moved: Doubles = last - np.where(self.is_continuous, turns * 2 * np.pi, 0.0)
        return moved
