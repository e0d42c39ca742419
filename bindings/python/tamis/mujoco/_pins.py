"""Pinned vertices of flexes: MuJoCo lets features with a vertex on a body pass through the geoms of that body."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from tamis._arrays import Indices
from tamis._kinds import both_features
from tamis._tables._contacts import Contacts
from tamis._tables._near import Intersections
from tamis.mujoco._surfaces import Surface

# Numbers instead of a body. They differ, so a vertex of no flex never meets a vertex of no geom.
_OF_NO_FLEX, _OF_NO_GEOM = -1, -2


class Pins:
    """Skips pairs of a flex and a geom if a vertex of the flex' feature is carried by the geom's body.

    MuJoCo's `mj_collideGeomElem` does so. It does not for planes, nor for flexes whose vertices are moved by nodes.
    """

    def __init__(self, model: Any, parts: list[Surface]) -> None:
        counts = [len(part.points) for part in parts]
        bodies = [self._bodies(model, part) for part in parts]
        self._is_flex = np.repeat([part.flex >= 0 for part in parts], counts)
        self._of_flex = np.where(self._is_flex, np.concatenate(bodies), _OF_NO_FLEX)
        self._of_geom = np.where(self._is_flex, _OF_NO_GEOM, np.concatenate(bodies))
        self._has_some = bool(np.isin(self._of_flex[self._is_flex], self._of_geom).any())

    @staticmethod
    def _bodies(model: Any, part: Surface) -> Indices:
        if part.is_plane or part.is_by_nodes:
            return np.full(len(part.points), _OF_NO_GEOM if part.is_plane else _OF_NO_FLEX, np.int32)
        return part.bodies

    def without(self, found: Contacts) -> Contacts:
        """Return the contacts without pairs that MuJoCo lets pass."""
        if not self._has_some or not len(found):
            return found
        return found[~self._are_pinned(*both_features(found.kind, found.vertices))]

    def without_intersections(self, found: Intersections) -> Intersections:
        """Return the intersections without pairs that MuJoCo lets pass."""
        if not self._has_some or not len(found):
            return found
        return found[~self._are_pinned(found.edge, found.face)]

    def _are_pinned(self, first: Indices, second: Indices) -> npt.NDArray[np.bool_]:
        """Return which pairs MuJoCo lets pass, shape (n,). Arguments: the vertices of both features, unused ones -1."""
        return self._rides_on(first, second) | self._rides_on(second, first)

    def _rides_on(self, flex: Indices, geom: Indices) -> npt.NDArray[np.bool_]:
        of_flex = np.where(flex >= 0, self._of_flex[flex], _OF_NO_FLEX)
        of_geom = np.where(geom >= 0, self._of_geom[geom], _OF_NO_GEOM)
        meets: npt.NDArray[np.bool_] = (of_flex[:, :, np.newaxis] == of_geom[:, np.newaxis, :]).any(axis=(1, 2))
        return meets
