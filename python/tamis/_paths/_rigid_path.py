"""Rigid bodies that turn, and chains of such motions."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import Doubles, finite, indices, point_frames, rows, vector
from tamis._checks import shown
from tamis._errors import InvalidPath
from tamis._paths._path import Path


class RigidPath(Path):
    """Bodies that each move on a chain of links.

    Parameters
    ----------
    rest : array_like, shape (n, 3)
        Each vertex in its body's own frame.
    body_of_vertex : array_like of int, shape (n,)
        The body of each vertex, from 0.
    chains : sequence of array_like, shape (links, 4, 3)
        One a body; a link is position and rotation vector at the start, then at the end, and both go linearly.
        Outermost first: a point of the body goes through the last link first. See `interpolated`, `turned`, `between`.
    rest_end : array_like, shape (n, 3), optional
        Where each vertex is in its body's frame at the end, having gone there straight: a body that deforms while it
        turns; with a chain of no links, straight motion beside bodies that turn. By default all stay at `rest`.

    Raises
    ------
    InvalidPath
        Sizes that do not fit, or numbers that are not finite.
    """

    __slots__ = ("_path",)

    def __init__(
        self,
        rest: npt.ArrayLike,
        body_of_vertex: npt.ArrayLike,
        chains: Sequence[npt.ArrayLike],
        rest_end: npt.ArrayLike | None = None,
    ) -> None:
        points = np.ascontiguousarray(rows(rest, "rest", InvalidPath))
        ends = points if rest_end is None else np.ascontiguousarray(rows(rest_end, "rest_end", InvalidPath))
        if len(ends) != len(points):
            raise InvalidPath(f"rest_end has {len(ends)} rows, rest {len(points)}: give one each a vertex")
        is_list = isinstance(chains, (Sequence, np.ndarray)) and getattr(chains, "ndim", 1) > 0
        if not is_list or isinstance(chains, (str, bytes)):
            raise InvalidPath(f"chains is {shown(chains)}: give a list with a chain for each body, (links, 4, 3)")
        links = [_links(chain, f"chain {body}") for body, chain in enumerate(chains)]
        self._path = _core.RigidPath(points, indices(body_of_vertex, 0, "body_of_vertex", InvalidPath), links, ends)

    def _native(self) -> _core.Path:
        return self._path


def interpolated(start: npt.ArrayLike, end: npt.ArrayLike) -> Doubles:
    """Make a chain whose position and rotation vector go linearly from one pose, shape (2, 3), to the other."""
    return _core.interpolated(_pose(start, "start"), _pose(end, "end")).reshape(-1, 4, 3)


def turned(start: npt.ArrayLike, turn: npt.ArrayLike, end_position: npt.ArrayLike) -> Doubles:
    """Make a chain that turns about the axis `turn`, by its length in radians, while the origin goes straight."""
    axis, end = _three(turn, "turn"), _three(end_position, "end_position")
    return _core.turned(_pose(start, "start"), axis, end).reshape(-1, 4, 3)


def between(start: npt.ArrayLike, end: npt.ArrayLike) -> Doubles:
    """Make a chain from one pose to the other by the shorter turn about a fixed axis, at constant speed."""
    return _core.between(_pose(start, "start"), _pose(end, "end")).reshape(-1, 4, 3)


def _links(given: npt.ArrayLike, name: str) -> Doubles:
    links = point_frames(given, name, InvalidPath)
    if links.shape[1] != 4:
        raise InvalidPath(f"{name} has links of {links.shape[1]} rows: give position and rotation, at start and end")
    return links


def _three(given: npt.ArrayLike, name: str) -> Doubles:
    numbers = finite(vector(given, name, InvalidPath), name, InvalidPath)
    if len(numbers) != 3:
        raise InvalidPath(f"{name} has {len(numbers)} numbers: give three")
    return numbers


def _pose(given: npt.ArrayLike, name: str) -> Doubles:
    pose = finite(np.ascontiguousarray(rows(given, name, InvalidPath)), name, InvalidPath)
    if len(pose) != 2:
        raise InvalidPath(f"{name} is no pose: give its position and its rotation vector, (2, 3)")
    return pose
