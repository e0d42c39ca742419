"""Linkages: joints that move bodies of a world, by the numbers of a configuration."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import Doubles, Indices, doubles, finite, indices, numbers, packed_rows, shape_text, vector
from tamis._checks import instance, shown, word
from tamis._errors import InvalidOptions, InvalidPath
from tamis._world._bodies import each_once, numbers_of

JointKind = Literal["fixed", "turning", "sliding"]
_KINDS = {"fixed": 0, "turning": 1, "sliding": 2}


class Linkage:
    """A tree of joints, or several, and the bodies of a world that they carry: a robot.

    Frame of joint j = frame of its parent * ``places[j]`` * motion about or along ``axes[j]`` by its value, as in a
    URDF. Its value is ``factors[j] * q[coordinates[j]] + offsets[j]``. Between two configurations each number goes
    linearly, so each body moves by a chain of its joints, on its true curve. To attach an object to a hand, make
    another linkage that has it, too.

    Parameters
    ----------
    parents : array_like of int, shape (j,)
        For each joint the joint that carries it, before it in the list; -1: the world.
    places : array_like, shape (j, 2, 3)
        The pose of each joint's frame in the frame of its parent, as `pose_of` makes it.
    kinds : sequence of str
        For each joint "fixed", "turning" (about its axis, in radians) or "sliding" (along its axis).
    axes : array_like, shape (j, 3)
        For each joint its axis, in its own frame; the direction alone counts. No matter for fixed joints.
    coordinates : array_like of int, shape (j,)
        For each joint which number of a configuration moves it; no matter for fixed joints.
    bodies : array_like of int, shape (b,)
        The numbers of the bodies in their world, each once.
    carriers : array_like of int, shape (b,)
        The joint that carries each of them. A body that no joint moves is not listed: `World.add` gives it its pose.
    body_places : array_like, shape (b, 2, 3), optional
        The pose of each body in the frame of its joint; by default the joint's frame.
    factors, offsets : array_like, shape (j,), optional
        As above, for joints that mimic others; by default 1 and 0.

    Raises
    ------
    InvalidOptions
        A parent that is not before its joint, a joint that moves without an axis or coordinate, a body that is named
        twice, a joint that does not exist; lists of different lengths.
    InvalidPath
        Arrays of another shape, or numbers that are not finite.

    Examples
    --------
    A rod that turns about the z axis:

    >>> rod = Shape(Mesh([[0, 1, 2]]), [[0, 0, 0], [2, 0, 0], [0, 0, 0.1]])
    >>> world = World()
    >>> body, post = world.add(rod), world.add(rod, [[0, 1, 0], [0, 0, 0]])
    >>> arm = Linkage([-1], [[[0, 0, 0]] * 2], ["turning"], [[0, 0, 1]], [0], [body], [0])
    >>> world.edges_are_free(arm, [[0], [0]], [[0.3], [2]]).tolist()
    [True, False]
    """

    __slots__ = ("_bodies", "_given", "_linkage")

    def __init__(
        self,
        parents: npt.ArrayLike,
        places: npt.ArrayLike,
        kinds: Sequence[JointKind],
        axes: npt.ArrayLike,
        coordinates: npt.ArrayLike,
        bodies: npt.ArrayLike,
        carriers: npt.ArrayLike,
        body_places: npt.ArrayLike | None = None,
        *,
        factors: npt.ArrayLike | None = None,
        offsets: npt.ArrayLike | None = None,
    ) -> None:
        parent_of = indices(parents, 0, "parents", InvalidOptions)
        self._bodies = each_once(numbers_of(bodies))
        joints, carried = len(parent_of), len(self._bodies)
        at_rest = np.zeros((carried, 2, 3)) if body_places is None else body_places
        self._given: tuple[Any, ...] = (
            parent_of,
            _poses(places, joints, "places"),
            _kinds(kinds, joints),
            finite(_as_many(packed_rows(axes, "axes", InvalidPath), joints, "axes"), "axes", InvalidPath),
            _as_many(indices(coordinates, 0, "coordinates", InvalidOptions), joints, "coordinates"),
            _vector(factors, 1.0, joints, "factors"),
            _vector(offsets, 0.0, joints, "offsets"),
            self._bodies,
            _as_many(indices(carriers, 0, "carriers", InvalidOptions), carried, "carriers"),
            _poses(at_rest, carried, "body_places"),
        )
        self._linkage = _core.Linkage(*self._given)

    @property
    def dimension(self) -> int:
        """How many numbers a configuration has: one more than the largest coordinate."""
        return self._linkage.dimension()

    @property
    def bodies(self) -> Indices:
        """The numbers of the bodies, shape (b,)."""
        return self._bodies.copy()

    def motions(self, starts: npt.ArrayLike, ends: npt.ArrayLike) -> Doubles:
        """Compute how the bodies move from configuration to configuration.

        A body's chain has a link for each joint that moves it, outermost first, then its constant place. Shorter chains
        end in links of zeros, which do nothing.

        Parameters
        ----------
        starts, ends : array_like, shape (n, d) or (d,)
            Configurations; d is `dimension`.

        Returns
        -------
        array of float64, shape (n, b, links, 4, 3), or (b, links, 4, 3)
            For each motion a chain for each body, as `World.earliest_many` takes them.

        Raises
        ------
        InvalidPath
            Arrays of another shape, or numbers that are not finite.
        """
        first, last, alone = edges_of(self, starts, ends)
        chains = self._linkage.motions(first, last)
        return chains[0] if alone else chains

    def __repr__(self) -> str:
        return f"Linkage({len(self._given[0])} joints, {len(self._bodies)} bodies, dimension {self.dimension})"

    def __reduce__(self) -> tuple[Any, ...]:
        return _unpickled, self._given


def _unpickled(*given: Any) -> Linkage:
    parents, places, kinds, axes, coordinates, factors, offsets, bodies, carriers, body_places = given
    words = [list(_KINDS)[kind] for kind in kinds]
    return Linkage(
        parents, places, words, axes, coordinates, bodies, carriers, body_places, factors=factors, offsets=offsets
    )


def known_linkage(given: Linkage) -> Linkage:
    """Return the argument if it is a `Linkage`, else raise."""
    return instance(given, Linkage, "linkage", "a tamis.Linkage")


def configurations_of(linkage: Linkage, given: npt.ArrayLike, name: str) -> Doubles:
    """Return configurations, shape (n, dimension)."""
    array = numbers(given, name, InvalidPath)
    dimension = known_linkage(linkage).dimension
    if array.ndim != 2 or array.shape[1] != dimension:
        raise InvalidPath(
            f"{name} has the shape {shape_text(array)}: give (n, {dimension}), a number for each coordinate"
        )
    return finite(doubles(array), name, InvalidPath)


def edges_of(linkage: Linkage, starts: npt.ArrayLike, ends: npt.ArrayLike) -> tuple[Doubles, Doubles, bool]:
    """Return starts and ends, shape (n, dimension) each, and whether one edge was given alone."""
    first, last = numbers(starts, "starts", InvalidPath), numbers(ends, "ends", InvalidPath)
    alone = first.ndim == 1 and last.ndim == 1
    if alone:
        first, last = first[np.newaxis], last[np.newaxis]
    from_, to = configurations_of(linkage, first, "starts"), configurations_of(linkage, last, "ends")
    if len(from_) != len(to):
        raise InvalidPath(f"starts has {len(from_)} rows, ends {len(to)}: give as many")
    return from_, to, alone


def _as_many(array: Any, count: int, name: str) -> Any:
    if len(array) != count:
        owner = "bodies" if name in ("carriers", "body_places") else "joints"
        raise InvalidOptions(f"{name} has {len(array)} entries, and there are {count} {owner}: give as many")
    return array


def _poses(given: npt.ArrayLike, count: int, name: str) -> Doubles:
    array = numbers(given, name, InvalidPath)
    if array.size == 0 and count == 0:
        return np.empty((0, 2, 3))
    if array.shape[1:] != (2, 3):
        raise InvalidPath(
            f"{name} has the shape {shape_text(array)}: give poses (n, 2, 3), as tamis.pose_of makes them"
        )
    return finite(doubles(_as_many(array, count, name)), name, InvalidPath)


def _vector(given: npt.ArrayLike | None, default: float, count: int, name: str) -> Doubles:
    if given is None:
        return np.full(count, default)
    return finite(_as_many(vector(given, name, InvalidPath), count, name), name, InvalidPath)


def _kinds(given: Sequence[JointKind], count: int) -> Indices:
    if isinstance(given, str) or not hasattr(given, "__len__") or getattr(given, "ndim", 1) != 1:
        raise InvalidOptions(f"kinds is {shown(given)}: give a list, such as ['turning', 'fixed']")
    for kind in _as_many(given, count, "kinds"):
        if word(kind, "kinds") not in _KINDS:
            raise InvalidOptions(f"kinds holds {shown(kind)}: give 'fixed', 'turning' or 'sliding'")
    return np.array([_KINDS[kind] for kind in given], np.int32)
