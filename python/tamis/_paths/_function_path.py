"""Any motion, by two functions of Python's."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import Doubles, Indices, numbers, packed_rows, vector
from tamis._checks import function, whole
from tamis._errors import InvalidPath
from tamis._paths._path import Path

PointsAt = Callable[[float, Indices], "tuple[npt.ArrayLike, npt.ArrayLike]"]
Deviations = Callable[[float, float, Indices], npt.ArrayLike]


class FunctionPath(Path):
    """Any motion, by two functions. Every answer is as true as what they promise.

    They are asked from several threads, one at a time; an exception that one raises arrives at the caller. Slow: some
    microseconds a call, several calls a pair.

    Parameters
    ----------
    vertex_count : int
        Vertices that move.
    points_at : callable
        ``points_at(time, vertices)`` gives the points of these vertices, shape (n, 3), and their errors, shape (n,) or
        one number: no coordinate is off by more than that. What rounding does to the function is part of it.
    deviations : callable
        ``deviations(start, end, vertices)`` gives a bound for each vertex, shape (n,) or one number: at no time t
        between the two is it farther than that from its chord, walked at constant speed. It must go to zero with the
        piece; for smooth curves a bound of |x''| (end - start)^2 / 8 will do.

    Raises
    ------
    InvalidPath
        The number of vertices is negative. Later, of every question: an answer of another shape, a bound that is
        negative or no number, a position that is not finite.
    """

    __slots__ = ("_deviations", "_points_at", "_vertex_count")

    def __init__(self, vertex_count: int, points_at: PointsAt, deviations: Deviations) -> None:
        self._vertex_count = whole(vertex_count, "vertex_count", 0, InvalidPath)
        self._points_at: PointsAt = function(points_at, "points_at", "points_at(time, vertices)", InvalidPath)
        self._deviations: Deviations = function(
            deviations, "deviations", "deviations(start, end, vertices)", InvalidPath
        )

    def _native(self) -> _core.Path:
        # Made anew for each question, so that Python's garbage collector sees all that refers to the functions.
        return _core.FunctionPath(self._vertex_count, self._checked_points, self._checked_deviations)

    def _checked_points(self, time: float, vertices: Indices) -> tuple[Doubles, Doubles]:
        answer = self._points_at(time, vertices)
        if not isinstance(answer, tuple) or len(answer) != 2:
            raise InvalidPath("points_at gave no pair: give the points and their errors")
        points = packed_rows(answer[0], "what points_at gave", InvalidPath)
        if len(points) != len(vertices):
            raise InvalidPath(f"points_at gave {len(points)} points for {len(vertices)} vertices: give one each")
        return points, _one_each(answer[1], len(vertices), "the errors of points_at")

    def _checked_deviations(self, start: float, end: float, vertices: Indices) -> Doubles:
        return _one_each(self._deviations(start, end, vertices), len(vertices), "what deviations gave")


def _one_each(given: npt.ArrayLike, count: int, name: str) -> Doubles:
    array = numbers(given, name, InvalidPath)
    bounds = vector(array if array.ndim else np.repeat(array, count), name, InvalidPath)
    if len(bounds) != count:
        raise InvalidPath(f"{name}: {len(bounds)} numbers for {count} vertices: give one each")
    return bounds
