"""The motion that a question is about: a step with its start and end, or a path."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Union

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles, Indices, rows
from tamis._checks import number
from tamis._errors import InvalidOptions, InvalidPath, InvalidStep
from tamis._options import AtStart, path_options, query_options
from tamis._paths._path import Path
from tamis._tables._points import Corners, corners_at_rest, used_vertices

if TYPE_CHECKING:
    from tamis import _core

    Own = _core.QueryOptions | _core.PathOptions
    Native = tuple[Doubles, Doubles] | tuple[_core.Path]  # the arguments of the compiled part


@dataclass(frozen=True)
class StraightMotion:
    """A step: each vertex moves on a straight line."""

    start: Doubles
    end: Doubles

    def native(self) -> Native:
        """Return the arguments of the compiled part."""
        return self.start, self.end

    def bits(self) -> tuple[int, ...]:
        """Return sums that differ after each change of a single number."""
        return tuple(int(np.add.reduce(end.view(np.uint64), axis=None)) for end in (self.start, self.end))

    def corners(self, times: Doubles, vertices: Indices) -> Corners:
        """Return where the vertices of pair i are at ``times[i]``."""
        t = times[:, np.newaxis, np.newaxis]
        return (1 - t) * corners_at_rest(self.start, vertices, "start") + t * corners_at_rest(self.end, vertices, "end")


@dataclass(frozen=True)
class CurvedMotion:
    """A motion on a path."""

    path: Path

    def native(self) -> Native:
        """Return the arguments of the compiled part."""
        return (self.path._native(),)

    def bits(self) -> tuple[int, ...]:
        """Return nothing: the compiled part reads the path anew."""
        return ()

    def corners(self, times: Doubles, vertices: Indices) -> Corners:
        """Return where the vertices of pair i are at ``times[i]``."""
        path = self.path._native()
        used = used_vertices(path.vertex_count, vertices, InvalidPath)
        return path.corners_at(np.ascontiguousarray(times), np.ascontiguousarray(used)).reshape(*used.shape, 3)


AskedMotion = Union[StraightMotion, CurvedMotion]


def step_asked(
    start: npt.ArrayLike, end: npt.ArrayLike, min_separation: float | None, at_start: AtStart
) -> tuple[_core.QueryOptions, Doubles, Doubles]:
    """Check the arguments of a question about a step; return the arguments of the compiled part."""
    own = query_options(min_separation, at_start)
    return own, rows(start, "start"), rows(end, "end")


def step_asked_to_keep(
    start: npt.ArrayLike, end: npt.ArrayLike, keep: float, min_separation: float | None, at_start: AtStart
) -> tuple[_core.QueryOptions, float, Doubles, Doubles]:
    """Check the arguments of `safe_step` or `truncate`; return the arguments of the compiled part."""
    own, first, last = step_asked(start, end, min_separation, at_start)
    return own, number(keep, "keep"), first, last


def motion(start: npt.ArrayLike | Path, end: npt.ArrayLike | None, tolerance: float | None = None) -> AskedMotion:
    """Return the motion that the user gave: a `Path` as `start`, or both ends of a step, which has no tolerance."""
    if isinstance(start, Path):
        if end is not None:
            raise InvalidPath("the path says where everything goes: give no end beside it")
        return CurvedMotion(start)
    if end is None:
        raise InvalidStep("the end is missing: give the positions at the end of the step, or a Path alone")
    if tolerance is not None:
        raise InvalidOptions("tolerance is an option of paths: leave it out for a step")
    return StraightMotion(rows(start, "start"), rows(end, "end"))


def motion_asked(
    start: npt.ArrayLike | Path,
    end: npt.ArrayLike | None,
    min_separation: float | None,
    at_start: AtStart,
    tolerance: float | None,
) -> tuple[AskedMotion, Own]:
    """Check the arguments of a question about a step or a path; return its motion and its options."""
    moving = motion(start, end, tolerance)
    return moving, own_options(moving, min_separation, at_start, tolerance)


def own_options(
    moving: AskedMotion,
    min_separation: float | None = None,
    at_start: AtStart = "report",
    tolerance: float | None = None,
) -> Own:
    """Return the options of one question about this motion: a tolerance belongs to paths."""
    if isinstance(moving, CurvedMotion):
        return path_options(min_separation, at_start, tolerance)
    return query_options(min_separation, at_start)
