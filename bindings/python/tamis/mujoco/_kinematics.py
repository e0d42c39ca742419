"""MuJoCo's motion between two states: each joint at constant velocity, each body carried by its parent."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np

from tamis._arrays import Doubles, Indices

_NONE = -1
_HINGE, _SLIDE, _BALL, _FREE = (getattr(mujoco.mjtJoint, f"mjJNT_{k}") for k in ("HINGE", "SLIDE", "BALL", "FREE"))


@dataclass(frozen=True)
class _Move:
    """The motion of a body by one joint, or of a mocap body by its given poses: joint -1."""

    body: int
    joint: int


class _Links:
    """The links of all chains: in each chain one link for each move that turns, and one for slides after the last.

    Moves are numbered as the rows of the arrays of `_twists`; row -1, the last, belongs to no move.
    """

    def __init__(self) -> None:
        self.moves: list[int] = []  # of each link, the move that turns it; _NONE if it only slides
        self.before: list[int] = []  # of each link, the move that turns the link before in its chain, or _NONE
        self.sliding: list[tuple[int, int]] = []  # pairs of a link and a move that slides in it
        self.chains = [slice(0, 0)]  # of each chain, its links; chain 0 is the world's
        self.last = [_NONE]  # of each chain, the last move that turns

    def add_chain(self, moves: list[tuple[int, bool]]) -> None:
        """Add a chain of moves, from the world to the body: the number of each move, and whether it turns."""
        first, last = len(self.moves), _NONE
        for move, turns in moves:
            if turns:
                self.moves.append(move)
                self.before.append(last)
                last = move
            else:
                self.sliding.append((len(self.moves), move))
        if not moves[-1][1]:
            self.moves.append(_NONE)
            self.before.append(_NONE)
        self.chains.append(slice(first, len(self.moves)))
        self.last.append(last)


@dataclass(frozen=True)
class _Kind:
    """All moves of one kind; the arrays have one row a move."""

    kind: Any  # a joint's type; None: mocap bodies
    numbers: Indices  # of the moves
    things: Indices  # the joints, or the mocap bodies
    dofs: Indices  # each joint's degree of freedom, or the three by which a ball or free joint turns


class Carriers:
    """The carriers: bodies that turn by a joint of their own, each with its chain of joints from the world to it.

    Carrier 0 is the world, which stays. Any other body is carried by the nearest body above it that turns: it is at
    rest or slides straight in that body's frame.

    Attributes
    ----------
    bodies : list of int
        The body of each carrier.
    of_body, is_moving, is_sliding : arrays, shape (nbody,)
        For each body of the model its carrier; whether it moves in the world; whether it slides in its carrier's frame.
    """

    def __init__(self, model: Any) -> None:
        self._model = model
        self._moves: dict[_Move, int] = {}
        self._links = _Links()
        self.bodies = [0]
        self.of_body: Indices = np.zeros(model.nbody, np.int32)
        self.is_moving = np.zeros(model.nbody, bool)
        self.is_sliding = np.zeros(model.nbody, bool)
        moves_to: list[list[_Move]] = [[]]
        for body in range(1, model.nbody):
            parent, own = int(model.body_parentid[body]), self._moves_of(body)
            moves_to.append(moves_to[parent] + own)
            self.of_body[body] = self.of_body[parent]
            self.is_moving[body] = bool(moves_to[body])
            if any(self._turns(move) for move in own):
                self.of_body[body] = len(self.bodies)
                self.bodies.append(body)
                self._links.add_chain([(self._number(move), self._turns(move)) for move in moves_to[body]])
            self.is_sliding[body] = len(moves_to[body]) > len(moves_to[self.bodies[self.of_body[body]]])
        kinds = [self._all_of(kind) for kind in (None, _HINGE, _SLIDE, _BALL, _FREE)]
        self._kinds = [kind for kind in kinds if len(kind.numbers)]

    def _moves_of(self, body: int) -> list[_Move]:
        if self._model.body_mocapid[body] >= 0:
            return [_Move(body, -1)]
        first, count = int(self._model.body_jntadr[body]), int(self._model.body_jntnum[body])
        return [_Move(body, joint) for joint in range(first, first + count)]

    def _kind(self, move: _Move) -> Any:
        return mujoco.mjtJoint(self._model.jnt_type[move.joint]) if move.joint >= 0 else None

    def _turns(self, move: _Move) -> bool:
        return bool(self._kind(move) != _SLIDE)

    def _number(self, move: _Move) -> int:
        return self._moves.setdefault(move, len(self._moves))

    def _all_of(self, kind: Any) -> _Kind:
        moves = [(number, move) for move, number in self._moves.items() if self._kind(move) == kind]
        things = np.array([move.body if kind is None else move.joint for _, move in moves], np.int32)
        if kind is None:
            dofs = np.empty((0, 1), np.int32)
        else:
            turning = {_BALL: (0, 1, 2), _FREE: (3, 4, 5)}.get(kind, (0,))
            dofs = self._model.jnt_dofadr[things][:, np.newaxis] + np.array(turning, np.int32)
        return _Kind(kind, np.array([number for number, _ in moves], np.int32), things, dofs)

    def chains(self, start: Any, end: Any) -> tuple[list[Doubles], Doubles] | None:
        """Return each carrier's links, and the origin of its frame: the anchor of its last joint that turns.

        `start` and `end` are `MjData` whose kinematics are computed. None: nothing turns between them.
        """
        if not self._kinds:
            return None
        anchors, turns, shifts = self._twists(start, end)
        if not turns.any():
            return None
        of = self._links
        links = np.zeros((len(of.moves), 4, 3))
        links[:, 0] = anchors[of.moves] - anchors[of.before]
        links[:, 2] = links[:, 0] + shifts[of.moves]
        for link, move in of.sliding:
            links[link, 2] += shifts[move]
        links[:, 3] = turns[of.moves]
        return [links[chain] for chain in of.chains], anchors[of.last]

    def _twists(self, start: Any, end: Any) -> Doubles:
        """Return each move's anchor, rotation vector and shift over the step, in the world's frame at the start."""
        change, out = np.empty(self._model.nv), np.zeros((3, len(self._moves) + 1, 3))
        mujoco.mj_differentiatePos(self._model, change, 1.0, start.qpos, end.qpos)
        anchors, turns, shifts = out
        for kind in self._kinds:
            numbers, things = kind.numbers, kind.things
            if kind.kind is None:
                self._told(start, end, kind, out)
                continue
            if kind.kind != _SLIDE:
                anchors[numbers] = start.xanchor[things]
            if kind.kind == _FREE:
                shifts[numbers] = change[kind.dofs - 3]
            if kind.kind in (_FREE, _BALL):
                turns[numbers] = _in_world(start, self._model.jnt_bodyid[things], change[kind.dofs])
            else:
                (turns if kind.kind == _HINGE else shifts)[numbers] = start.xaxis[things] * change[kind.dofs]
        return out

    def turned_too_far(self, velocity: Doubles, seconds: float) -> int | None:
        """Return a body whose free or ball joint turns by 0.99 half turns or more: two states do not show which way."""
        for kind in self._kinds:
            if kind.kind not in (_BALL, _FREE):
                continue
            far = np.flatnonzero(np.linalg.norm(velocity[kind.dofs], axis=1) * seconds > 0.99 * np.pi)
            if len(far):
                return int(self._model.jnt_bodyid[kind.things[far[0]]])
        return None

    def _told(self, start: Any, end: Any, kind: _Kind, out: Doubles) -> None:
        """Write the moves of mocap bodies to `out`: straight to the next pose, by the shorter turn at one speed."""
        numbers, bodies, (anchors, turns, shifts) = kind.numbers, kind.things, out
        anchors[numbers], shifts[numbers] = start.xpos[bodies], end.xpos[bodies] - start.xpos[bodies]
        local = np.zeros((len(bodies), 3))
        for row, mocap in zip(local, self._model.body_mocapid[bodies]):
            mujoco.mju_subQuat(row, end.mocap_quat[mocap], start.mocap_quat[mocap])
        turns[numbers] = _in_world(start, bodies, local)


def _in_world(start: Any, bodies: Indices, vectors: Doubles) -> Doubles:
    """Turn vectors from each body's frame at the start into the world's."""
    turned: Doubles = np.einsum("nij,nj->ni", start.xmat[bodies].reshape(-1, 3, 3), vectors)
    return turned
