"""The positions of all vertices of a model's surfaces in each state, and their path from one state to the next."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles, Indices
from tamis._paths._rigid_path import RigidPath
from tamis.mujoco._kinematics import Carriers
from tamis.mujoco._surfaces import Surface, vertices_by_nodes


@dataclass(frozen=True)
class _Turned:
    """Vertices with their positions in the frames of their bodies."""

    vertices: npt.NDArray[np.intp]
    bodies: Indices
    in_body: Doubles

    @classmethod
    def of(cls, which: npt.NDArray[np.bool_], bodies: Indices, in_body: Doubles) -> _Turned:
        """Choose the vertices where `which` is true; the arrays have one row a vertex."""
        return cls(np.flatnonzero(which), bodies[which], in_body[which])

    def add(self, state: Any, points: Doubles) -> None:
        """Add each vertex' offset, turned as its body is in `state` (`MjData`), to `points`: its body's origin."""
        if len(self.vertices):
            turns = state.xmat[self.bodies].reshape(-1, 3, 3)
            points[self.vertices] += np.einsum("nij,nj->ni", turns, self.in_body)


class Places:
    """The last two states that were seen, and the positions of all vertices in the last one.

    Vertices that never move are computed once; so are offsets from bodies that never turn.

    Attributes
    ----------
    before, now : MjData
        The two states, with their kinematics computed.
    points : array of float64, shape (n, 3)
        Where each vertex is in `now`.
    """

    def __init__(self, model: Any, parts: list[Surface], carriers: Carriers) -> None:
        self._model, self._carriers = model, carriers
        self.now, self.before = mujoco.MjData(model), mujoco.MjData(model)
        bodies, in_body = np.concatenate([part.bodies for part in parts]), np.vstack([part.points for part in parts])
        self._carrier = carriers.of_body[bodies]
        self._turning = np.flatnonzero(self._carrier)
        self._by_nodes = list(vertices_by_nodes(model, parts))
        is_sliding, is_moving = carriers.is_sliding[bodies], carriers.is_moving[bodies]
        for mine, _ in self._by_nodes:
            is_sliding[mine] = True
        self._sliding = np.flatnonzero((self._carrier > 0) & is_sliding)
        is_turned = is_moving & (self._carrier > 0) & in_body.any(axis=1)
        self._turned = _Turned.of(is_turned, bodies, in_body)
        mujoco.mj_kinematics(model, self.now)
        shifts = np.zeros_like(in_body)
        _Turned.of(~is_turned, bodies, in_body).add(self.now, shifts)
        self.points: Doubles = self.now.xpos[bodies] + shifts
        moving = np.flatnonzero(is_moving)
        self._moving, self._bodies = _span(moving), _span(bodies[moving])
        self._shifts = shifts[moving] if shifts[moving].any() else None

    @property
    def moving_points(self) -> Doubles:
        """The positions of the vertices that may move, shape (m, 3)."""
        return self.points[self._moving]

    def look(self, data: Any) -> None:
        """Copy a state as `now`, and compute the positions of all vertices in it."""
        self.now, self.before = self.before, self.now
        model, now = self._model, self.now
        now.time, now.qpos[:] = data.time, data.qpos
        if model.nmocap:
            now.mocap_pos[:], now.mocap_quat[:] = data.mocap_pos, data.mocap_quat
        mujoco.mj_kinematics(model, now)
        self.points = self.points.copy()
        moved = now.xpos[self._bodies]
        self.points[self._moving] = moved if self._shifts is None else moved + self._shifts
        self._turned.add(now, self.points)
        if self._by_nodes:
            mujoco.mj_flex(model, now)
        for mine, theirs in self._by_nodes:
            self.points[mine] = now.flexvert_xpos[theirs]

    def path(self, start: Doubles) -> RigidPath | None:
        """Return the path from `start`, the points of `before`, to `points`; None if nothing turns: all go straight."""
        turning = self._carriers.chains(self.before, self.now)
        if turning is None:
            return None
        chains, origins = turning
        rest, rest_end, some = start.copy(), self.points.copy(), self._turning
        rest[some] -= origins[self._carrier[some]]
        rest_end[some] = rest[some]
        self._pull_back(rest_end, origins)
        return RigidPath(rest, self._carrier, chains, rest_end)

    def _pull_back(self, rest_end: Doubles, origins: Doubles) -> None:
        """Write into `rest_end` where vertices that slide in a turning frame are in that frame at the end."""
        some = self._sliding
        if not len(some):
            return
        carrier, bodies = self._carrier[some], self._carriers.bodies
        first, last = (data.xmat[bodies].reshape(-1, 3, 3) for data in (self.before, self.now))
        back = first @ last.transpose(0, 2, 1)
        since = self.points[some] - self.now.xpos[bodies][carrier]
        rest_end[some] = np.einsum("nij,nj->ni", back[carrier], since)
        rest_end[some] += (self.before.xpos[bodies] - origins)[carrier]


def _span(numbers: npt.NDArray[Any]) -> npt.NDArray[Any] | slice:
    """Return consecutive numbers as a slice, which spares NumPy a copy; others as they are."""
    first = int(numbers[0]) if len(numbers) else 0
    last = first + len(numbers)
    return slice(first, last) if np.array_equal(numbers, np.arange(first, last)) else numbers
