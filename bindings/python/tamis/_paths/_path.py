"""The base of all paths, and paths on polynomials."""

from __future__ import annotations

import abc
from typing import Any

import numpy.typing as npt

from tamis import _core
from tamis._arrays import Doubles, point_frames
from tamis._checks import number
from tamis._errors import InvalidPath


class Path(abc.ABC):
    """How all vertices move for t in [0, 1], on curves. `Detector.contacts` takes it instead of start and end.

    Ready-made: `RigidPath`, `BezierPath`, `CatmullRomPath`. For any other motion: `FunctionPath`.
    """

    __slots__ = ()

    @abc.abstractmethod
    def _native(self) -> _core.Path:
        """Return the compiled part's path."""

    @property
    def vertex_count(self) -> int:
        """The number of vertices."""
        return self._native().vertex_count

    def points_at(self, time: float) -> Doubles:
        """Return where the vertices are at `time` in [0, 1], rounded to doubles, shape (n, 3). Raises `InvalidPath`."""
        moment = number(time, "time", InvalidPath)
        if not 0 <= moment <= 1:
            raise InvalidPath(f"time is {moment}: give a number in [0, 1]")
        return self._native().points_at(moment)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.vertex_count} vertices)"

    def __reduce__(self) -> Any:
        kind = type(self).__name__
        raise TypeError(
            f"a {kind} cannot be pickled or copied: pickle what it was made of, and make one where you need it"
        )


class CompiledPath(Path):
    """A path that is compiled: subclasses set `_path`."""

    __slots__ = ("_path",)
    _path: _core.Path

    def _native(self) -> _core.Path:
        return self._path


class BezierPath(CompiledPath):
    """Each vertex on a Bezier curve: every polynomial motion can be written so.

    Parameters
    ----------
    control_points : array_like, shape (degree + 1, n, 3)
        ``control_points[i]`` holds the i-th control point of every vertex; at least one.

    Raises
    ------
    InvalidPath
        Another shape, or numbers that are not finite.
    """

    __slots__ = ()

    def __init__(self, control_points: npt.ArrayLike) -> None:
        self._path = _core.BezierPath(point_frames(control_points, "control_points", InvalidPath))


class CatmullRomPath(CompiledPath):
    """Through frames at equal distances of time, smoothly.

    A cubic between two frames, with the slope (next - previous) / 2 at each frame; the first and the last frame have
    the slope of the chord.

    Parameters
    ----------
    frames : array_like, shape (f, n, 3)
        ``frames[i]`` holds where each vertex is at t = i / (f - 1); f >= 2.

    Raises
    ------
    InvalidPath
        Another shape, fewer than two frames, or numbers that are not finite.
    """

    __slots__ = ()

    def __init__(self, frames: npt.ArrayLike) -> None:
        self._path = _core.CatmullRomPath(point_frames(frames, "frames", InvalidPath))
