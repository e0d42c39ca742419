"""What a world is told: which bodies there are, how they move, which take part."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import Indices, indices
from tamis._checks import number, truth, whole
from tamis._errors import InvalidOptions
from tamis._world._bodies import (
    AT_REST,
    Deforming,
    Shape,
    each_once,
    known_shape,
    motion_of,
    motions_of,
    motions_of_bodies,
    numbers_of,
)


class Changes:
    """Bodies come, move on, are switched off and on, and go; part of `World`."""

    __slots__ = ()
    _world: _core.World

    def add(self, shape: Shape, motion: npt.ArrayLike | Deforming | None = None) -> int:
        """Add a body.

        Parameters
        ----------
        shape : Shape
            Its mesh; one may serve many bodies.
        motion : array_like or Deforming, optional
            A pose, shape (2, 3): position and rotation vector, where it stays (`pose_of`). A chain, shape (links, 4,
            3): it moves by it (`between`, `interpolated`, `turned`). Or `Deforming`. None: stays as its shape is given.

        Returns
        -------
        int
            Names the body: 0, 1, 2, ..., never given twice.

        Raises
        ------
        InvalidPath
            No pose and no chain, or numbers that are not finite.
        InvalidStep
            A deforming body with other than one point a vertex, or one that is not finite; a body that turns by more
            than 4096 radians, or a rotation vector longer than 2^32.
        """
        return int(self._world.add(known_shape(shape)._shape, *motion_of(AT_REST if motion is None else motion))[0])

    def add_many(self, shape: Shape, motions: npt.ArrayLike) -> Indices:
        """Add bodies of one shape.

        Parameters
        ----------
        shape : Shape
            Of all.
        motions : array_like, shape (n, 2, 3) or (n, links, 4, 3)
            Poses, where they stay (`pose_of`), or chains, by which they move (`between`).

        Returns
        -------
        array of int, shape (n,)
            Names them, in order.

        Raises
        ------
        InvalidPath, InvalidStep
            As of `add`; then none is added.
        """
        return self._world.add(known_shape(shape)._shape, motions_of(motions))

    def move(self, body: int, motion: npt.ArrayLike | Deforming) -> None:
        """Say how a body moves from now on; it may also begin to move in another way.

        Parameters
        ----------
        body : int
            That `add` has returned.
        motion : array_like or Deforming
            As of `add`.

        Raises
        ------
        InvalidPath, InvalidStep
            As of `add`; then it moves as before.
        InvalidOptions
            The body is not there.
        """
        moved = whole(body, "body")
        self._world.move(np.array([moved], np.int32), *motion_of(motion, moved))

    def move_many(self, bodies: npt.ArrayLike, motions: npt.ArrayLike) -> None:
        """Say how bodies move from now on, all in one call: ``world.move_many(bodies, tamis.between(start, end))``.

        Parameters
        ----------
        bodies : array_like of int, shape (n,)
            Each once.
        motions : array_like, shape (n, 2, 3) or (n, links, 4, 3)
            Of each, as of `add_many`.

        Raises
        ------
        InvalidPath, InvalidStep
            As of `add`, or not as many; then none is moved.
        InvalidOptions
            A body that is not there, or one twice; then none is moved.
        """
        named = each_once(numbers_of(bodies))
        self._world.move(named, motions_of_bodies(motions, named))

    def remove(self, bodies: npt.ArrayLike) -> None:
        """Take bodies out of the world; their numbers are not given again.

        Parameters
        ----------
        bodies : int or array_like of int, shape (n,)
            Which, each once.

        Raises
        ------
        InvalidOptions
            A body that is not there, or one twice; then none is removed.
        """
        self._world.remove(each_once(numbers_of(bodies)))

    def set_enabled(self, bodies: npt.ArrayLike, is_enabled: bool) -> None:
        """Switch bodies off, so that they take no part in any question, or on again; they begin switched on.

        Parameters
        ----------
        bodies : int or array_like of int, shape (n,)
            Which.
        is_enabled : bool
            On, or off.

        Raises
        ------
        InvalidOptions
            A body that is not there; then none is switched.
        """
        self._world.set_enabled(numbers_of(bodies), truth(is_enabled, "is_enabled"))

    def set_radius(self, bodies: npt.ArrayLike, radius: float) -> None:
        """Give bodies a radius, half of their thickness, in the unit of the points; at first 0.

        Bodies are in contact where their distance is at most the minimum separation plus both radii.

        Parameters
        ----------
        bodies : int or array_like of int, shape (n,)
            Which.
        radius : float
            >= 0, of all of them.

        Raises
        ------
        InvalidOptions
            A body that is not there, or a radius that is negative or not finite; then nothing has changed.
        """
        self._world.set_radius(numbers_of(bodies), number(radius, "radius"))

    def set_may_touch(self, bodies: npt.ArrayLike, may_touch: bool) -> None:
        """Say of pairs of bodies whether they may touch at all.

        At first all may but two that both stay; a deforming one may touch itself.

        Parameters
        ----------
        bodies : array_like of int, shape (2,) or (n, 2)
            One pair or many; a deforming body with itself is twice the same.
        may_touch : bool
            False leaves these pairs out of every answer.

        Raises
        ------
        InvalidOptions
            A body that is not there: nothing has changed. True for two bodies that both stay, or for one with itself
            that does not deform: what was said of the pairs before them holds.
        """
        pairs = indices(bodies, 2, "bodies", InvalidOptions, one_may_come_alone=True)
        self._world.set_may_touch(pairs, truth(may_touch, "may_touch"))
