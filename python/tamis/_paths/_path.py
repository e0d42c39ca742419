"""Curved motion: what all paths have in common, and the ready-made ones along polynomials."""

from __future__ import annotations

import abc

import numpy.typing as npt

from tamis import _core
from tamis._arrays import Doubles, point_frames
from tamis._checks import number
from tamis._errors import InvalidPath


class Path(abc.ABC):
    """How all vertices move for t in [0, 1], on curves: what `Detector.contacts` takes in place of start and end.

    Ready-made: `RigidPath`, `BezierPath`, `CatmullRomPath`. Any other motion: `FunctionPath`.
    """

    __slots__ = ()

    @abc.abstractmethod
    def _native(self) -> _core.Path:
        """Return what the compiled part asks."""

    @property
    def vertex_count(self) -> int:
        """Vertices that move on it."""
        return self._native().vertex_count

    def points_at(self, time: float) -> Doubles:
        """Where the vertices are at a time in [0, 1], shape (n, 3), rounded."""
        moment = number(time, "time", InvalidPath)
        if not 0 <= moment <= 1:
            raise InvalidPath(f"time is {moment}: give a number in [0, 1]")
        return self._native().points_at(moment)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.vertex_count} vertices)"


class CompiledPath(Path):
    """A path that the compiled part has a class for."""

    __slots__ = ("_path",)
    _path: _core.Path

    def _native(self) -> _core.Path:
        return self._path


class BezierPath(CompiledPath):
    """Each vertex on a Bezier curve: every polynomial motion can be written so.

    Parameters
    ----------
    control_points : array_like, shape (degree + 1, n, 3)
        The i-th control point of every vertex; at least one.

    Raises
    ------
    InvalidPath
        Another shape, or numbers that are not finite.
    """

    __slots__ = ()

    def __init__(self, control_points: npt.ArrayLike) -> None:
        self._path = _core.BezierPath(point_frames(control_points, "control_points", InvalidPath))


class CatmullRomPath(CompiledPath):
    """Through a sequence of frames at equal distances of time, smoothly.

    Between any two frames a cubic; its slope at a frame is (next - previous) / 2, at the first and the last one that of
    the chord.

    Parameters
    ----------
    frames : array_like, shape (frames, n, 3)
        Where each vertex is at t = i / (frames - 1); at least two.

    Raises
    ------
    InvalidPath
        Another shape, less than two frames, or numbers that are not finite.
    """

    __slots__ = ()

    def __init__(self, frames: npt.ArrayLike) -> None:
        self._path = _core.CatmullRomPath(point_frames(frames, "frames", InvalidPath))
