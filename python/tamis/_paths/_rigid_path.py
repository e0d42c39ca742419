"""Rigid bodies that turn, and chains of such motions."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import Doubles, doubles, finite, indices, numbers, packed_rows, point_frames, shape_text
from tamis._checks import number, shown
from tamis._errors import InvalidPath
from tamis._paths._path import CompiledPath


class RigidPath(CompiledPath):
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

    __slots__ = ()

    def __init__(
        self,
        rest: npt.ArrayLike,
        body_of_vertex: npt.ArrayLike,
        chains: Sequence[npt.ArrayLike],
        rest_end: npt.ArrayLike | None = None,
    ) -> None:
        points = packed_rows(rest, "rest", InvalidPath)
        ends = points if rest_end is None else packed_rows(rest_end, "rest_end", InvalidPath)
        if len(ends) != len(points):
            raise InvalidPath(f"rest_end has {len(ends)} rows, rest {len(points)}: give one each a vertex")
        is_list = isinstance(chains, (Sequence, np.ndarray)) and getattr(chains, "ndim", 1) > 0
        if not is_list or isinstance(chains, (str, bytes)):
            raise InvalidPath(f"chains is {shown(chains)}: give a list with a chain for each body, (links, 4, 3)")
        links = [links_of(chain, f"chain {body}") for body, chain in enumerate(chains)]
        self._path = _core.RigidPath(points, indices(body_of_vertex, 0, "body_of_vertex", InvalidPath), links, ends)


def pose_of(rotation: npt.ArrayLike, position: npt.ArrayLike) -> Doubles:
    """Make poses of rotations as engines keep them, also in float32.

    Parameters
    ----------
    rotation : array_like, shape (n, 4), (n, 3, 3) or (n, 3)
        Quaternions w, x, y, z (of x, y, z, w as SciPy and Bullet have them: ``q[:, [3, 0, 1, 2]]``), matrices by their
        rows, or rotation vectors: an axis, with the angle in radians as its length. Of quaternions and matrices what is
        off from a rotation by no more than 1e-4 (|q|^2 - 1, an entry of R R^T - I) becomes the nearest one.
    position : array_like, shape (n, 3)
        Where each body's origin is. One pose alone: (3,), beside (4,), (3, 3) or (3,).

    Returns
    -------
    array, shape (n, 2, 3)
        Position and rotation vector of each; (2, 3) of one alone.

    Raises
    ------
    InvalidPath
        Shapes that do not fit, numbers that are not finite, or what is farther from a rotation; the message says which.
    """
    points, is_one = _threes(position, "position")
    turns = numbers(rotation, "rotation", InvalidPath)
    many = finite(np.ascontiguousarray(turns[np.newaxis] if is_one else turns, np.float64), "rotation", InvalidPath)
    if many.shape[1:] not in ((4,), (3, 3), (3,)) or len(many) != len(points):
        raise InvalidPath(
            f"rotation has the shape {shape_text(turns)}, position {shape_text(np.asarray(position))}: give a "
            "quaternion, a matrix or a rotation vector for each position, (n, 4), (n, 3, 3) or (n, 3)"
        )
    poses = np.stack([points, many], 1) if many.shape[1:] == (3,) else _core.poses_of(many, points).reshape(-1, 2, 3)
    return poses[0] if is_one else poses


def interpolated(start: npt.ArrayLike, end: npt.ArrayLike) -> Doubles:
    """Make a chain whose position and rotation vector go linearly from one pose to the other.

    Parameters
    ----------
    start, end : array_like, shape (2, 3) or (n, 2, 3)
        Poses, of one body or of n.

    Returns
    -------
    array, shape (1, 4, 3) or (n, 1, 4, 3)
        A chain of one link each.

    Raises
    ------
    InvalidPath
        Other shapes, or numbers that are not finite.
    """
    (first, last), is_one = _alike(start=_poses(start, "start"), end=_poses(end, "end"))
    return _chains(_core.interpolated(first, last), 1, is_one)


def turned(
    start: npt.ArrayLike, turn: npt.ArrayLike, end_position: npt.ArrayLike, *, center: npt.ArrayLike | None = None
) -> Doubles:
    """Make a chain that turns at constant speed about a fixed axis while one point of the body goes straight.

    Parameters
    ----------
    start : array_like, shape (2, 3) or (n, 2, 3)
        A pose, or one for each of n bodies.
    turn : array_like, shape (3,) or (n, 3)
        The axis, as long as the angle in radians. Any angle.
    end_position : array_like, shape (3,) or (n, 3)
        Where that point of the body gets to.
    center : array_like, shape (3,) or (n, 3), optional
        That point in the body's frame: engines take the center of mass. By default the origin of the frame.

    Returns
    -------
    array, shape (2, 4, 3) or (n, 2, 4, 3)
        A chain of two links each.

    Raises
    ------
    InvalidPath
        Other shapes, or numbers that are not finite.
    """
    (first, axes, ends), is_one = _alike(
        start=_poses(start, "start"), turn=_threes(turn, "turn"), end_position=_threes(end_position, "end_position")
    )
    return _chains(_core.turned(first, axes, ends, _centers(center, len(first))), 2, is_one)


def between(start: npt.ArrayLike, end: npt.ArrayLike, *, center: npt.ArrayLike | None = None) -> Doubles:
    """Make a chain from one pose to the other by the shorter turn about a fixed axis, at constant speed (slerp).

    Parameters
    ----------
    start, end : array_like, shape (2, 3) or (n, 2, 3)
        Poses, of one body or of n.
    center : array_like, shape (3,) or (n, 3), optional
        The point of the body that goes straight, as of `turned`.

    Returns
    -------
    array, shape (2, 4, 3) or (n, 2, 4, 3)
        A chain of two links each.

    Raises
    ------
    InvalidPath
        Other shapes, or numbers that are not finite.
    """
    (first, last), is_one = _alike(start=_poses(start, "start"), end=_poses(end, "end"))
    return _chains(_core.between(first, last, _centers(center, len(first))), 2, is_one)


def pose_at(chain: npt.ArrayLike, time: float) -> Doubles:
    """Say where a chain takes its body, as after a step of which a part is safe.

    Parameters
    ----------
    chain : array_like, shape (links, 4, 3) or (n, links, 4, 3)
        A chain, or one for each of n bodies.
    time : float
        In [0, 1].

    Returns
    -------
    array, shape (2, 3) or (n, 2, 3)
        Position and rotation vector: of one link as it goes, of more links as a turn of at most pi.

    Raises
    ------
    InvalidPath
        Other shapes, numbers that are not finite, or a time outside [0, 1].
    """
    chains = numbers(chain, "chain", InvalidPath)
    if chains.ndim not in (3, 4) or chains.shape[-2:] != (4, 3):
        raise InvalidPath(
            f"chain has the shape {shape_text(chains)}: give (links, 4, 3), or as many as you like at once"
        )
    many = doubles(chains if chains.ndim == 4 else chains[np.newaxis])
    return _core.pose_at(finite(many, "chain", InvalidPath), number(time, "time", InvalidPath)).reshape(
        *chains.shape[:-3], 2, 3
    )


def nlerp_deviation(start: npt.ArrayLike, end: npt.ArrayLike) -> Doubles:
    """Bound how far engines that blend quaternions and normalize them (nlerp) are from `between`.

    Parameters
    ----------
    start, end : array_like, shape (2, 3) or (n, 2, 3)
        Poses.

    Returns
    -------
    array, shape (n,)
        A factor for each body: no point is farther from where `between` has it than this times its distance from the
        center. What is free by `between` with as much separation is free by theirs.

    Raises
    ------
    InvalidPath
        Other shapes, or numbers that are not finite.
    """
    (first, last), _ = _alike(start=_poses(start, "start"), end=_poses(end, "end"))
    return _core.nlerp_deviation(first, last)


def links_of(given: npt.ArrayLike, name: str) -> Doubles:
    """Return the links of one chain, (links, 4, 3)."""
    links = point_frames(given, name, InvalidPath)
    if links.shape[1] != 4:
        raise InvalidPath(f"{name} has links of {links.shape[1]} rows: give position and rotation, at start and end")
    return links


def _poses(given: npt.ArrayLike, name: str) -> tuple[Doubles, bool]:
    return _one_or_many(given, name, (2, 3), "no pose: give its position and its rotation vector, (2, 3)")


def _threes(given: npt.ArrayLike, name: str) -> tuple[Doubles, bool]:
    return _one_or_many(given, name, (3,), "no vector: give three numbers, (3,)")


def _one_or_many(given: npt.ArrayLike, name: str, shape: tuple[int, ...], advice: str) -> tuple[Doubles, bool]:
    """Return n of this shape, and whether it is one alone."""
    array = numbers(given, name, InvalidPath)
    if array.shape[-len(shape) :] != shape or array.ndim > len(shape) + 1:
        raise InvalidPath(
            f"{name} has the shape {shape_text(array)}, which is {advice}; or as many as you like at once"
        )
    many = doubles(array).reshape(-1, *shape)
    return finite(many, name, InvalidPath), array.ndim == len(shape)


def _alike(**given: tuple[Doubles, bool]) -> tuple[list[Doubles], bool]:
    """Return as many of each, and whether that is one alone."""
    counts = {name: len(array) for name, (array, _) in given.items()}
    if len(set(counts.values())) > 1:
        raise InvalidPath(f"{', '.join(f'{name} has {n}' for name, n in counts.items())}: give as many of each")
    return [array for array, _ in given.values()], all(is_one for _, is_one in given.values())


def _centers(given: npt.ArrayLike | None, count: int) -> Doubles:
    """Return one for each of so many bodies, from one for all, one for each, or none."""
    centers, is_one = _threes(np.zeros(3) if given is None else given, "center")
    if not is_one and len(centers) != count:
        raise InvalidPath(f"center has {len(centers)}, start has {count}: give one, or as many")
    return np.repeat(centers, count, axis=0) if is_one else centers


def _chains(links: Doubles, of_each: int, is_one: bool) -> Doubles:
    return links.reshape(-1, 4, 3) if is_one else links.reshape(-1, of_each, 4, 3)
