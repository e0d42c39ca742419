"""Paths that two Python functions of the user define."""

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
    """Any motion, defined by two functions. Answers are only as true as the bounds that these return.

    The functions are called from several threads, one call at a time; an exception in one reaches the caller of the
    question. This is slow: some microseconds a call, several calls a pair.

    Parameters
    ----------
    vertex_count : int
        The number of vertices, >= 0.
    points_at : callable
        ``points_at(time, vertices)``, `time` in [0, 1] and `vertices` an array of int32, shape (n,), returns the points
        of these vertices, shape (n, 3), and their errors, shape (n,) or one number. No coordinate may be off by more
        than the error, the function's own rounding included.
    deviations : callable
        ``deviations(start, end, vertices)`` returns a bound for each vertex, shape (n,) or one number: its greatest
        distance, at any time between the two, from the point that goes along its chord at constant speed. The bound
        must go to zero as the piece gets shorter; for smooth curves take ``|x''| (end - start)^2 / 8``.

    Raises
    ------
    InvalidPath
        `vertex_count` is negative, or a function cannot be called. Questions raise it if a function returns an array of
        another shape, a bound that is negative or NaN, or a position that is not finite.

    Examples
    --------
    Vertices that fall with the acceleration 2: the second derivative has the length 2.

    >>> rest = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]])
    >>> def points_at(time, vertices):
    ...     return rest[vertices] - [0, 0, time**2], 1e-15
    >>> def deviations(start, end, vertices):
    ...     return 2 * (end - start) ** 2 / 8 * (1 + 1e-15)
    >>> FunctionPath(3, points_at, deviations).points_at(0.5)[0]
    array([ 0.  ,  0.  , -0.25])
    """

    __slots__ = ("_deviations", "_points_at", "_vertex_count")

    def __init__(self, vertex_count: int, points_at: PointsAt, deviations: Deviations) -> None:
        self._vertex_count = whole(vertex_count, "vertex_count", 0, InvalidPath)
        self._points_at: PointsAt = function(points_at, "points_at", "points_at(time, vertices)", InvalidPath)
        self._deviations: Deviations = function(
            deviations, "deviations", "deviations(start, end, vertices)", InvalidPath
        )

    def _native(self) -> _core.Path:
        # Made anew for each question: a compiled path that is kept would hide its functions from the garbage collector.
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
