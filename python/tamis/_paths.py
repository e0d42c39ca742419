"""Curved motion: rigid bodies that turn, and single pairs of their features."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import Doubles, indices, rows, vector
from tamis._errors import InvalidPath
from tamis._pairs import Pairs


class RigidPath:
    """Bodies that each move on a chain of links: curves, on which pairs are decided without cutting them into pieces.

    Parameters
    ----------
    rest : array_like, shape (n, 3)
        Each vertex in its body's own frame.
    body_of_vertex : array_like of int, shape (n,)
        The body of each vertex, from 0.
    chains : sequence of array_like, shape (links, 4, 3)
        One a body; a link is position and rotation vector at the start, then at the end, and both go linearly.
        Outermost first: a point of the body goes through the last link first. See `interpolated`, `turned`, `between`.

    Raises
    ------
    InvalidPath
        Sizes that do not fit, or numbers that are not finite.
    """

    __slots__ = ("_path", "_vertex_count")

    def __init__(self, rest: npt.ArrayLike, body_of_vertex: npt.ArrayLike, chains: Sequence[npt.ArrayLike]) -> None:
        points = np.ascontiguousarray(rows(rest, "rest", InvalidPath))
        links = [np.ascontiguousarray(chain, dtype=np.float64).reshape(-1, 4, 3) for chain in chains]
        self._path = _core.RigidPath(points, indices(body_of_vertex, 0, "body_of_vertex", InvalidPath), links)
        self._vertex_count = len(points)

    def points_at(self, time: float) -> Doubles:
        """Where the vertices are at a time in [0, 1], shape (n, 3), rounded."""
        if not 0 <= time <= 1:
            raise InvalidPath(f"the time is {time}: give a number in [0, 1]")
        return self._path.points_at(time)

    def vertex_face(self, vertices: npt.ArrayLike, *, min_separation: float = 0.0, tolerance: float = 1e-9) -> Pairs:
        """Decide vertices against faces.

        Parameters
        ----------
        vertices : array_like of int, shape (n, 4)
            The vertex, then the face's corners, by their numbers in the path.
        min_separation : float
            d >= 0: contact means Euclidean distance <= d.
        tolerance : float
            Widest bracket of a contact, in (0, 1]; a fraction of the step.

        Returns
        -------
        Pairs
            Free is proven. What cannot be decided is a contact that is not certified.
        """
        return Pairs(self._path.vertex_face(indices(vertices, 4, "vertices", InvalidPath), min_separation, tolerance))

    def edge_edge(self, vertices: npt.ArrayLike, *, min_separation: float = 0.0, tolerance: float = 1e-9) -> Pairs:
        """Decide edges against edges, shape (n, 4); otherwise as `vertex_face`."""
        return Pairs(self._path.edge_edge(indices(vertices, 4, "vertices", InvalidPath), min_separation, tolerance))

    def vertex_edge(self, vertices: npt.ArrayLike, *, min_separation: float = 0.0, tolerance: float = 1e-9) -> Pairs:
        """Decide points against segments, shape (n, 3); otherwise as `vertex_face`."""
        return Pairs(self._path.vertex_edge(indices(vertices, 3, "vertices", InvalidPath), min_separation, tolerance))

    def vertex_vertex(self, vertices: npt.ArrayLike, *, min_separation: float = 0.0, tolerance: float = 1e-9) -> Pairs:
        """Decide points against points, shape (n, 2); otherwise as `vertex_face`."""
        return Pairs(self._path.vertex_vertex(indices(vertices, 2, "vertices", InvalidPath), min_separation, tolerance))

    def __repr__(self) -> str:
        return f"RigidPath({self._vertex_count} vertices)"


def interpolated(start: npt.ArrayLike, end: npt.ArrayLike) -> Doubles:
    """Make a chain whose position and rotation vector go linearly from one pose, shape (2, 3), to the other."""
    return _core.interpolated(_pose(start, "start"), _pose(end, "end")).reshape(-1, 4, 3)


def turned(start: npt.ArrayLike, turn: npt.ArrayLike, end_position: npt.ArrayLike) -> Doubles:
    """Make a chain that turns about the axis `turn`, by its length in radians, while the origin goes straight."""
    axis, end = vector(turn, "turn", InvalidPath), vector(end_position, "end_position", InvalidPath)
    if axis.shape != (3,) or end.shape != (3,):
        raise InvalidPath("turn and end_position are three numbers each: give them so")
    return _core.turned(_pose(start, "start"), axis, end).reshape(-1, 4, 3)


def between(start: npt.ArrayLike, end: npt.ArrayLike) -> Doubles:
    """Make a chain from one pose to the other by the shorter turn about a fixed axis, at constant speed."""
    return _core.between(_pose(start, "start"), _pose(end, "end")).reshape(-1, 4, 3)


def _pose(given: npt.ArrayLike, name: str) -> Doubles:
    pose = np.ascontiguousarray(rows(given, name, InvalidPath))
    if len(pose) != 2:
        raise InvalidPath(f"{name} is no pose: give its position and its rotation vector, (2, 3)")
    return pose
