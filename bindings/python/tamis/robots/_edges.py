"""Answers about edges, and the questions to the world that give them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles
from tamis._kinds import PairKind
from tamis._world._tables import BodyContact
from tamis._world._world import World


class Edges(NamedTuple):
    """Answers about n edges: how far each is free, and what touches first.

    `is_free` (n,): a proof. `fraction` (n,): the edge is free before this part of it; 1 if it is free, 0 if its start
    overlaps. `overlaps_at_start` (n,). `pairs`: for each edge the names of both bodies that touch, None if none does,
    or if the start overlaps. `points` (n, 3): where they touch, in the world's frame; else not a number.
    """

    is_free: npt.NDArray[np.bool_]
    fraction: Doubles
    overlaps_at_start: npt.NDArray[np.bool_]
    pairs: list[tuple[str, str] | None]
    points: Doubles

    def __repr__(self) -> str:
        return f"Edges({len(self.is_free)} edges, {int(self.is_free.sum())} of them free)"


class TrajectoryAnswer(NamedTuple):
    """The first edge of a trajectory that is not free: its number, how far it is free, what touches there and where."""

    is_free: bool
    edge: int | None
    fraction: float
    pair: tuple[str, str] | None
    point: Doubles | None


def overlaps(world: World, bodies: list[int], chain: Doubles, separation: float) -> bool:
    """Return whether anything overlaps, or is within the separation, when bodies begin their motions."""
    world.move_many(bodies, chain)
    return world.has_overlap() or (separation > 0 and len(world.pairs_within(separation)) > 0)


def ask_edges(world: World, bodies: list[int], chains: Doubles, names: dict[int, str], starts_are_valid: bool) -> Edges:
    """Return the answers about motions, shape (n, b, links, 4, 3)."""
    found = world.earliest_many(bodies, chains)
    fraction, is_free = found.toi_lower.copy(), found.is_free.copy()
    inside = np.zeros(len(chains), bool)
    pairs: list[tuple[str, str] | None] = [None] * len(chains)
    points = np.full((len(chains), 3), np.nan)
    if not starts_are_valid:
        for i, chain in enumerate(chains):
            inside[i] = overlaps(world, bodies, chain, 0.0)
    for edge, contact in zip(found.touching.tolist(), found.contacts):
        if not inside[edge]:
            pairs[edge] = (names[contact.bodies[0]], names[contact.bodies[1]])
            points[edge] = _place(world, bodies, chains[edge], contact)
    fraction[inside], is_free[inside] = 0.0, False
    return Edges(is_free, fraction, inside, pairs, points)


def _place(world: World, bodies: list[int], chain: Doubles, contact: BodyContact) -> Doubles:
    """Return where the first body of a contact touches, in the world's frame."""
    world.move_many(bodies, chain)
    points = world.points_at(contact.bodies[0], contact.toi_lower)[0]
    a: Doubles = points[contact.vertices[0]]
    if contact.kind != PairKind.EDGE_EDGE:
        return a
    between: Doubles = a + contact.u * (points[contact.vertices[1]] - a)
    return between
