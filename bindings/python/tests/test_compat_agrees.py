"""Random meshes of all kinds of features, through ipctk itself and through `tamis.compat.ipctk`: the answers agree.

Each library stops a little before a contact, by its own rule. So a mesh counts as decided where no pair comes into the
margin between touching and what ipctk calls near; then both must say the same. Elsewhere ipctk must be the careful one.

TAMIS_IPCTK_MESHES=1000 runs more of them than every day.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

import tamis
import tamis.compat.ipctk as compat

ipctk: Any = pytest.importorskip("ipctk", reason="ipctk has no wheel for this Python", exc_type=ImportError)

MESHES = int(os.environ.get("TAMIS_IPCTK_MESHES", "200"))
Numbers = npt.NDArray[np.float64]
Integers = npt.NDArray[np.int32]


@dataclass
class Case:
    """A mesh, a step, a separation, and which vertices may collide."""

    start: Numbers
    end: Numbers
    edges: Integers
    faces: Integers
    separation: float
    may: npt.NDArray[np.bool_] | None

    def made_by(self, library: Any) -> Any:
        parts = [part for part in (self.edges, self.faces) if len(self.edges)]  # ipctk wants the edges of the faces
        mesh = library.CollisionMesh(self.start, *parts)
        if self.may is not None:
            may = self.may
            mesh.can_collide = lambda a, b: bool(may[a, b])
        return mesh


def _features(random: np.random.Generator, used: Integers, count: int, corners: int) -> Integers:
    rows = [random.choice(used, corners, replace=False) for _ in range(count if len(used) >= corners else 0)]
    return np.array(rows, np.int32).reshape(-1, corners)


def _loose_points(case: Case) -> Integers:
    return np.setdiff1d(np.arange(len(case.start), dtype=np.int32), case.edges)


def _filter(random: np.random.Generator, case: Case) -> None:
    """Choose which vertices may collide, and join all loose points: ipctk 1.6.1 asks about these by wrong numbers."""
    ends = [[point, (point + 1) % len(case.start)] for point in _loose_points(case)]
    case.edges = np.concatenate([case.edges, np.array(ends, np.int32).reshape(-1, 2)])
    case.may = random.random((len(case.start), len(case.start))) < 0.3
    case.may |= case.may.T


def _aim_a_point(random: np.random.Generator, case: Case) -> None:
    """Let a loose point pass exactly through the middle of an edge at rest, or a point: coordinates have few bits."""
    if len(_loose_points(case)) < 2:
        return
    point, other = random.choice(_loose_points(case), 2, replace=False)
    a, b = case.edges[random.integers(len(case.edges))] if len(case.edges) and random.random() < 0.7 else (other, other)
    grid = 1024
    for end in (a, b):
        case.start[end] = np.round(case.start[end] * grid) / grid
        case.end[end] = case.start[end]
    move = np.round(0.2 * random.standard_normal(3) * grid) / grid
    case.start[point] = (case.start[a] + case.start[b]) / 2 - move
    case.end[point] = (case.start[a] + case.start[b]) / 2 + move


def _case(seed: int) -> Case:
    random = np.random.default_rng(seed)
    n = int(random.integers(4, 36))
    used = random.permutation(n)[: random.integers(2, n + 1)].astype(np.int32)
    faces = _features(random, used, int(random.integers(1, 9) * (random.random() < 0.75)), 3)
    edges = _features(random, used, int(random.integers(1, 9) * (random.random() < 0.65)), 2)
    if len(faces):
        edges = np.concatenate([ipctk.edges(faces), edges])
    start = random.random((n, 3))
    end = start + random.choice([0.02, 0.1, 0.4]) * random.standard_normal((n, 3))
    separation = float(random.choice([0.0, 0.0, 0.01, 0.03]))
    case = Case(start, end, random.permutation(edges), faces, separation, None)
    if random.random() < 0.3:
        _aim_a_point(random, case)
    elif random.random() < 0.3:
        _filter(random, case)
    return case


class Comparison:
    """One mesh in both libraries."""

    def __init__(self, case: Case) -> None:
        self.case, self.ours, self.theirs = case, case.made_by(compat), case.made_by(ipctk)
        self.step = case.start, case.end, case.separation
        ask = self.ours.detector.earliest
        self.touch = ask(case.start, case.end, min_separation=case.separation)
        # TightInclusionCCD stops pairs when their largest coordinate difference is 1e-4, with an error of 1e-6.
        self.margin = ask(case.start, case.end, min_separation=3**0.5 * 1.1e-4).toi_lower
        if case.separation:
            self.margin = compat.compute_collision_free_stepsize(self.ours, *self.step, None, self.narrow_of(compat))
        self.is_decided = (self.touch.contact is None) == (self.margin == 1)

    def narrow_of(self, library: Any) -> Any:
        """Return a narrow phase; with a separation the one that measures Euclidean distance."""
        return (
            library.AdditiveCCD(conservative_rescaling=0.999) if self.case.separation else library.TightInclusionCCD()
        )

    def answers(self, name: str) -> list[tuple[Any, Any]]:
        """Return our and their answers to a question about the step, by the function and by Candidates' method."""
        both: tuple[list[Any], list[Any]] = [], []
        for answers, library, mesh in ((both[0], compat, self.ours), (both[1], ipctk, self.theirs)):
            answers.append(getattr(library, name)(mesh, *self.step, library.BruteForce(), self.narrow_of(library)))
            candidates = library.Candidates()
            candidates.build(mesh, self.case.start, self.case.end, self.case.separation)
            answers.append(getattr(candidates, name)(mesh, *self.step, self.narrow_of(library)))
        return list(zip(*both))

    def expect_alike(self) -> None:
        for ours, theirs in self.answers("is_step_collision_free"):
            assert ours == (self.touch.contact is None)
            assert theirs == ours if self.is_decided else ours
        for ours, theirs in self.answers("compute_collision_free_stepsize"):
            # If ipctk's step is shorter than 1e-6, it takes 0.8 of it.
            assert 0.8 * (self.margin - 2e-6) <= min(ours, theirs) and max(ours, theirs) <= self.touch.toi_upper
            assert not self.is_decided or (ours == 1) == (theirs == 1)
        for positions in (self.case.start, self.case.end):
            assert ipctk.has_intersections(self.theirs, positions) == compat.has_intersections(self.ours, positions)


def test_random_meshes() -> None:
    """Bug: loose points took no part in contacts."""
    ipctk.set_logger_level(ipctk.LoggerLevel.off)
    ipctk.set_num_threads(1)  # with more threads it waits for ever for a can_collide in Python
    kinds: list[str] = []
    undecided = free = 0
    for seed in range(MESHES):
        compared = Comparison(_case(seed))
        try:
            compared.expect_alike()
        except AssertionError as failure:
            raise AssertionError(f"mesh {seed}: {compared.case}") from failure
        undecided += not compared.is_decided
        free += compared.touch.contact is None
        if compared.touch.contact is not None:
            kinds.append(compared.touch.contact.kind.short_name)
    counts = {kind.short_name: kinds.count(kind.short_name) for kind in tamis.PairKind}
    print(f"{MESHES} meshes: {free} free, {undecided} within the margin, first contacts {counts}")
    assert undecided < 0.1 * MESHES and 0.2 * MESHES < free < 0.6 * MESHES and min(counts.values()) > 0.01 * MESHES


def test_edges_come_in_the_same_order() -> None:
    """Bug: data of ipctk's edges was used for other edges."""
    for name in ("folded-cloth", "tangle", "fans"):
        faces = tamis.scene(name, 300).mesh.faces
        assert np.array_equal(compat.edges(faces), ipctk.edges(faces)), name
