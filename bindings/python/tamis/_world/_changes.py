"""Changes of a world: which bodies there are, how they move, which of them may touch."""

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
    """Functions that add, move, switch and remove bodies; a base of `World`."""

    __slots__ = ()
    _world: _core.World

    def add(self, shape: Shape, motion: npt.ArrayLike | Deforming | None = None) -> int:
        """Add a body.

        Parameters
        ----------
        shape : Shape
            The body's shape, which may serve many bodies.
        motion : array_like or Deforming, optional
            A pose, shape (2, 3), position and rotation vector (`pose_of`): the body stays there. A chain, shape
            (links, 4, 3) (`chain_between`, `interpolated_chain`, `turned_chain`): the body moves by it as a whole. A
            `Deforming`: each vertex moves by itself. None: the body stays where the points of its shape are.

        Returns
        -------
        int
            The number of the body: 0, 1, 2, ...; never given twice.

        Raises
        ------
        InvalidOptions
            `shape` is not a `Shape`.
        InvalidPath
            The motion has another shape or type, or numbers that are not finite.
        InvalidStep
            A deforming body has not one point for each vertex, or points that are not finite; a body turns by more than
            4096 radians, or has a rotation vector longer than 2^32.
        """
        return int(self._world.add(known_shape(shape)._shape, *motion_of(AT_REST if motion is None else motion))[0])

    def add_many(self, shape: Shape, motions: npt.ArrayLike) -> Indices:
        """Add many bodies of one shape.

        Parameters
        ----------
        shape : Shape
            The shape of all bodies.
        motions : array_like, shape (n, 2, 3) or (n, links, 4, 3)
            Poses (`pose_of`): the bodies stay there. Or chains: the bodies move by them (`chain_between`).

        Returns
        -------
        array of int32, shape (n,)
            The numbers of the bodies, in the order of `motions`.

        Raises
        ------
        InvalidOptions, InvalidPath, InvalidStep
            As in `add`; then no body is added.
        """
        return self._world.add(known_shape(shape)._shape, motions_of(motions))

    def move(self, body: int, motion: npt.ArrayLike | Deforming) -> None:
        """Set the motion of a body from now on, of the same kind or another.

        Parameters
        ----------
        body : int
            The number that `add` returned.
        motion : array_like or Deforming
            As in `add`.

        Raises
        ------
        InvalidPath, InvalidStep
            As in `add`; then the body moves as before.
        InvalidOptions
            The world has no such body.
        """
        moved = whole(body, "body")
        self._world.move(np.array([moved], np.int32), *motion_of(motion, moved))

    def move_many(self, bodies: npt.ArrayLike, motions: npt.ArrayLike) -> None:
        """Set the motions of many bodies from now on: ``world.move_many(bodies, tamis.chain_between(start, end))``.

        Parameters
        ----------
        bodies : array_like of int, shape (n,)
            The numbers of the bodies, each once.
        motions : array_like, shape (n, 2, 3) or (n, links, 4, 3)
            One for each of `bodies`, as in `add_many`.

        Raises
        ------
        InvalidPath, InvalidStep
            As in `add`, or there are not as many motions as bodies; then no motion is set.
        InvalidOptions
            The world has no such body, or one is named twice; then no motion is set.
        """
        named = each_once(numbers_of(bodies))
        self._world.move(named, motions_of_bodies(motions, named))

    def remove(self, bodies: npt.ArrayLike) -> None:
        """Remove bodies from the world; their numbers are not given again.

        Parameters
        ----------
        bodies : int or array_like of int, shape (n,)
            The numbers of the bodies, each once.

        Raises
        ------
        InvalidOptions
            The world has no such body, or one is named twice; then none is removed.
        """
        self._world.remove(each_once(numbers_of(bodies)))

    def set_enabled(self, bodies: npt.ArrayLike, is_enabled: bool) -> None:
        """Switch bodies off or on again. Bodies that are off take no part in any question. Bodies begin switched on.

        Parameters
        ----------
        bodies : int or array_like of int, shape (n,)
            The numbers of the bodies.
        is_enabled : bool
            True: on. False: off.

        Raises
        ------
        InvalidOptions
            The world has no such body; then none is switched.
        """
        self._world.set_enabled(numbers_of(bodies), truth(is_enabled, "is_enabled"))

    def set_radius(self, bodies: npt.ArrayLike, radius: float) -> None:
        """Set the radius of bodies, half of their thickness; 0 at first.

        Two bodies are in contact where their distance is at most the minimum separation plus both radii, a deforming
        body with itself where it is at most the separation plus twice its own; for every question but `intersections`.

        Parameters
        ----------
        bodies : int or array_like of int, shape (n,)
            The numbers of the bodies.
        radius : float
            >= 0, in the unit of the points; the same for all these bodies.

        Raises
        ------
        InvalidOptions
            The world has no such body, or the radius is negative or not finite; then nothing changes.
        """
        self._world.set_radius(numbers_of(bodies), number(radius, "radius"))

    def set_may_touch(self, bodies: npt.ArrayLike, may_touch: bool) -> None:
        """Set whether pairs of bodies may touch.

        At first all pairs may, and a deforming body may touch itself.

        Parameters
        ----------
        bodies : array_like of int, shape (2,) or (n, 2)
            One pair of numbers, or many. A deforming body with itself is twice the same number.
        may_touch : bool
            False leaves these pairs out of every answer.

        Raises
        ------
        InvalidOptions
            The world has no such body, or `may_touch` is True for a body with itself that does not deform; then nothing
            changes.
        """
        pairs = indices(bodies, 2, "bodies", InvalidOptions, one_may_come_alone=True)
        self._world.set_may_touch(pairs, truth(may_touch, "may_touch"))
