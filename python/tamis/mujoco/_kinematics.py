"""The motion that MuJoCo means between two states: each joint at constant velocity, bodies carried by their parents."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np

from tamis._arrays import Doubles, Indices

_HINGE, _SLIDE, _BALL, _FREE = (getattr(mujoco.mjtJoint, f"mjJNT_{k}") for k in ("HINGE", "SLIDE", "BALL", "FREE"))


@dataclass(frozen=True)
class _Move:
    """A joint; or the motion of a mocap body as it is told, joint -1."""

    body: int
    joint: int


@dataclass(frozen=True)
class _Chain:
    """From the world to a body that turns: of each link the move that turns and those that slide before it."""

    turning: Indices
    sliding: list[Indices]
    trailing: Indices


class Carriers:
    """The bodies that turn, each with its chain of joints from the world on; number 0 is the world, which stays.

    A body that only slides goes straight in the frame of the nearest body above it that turns: its carrier.
    """

    def __init__(self, model: Any) -> None:
        self._model = model
        self._moves: dict[_Move, int] = {}
        self._chains: list[_Chain] = []
        self.bodies = [0]
        self.of_body: Indices = np.zeros(model.nbody, np.int32)
        self.is_moving = np.zeros(model.nbody, bool)
        self.is_sliding = np.zeros(model.nbody, bool)  # in its carrier's frame
        moves_to: list[list[_Move]] = [[]]
        for body in range(1, model.nbody):
            parent, own = int(model.body_parentid[body]), self._moves_of(body)
            moves_to.append(moves_to[parent] + own)
            self.of_body[body] = self.of_body[parent]
            self.is_moving[body] = bool(moves_to[body])
            if any(self._turns(move) for move in own):
                self.of_body[body] = len(self.bodies)
                self.bodies.append(body)
                self._chains.append(self._chain(moves_to[body]))
            self.is_sliding[body] = len(moves_to[body]) > len(moves_to[self.bodies[self.of_body[body]]])
        self._kinds = {kind: self._numbers_of(kind) for kind in (None, _HINGE, _SLIDE, _BALL, _FREE)}

    def _moves_of(self, body: int) -> list[_Move]:
        if self._model.body_mocapid[body] >= 0:
            return [_Move(body, -1)]
        first, count = int(self._model.body_jntadr[body]), int(self._model.body_jntnum[body])
        return [_Move(body, joint) for joint in range(first, first + count)]

    def _kind(self, move: _Move) -> Any:
        return mujoco.mjtJoint(self._model.jnt_type[move.joint]) if move.joint >= 0 else None

    def _turns(self, move: _Move) -> bool:
        return bool(self._kind(move) != _SLIDE)

    def _chain(self, moves: list[_Move]) -> _Chain:
        turning: list[int] = []
        sliding: list[list[int]] = [[]]
        for move in moves:
            number = self._moves.setdefault(move, len(self._moves))
            if self._turns(move):
                turning.append(number)
                sliding.append([])
            else:
                sliding[-1].append(number)
        *before, after = [np.array(numbers, np.int32) for numbers in sliding]
        return _Chain(np.array(turning, np.int32), before, after)

    def _numbers_of(self, kind: Any) -> tuple[Indices, Indices]:
        """Of all moves of one kind: their numbers; and their joints, or mocap bodies."""
        moves = [(number, move) for move, number in self._moves.items() if self._kind(move) == kind]
        things = [move.body if kind is None else move.joint for _, move in moves]
        return np.array([number for number, _ in moves], np.int32), np.array(things, np.int32)

    def chains(self, start: Any, end: Any) -> tuple[list[Doubles], Doubles]:
        """Return the links of each carrier, and the origin of its frame: the anchor of its last joint that turns.

        Of two `MjData` whose kinematics are computed.
        """
        anchors, turns, shifts = self._twists(start, end)
        chains, origins = [np.empty((0, 4, 3))], np.zeros((len(self.bodies), 3))
        for carrier, chain in enumerate(self._chains, 1):
            at = anchors[chain.turning]
            links = np.zeros((len(at) + (len(chain.trailing) > 0), 4, 3))
            links[: len(at), 0] = at
            links[1 : len(at), 0] -= at[:-1]
            links[: len(at), 2] = links[: len(at), 0] + shifts[chain.turning]
            for link, sliding in zip(links, [*chain.sliding, chain.trailing]):
                if len(sliding):
                    link[2] += shifts[sliding].sum(0)
            links[: len(at), 3] = turns[chain.turning]
            chains.append(links)
            origins[carrier] = at[-1]
        return chains, origins

    def _twists(self, start: Any, end: Any) -> tuple[Doubles, Doubles, Doubles]:
        """Of each move, in the world as it is at the start: its anchor, rotation vector and shift over the step."""
        model, change = self._model, np.zeros(self._model.nv)
        mujoco.mj_differentiatePos(model, change, 1.0, start.qpos, end.qpos)
        anchors, turns, shifts = (np.zeros((len(self._moves), 3)) for _ in range(3))
        for kind, (numbers, things) in self._kinds.items():
            if not len(numbers):
                continue
            if kind is None:
                self._told(start, end, numbers, things, (anchors, turns, shifts))
                continue
            dof = model.jnt_dofadr[things]
            anchors[numbers] = start.xanchor[things]
            if kind == _HINGE:
                turns[numbers] = start.xaxis[things] * change[dof, np.newaxis]
            elif kind == _SLIDE:
                shifts[numbers] = start.xaxis[things] * change[dof, np.newaxis]
            else:
                three = np.arange(3)
                if kind == _FREE:
                    shifts[numbers] = change[dof[:, np.newaxis] + three]
                    dof = dof + 3
                turns[numbers] = _in_world(start, model.jnt_bodyid[things], change[dof[:, np.newaxis] + three])
        return anchors, turns, shifts

    def turned_too_far(self, velocity: Doubles, seconds: float) -> int | None:
        """Return a body whose free or ball joint turns by more than half a turn, which two states do not show."""
        for kind, first in ((_BALL, 0), (_FREE, 3)):
            joints = self._kinds[kind][1]
            if not len(joints):
                continue
            dofs = self._model.jnt_dofadr[joints][:, np.newaxis] + np.arange(first, first + 3)
            far = np.flatnonzero(np.linalg.norm(velocity[dofs], axis=1) * seconds > 0.99 * np.pi)
            if len(far):
                return int(self._model.jnt_bodyid[joints[far[0]]])
        return None

    def _told(
        self, start: Any, end: Any, numbers: Indices, bodies: Indices, out: tuple[Doubles, Doubles, Doubles]
    ) -> None:
        """Mocap bodies: straight from one pose to the next, by the shorter turn at constant speed."""
        anchors, turns, shifts = out
        anchors[numbers], shifts[numbers] = start.xpos[bodies], end.xpos[bodies] - start.xpos[bodies]
        local = np.zeros((len(bodies), 3))
        for row, mocap in zip(local, self._model.body_mocapid[bodies]):
            mujoco.mju_subQuat(row, end.mocap_quat[mocap], start.mocap_quat[mocap])
        turns[numbers] = _in_world(start, bodies, local)


def _in_world(start: Any, bodies: Indices, vectors: Doubles) -> Doubles:
    """From each body's frame at the start."""
    turned: Doubles = np.einsum("nij,nj->ni", start.xmat[bodies].reshape(-1, 3, 3), vectors)
    return turned
