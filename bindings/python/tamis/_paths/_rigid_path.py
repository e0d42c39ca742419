"""Paths of rigid bodies, their poses, and the chains of links that move them."""

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
        The body of each vertex, in [0, len(chains)).
    chains : sequence of array_like, shape (links, 4, 3)
        One chain a body, as `interpolated_chain`, `turned_chain` and `chain_between` return them. The rows of a link
        are position and rotation vector (axis times angle in radians) at the start, then at the end; both are linear in
        t. Outermost link first: a point of the body goes through the last link first.
    rest_end : array_like, shape (n, 3), optional
        Where each vertex is in its body's frame at the end; it goes there straight. So a body deforms while it turns; a
        body whose chain has no links, shape (0, 4, 3), moves straight. By default all vertices stay at `rest`.

    Raises
    ------
    InvalidPath
        Sizes that do not fit each other, or numbers that are not finite.
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
    """Make poses from rotations as engines keep them, also in float32.

    Parameters
    ----------
    rotation : array_like, shape (n, 4), (n, 3, 3) or (n, 3)
        Quaternions w, x, y, z (for x, y, z, w, the order of SciPy and Bullet: ``q[:, [3, 0, 1, 2]]``), matrices by
        rows, or rotation vectors: axis times angle in radians. A quaternion or matrix that is off by rounding, at most
        1e-4 in ``|q|^2 - 1`` or an entry of ``R R^T - I``, becomes the nearest rotation.
    position : array_like, shape (n, 3)
        Where each body's origin is. For one pose alone the shape is (3,), with a rotation of (4,), (3, 3) or (3,).

    Returns
    -------
    array of float64, shape (n, 2, 3)
        Position and rotation vector of each pose; shape (2, 3) for one alone.

    Raises
    ------
    InvalidPath
        Shapes that do not fit each other, numbers that are not finite, or a rotation that is off by more than that, or
        a reflection. The message says which.

    Examples
    --------
    A quarter turn about z:

    >>> pose_of([0.5**0.5, 0, 0, 0.5**0.5], [1, 2, 3])
    array([[1.        , 2.        , 3.        ],
           [0.        , 0.        , 1.57079633]])
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


def interpolated_chain(start: npt.ArrayLike, end: npt.ArrayLike) -> Doubles:
    """Make a chain whose position and rotation vector are linear in t, from one pose to the other.

    Parameters
    ----------
    start, end : array_like, shape (2, 3) or (n, 2, 3)
        The poses of one body, or of n bodies.

    Returns
    -------
    array of float64, shape (1, 4, 3) or (n, 1, 4, 3)
        For each body a chain of one link.

    Raises
    ------
    InvalidPath
        Other shapes, or numbers that are not finite.
    """
    (first, last), is_one = _alike(start=_poses(start, "start"), end=_poses(end, "end"))
    return _chains(_core.interpolated_chain(first, last), 1, is_one)


def turned_chain(
    start: npt.ArrayLike, turn: npt.ArrayLike, end_position: npt.ArrayLike, *, center: npt.ArrayLike | None = None
) -> Doubles:
    """Make a chain that turns at constant speed about a fixed axis while the body's `center` goes straight.

    Parameters
    ----------
    start : array_like, shape (2, 3) or (n, 2, 3)
        The pose at the start of one body, or of n bodies.
    turn : array_like, shape (3,) or (n, 3)
        Axis times angle in radians, in the world's frame. Any angle: 2 pi is a full turn.
    end_position : array_like, shape (3,) or (n, 3)
        Where `center` is at the end.
    center : array_like, shape (3,) or (n, 3), optional
        The point that goes straight, in the body's frame: engines take the center of mass. By default the origin of the
        frame.

    Returns
    -------
    array of float64, shape (2, 4, 3) or (n, 2, 4, 3)
        For each body a chain of two links.

    Raises
    ------
    InvalidPath
        Other shapes, or numbers that are not finite.
    """
    (first, axes, ends), is_one = _alike(
        start=_poses(start, "start"), turn=_threes(turn, "turn"), end_position=_threes(end_position, "end_position")
    )
    return _chains(_core.turned_chain(first, axes, ends, _centers(center, len(first))), 2, is_one)


def chain_between(start: npt.ArrayLike, end: npt.ArrayLike, *, center: npt.ArrayLike | None = None) -> Doubles:
    """Make a chain from one pose to the other by the shorter turn about a fixed axis, at constant speed (slerp).

    Parameters
    ----------
    start, end : array_like, shape (2, 3) or (n, 2, 3)
        The poses of one body, or of n bodies.
    center : array_like, shape (3,) or (n, 3), optional
        The point of the body that goes straight, as in `turned_chain`.

    Returns
    -------
    array of float64, shape (2, 4, 3) or (n, 2, 4, 3)
        For each body a chain of two links.

    Raises
    ------
    InvalidPath
        Other shapes, or numbers that are not finite.
    """
    (first, last), is_one = _alike(start=_poses(start, "start"), end=_poses(end, "end"))
    return _chains(_core.chain_between(first, last, _centers(center, len(first))), 2, is_one)


def pose_at(chain: npt.ArrayLike, time: float) -> Doubles:
    """Return the pose of a chain's body at `time`, for example after a step that is safe until then.

    Parameters
    ----------
    chain : array_like, shape (links, 4, 3) or (n, links, 4, 3)
        A chain, or one for each of n bodies.
    time : float
        In [0, 1].

    Returns
    -------
    array of float64, shape (2, 3) or (n, 2, 3)
        Position and rotation vector. For one link these are linear in time; for more links the rotation is at most pi.

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
    """Bound how far the motion of engines that blend and normalize quaternions (nlerp) deviates from `chain_between`.

    Parameters
    ----------
    start, end : array_like, shape (2, 3) or (n, 2, 3)
        The poses of one body, or of n bodies.

    Returns
    -------
    array of float64, shape (n,)
        A factor for each body; n = 1 for one pose. By nlerp no point is ever farther from its place by `chain_between`
        than this factor times the point's distance from the center. A motion that is free by `chain_between`, with this
        deviation as additional separation, is free by nlerp.

    Raises
    ------
    InvalidPath
        Other shapes, or numbers that are not finite.
    """
    (first, last), _ = _alike(start=_poses(start, "start"), end=_poses(end, "end"))
    return _core.nlerp_deviation(first, last)


def links_of(given: npt.ArrayLike, name: str) -> Doubles:
    """Return the links of one chain, shape (links, 4, 3)."""
    links = point_frames(given, name, InvalidPath)
    if links.shape[1] != 4:
        raise InvalidPath(f"{name} has links of {links.shape[1]} rows: give position and rotation, at start and end")
    return links


def _poses(given: npt.ArrayLike, name: str) -> tuple[Doubles, bool]:
    return _one_or_many(given, name, (2, 3), "no pose: give its position and its rotation vector, (2, 3)")


def _threes(given: npt.ArrayLike, name: str) -> tuple[Doubles, bool]:
    return _one_or_many(given, name, (3,), "no vector: give three numbers, (3,)")


def _one_or_many(given: npt.ArrayLike, name: str, shape: tuple[int, ...], advice: str) -> tuple[Doubles, bool]:
    """Return an array of the shape (n, *shape), and whether one alone was given, without the first dimension."""
    array = numbers(given, name, InvalidPath)
    if array.shape[-len(shape) :] != shape or array.ndim > len(shape) + 1:
        raise InvalidPath(
            f"{name} has the shape {shape_text(array)}, which is {advice}; or as many as you like at once"
        )
    many = doubles(array).reshape(-1, *shape)
    return finite(many, name, InvalidPath), array.ndim == len(shape)


def _alike(**given: tuple[Doubles, bool]) -> tuple[list[Doubles], bool]:
    """Return the arrays, which must have the same length, and whether all of them were given as one alone."""
    counts = {name: len(array) for name, (array, _) in given.items()}
    if len(set(counts.values())) > 1:
        raise InvalidPath(f"{', '.join(f'{name} has {n}' for name, n in counts.items())}: give as many of each")
    return [array for array, _ in given.values()], all(is_one for _, is_one in given.values())


def _centers(given: npt.ArrayLike | None, count: int) -> Doubles:
    """Return a center for each of `count` bodies, from one for all, one for each, or None: the origin."""
    centers, is_one = _threes(np.zeros(3) if given is None else given, "center")
    if not is_one and len(centers) != count:
        raise InvalidPath(f"center has {len(centers)}, start has {count}: give one, or as many")
    return np.repeat(centers, count, axis=0) if is_one else centers


def _chains(links: Doubles, of_each: int, is_one: bool) -> Doubles:
    return links.reshape(-1, 4, 3) if is_one else links.reshape(-1, of_each, 4, 3)
