"""Checks that the part of a model that a referee read once has not changed."""

from __future__ import annotations

from typing import Any

import numpy as np

from tamis._errors import InvalidStep
from tamis.mujoco._surfaces import Surface

_OF_ALL_GEOMS = ("geom_contype", "geom_conaffinity")
_OF_SURFACES = ("geom_type", "geom_size", "geom_pos", "geom_quat", "geom_dataid")
_OF_BODIES = ("xpos", "xmat")
_OF_FLEXES = ("flex_contype", "flex_conaffinity", "flex_selfcollide")


class Watch:
    """Raises if the surfaces that collide have changed in the model, or static bodies have another place."""

    def __init__(self, model: Any, states: list[Any], parts: list[Surface], is_moving: Any) -> None:
        geoms = np.array([part.geom for part in parts if part.geom >= 0], np.intp)
        bodies = np.unique(np.concatenate([part.bodies for part in parts]))
        standing = bodies[~is_moving[bodies]]
        chosen = [(name, slice(None)) for name in _OF_ALL_GEOMS + _OF_FLEXES] + [(name, geoms) for name in _OF_SURFACES]
        # Views of the memory of the model, and of both states that `require_same` is called with.
        self._model = [(name, getattr(model, name), which) for name, which in chosen]
        self._states = {id(state): [(name, getattr(state, name), standing) for name in _OF_BODIES] for state in states}
        self._known = [array[which].tobytes() for _, array, which in self._model + self._states[id(states[0])]]

    def require_same(self, state: Any) -> None:
        """Raise if the model, or `state` with its kinematics computed, has changed since the start."""
        for (name, array, which), known in zip(self._model + self._states[id(state)], self._known):
            if array[which].tobytes() != known:
                raise InvalidStep(
                    f"{name} of surfaces that collide has changed since the referee was made: make another one after "
                    "each change of the model"
                )
