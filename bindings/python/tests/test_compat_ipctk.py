"""Scripts written for ipctk, with one import changed. The expected values come from ipctk 1.6.1 itself."""

from __future__ import annotations

import math
import os
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import tamis
import tamis.compat.ipctk as ipctk


@pytest.fixture
def mesh(falling: tamis.Scene) -> ipctk.CollisionMesh:
    faces = falling.mesh.faces
    return ipctk.CollisionMesh(falling.start, ipctk.edges(faces), faces)


def test_steps(mesh: ipctk.CollisionMesh, falling: tamis.Scene) -> None:
    assert not ipctk.is_step_collision_free(mesh, falling.start, falling.end)
    assert ipctk.is_step_collision_free(mesh, falling.start, falling.start, 0.0, ipctk.LBVH(), ipctk.AdditiveCCD())
    step = ipctk.compute_collision_free_stepsize(mesh, falling.start, falling.end, min_distance=0.0)
    assert step == pytest.approx(0.49994993209838867, abs=1e-6)
    additive = ipctk.AdditiveCCD()
    kept = ipctk.compute_collision_free_stepsize(mesh, falling.start, falling.end, narrow_phase_ccd=additive)
    assert kept == pytest.approx(0.45, abs=1e-6)
    assert ipctk.compute_collision_free_stepsize(mesh, falling.start, falling.start) == 1
    with pytest.raises(tamis.InvalidOptions):
        wrong = ipctk.AdditiveCCD(conservative_rescaling=0)
        ipctk.compute_collision_free_stepsize(mesh, falling.start, falling.end, narrow_phase_ccd=wrong)


def test_minimum_distance(mesh: ipctk.CollisionMesh, falling: tamis.Scene) -> None:
    assert not ipctk.is_step_collision_free(mesh, falling.start, falling.start, 1.0)
    assert ipctk.is_step_collision_free(mesh, falling.start, falling.start, 0.5)
    step = ipctk.compute_collision_free_stepsize(mesh, falling.start, falling.end, 0.5)
    assert step == pytest.approx(0.25, abs=1e-4) and step < 0.25


def test_candidates_that_are_none(mesh: ipctk.CollisionMesh, falling: tamis.Scene) -> None:
    candidates = ipctk.Candidates()
    candidates.build(mesh, falling.start, falling.end, inflation_radius=0.1, broad_phase=ipctk.HashGrid())
    assert not candidates.is_step_collision_free(mesh, falling.start, falling.end)
    assert candidates.compute_collision_free_stepsize(mesh, falling.start, falling.end) < 0.5


def test_vertices_that_may_not_collide(mesh: ipctk.CollisionMesh, falling: tamis.Scene) -> None:
    mesh.can_collide = lambda a, b: not {a, b} <= {0, 1, 2, 3}
    assert ipctk.is_step_collision_free(mesh, falling.start, falling.end)
    mesh.can_collide = lambda a, b: {a, b} == {3, 1}
    assert not ipctk.is_step_collision_free(mesh, falling.start, falling.end)


# Bug: an ipctk.CollisionMesh, which is not supported here, raised an AttributeError about a private attribute.
@pytest.mark.parametrize("wrong", [tamis.Mesh([[0, 1, 2]]), None])
def test_meshes_of_another_kind(wrong: Any) -> None:
    positions, candidates = np.zeros((3, 3)), ipctk.Candidates()
    calls: list[Callable[[], object]] = [
        lambda: ipctk.has_intersections(wrong, positions),
        lambda: ipctk.is_step_collision_free(wrong, positions, positions),
        lambda: ipctk.compute_collision_free_stepsize(wrong, positions, positions),
        lambda: candidates.is_step_collision_free(wrong, positions, positions),
        lambda: candidates.compute_collision_free_stepsize(wrong, positions, positions),
    ]
    for call in calls:
        with pytest.raises(tamis.InvalidMesh, match=rf"{type(wrong).__name__}: give a .*ipctk\.CollisionMesh"):
            call()


def test_single_pairs() -> None:
    a, b, c = [0, 0, 0], [1, 0, 0], [0, 1, 0]
    p0, p1 = np.array([0.2, 0.2, 1.0]), np.array([0.2, 0.2, -3.0])
    ccd = ipctk.TightInclusionCCD(1e-6).point_triangle_ccd
    touches, toi = ccd(p0, a, b, c, p1, a, b, c)
    assert touches and toi == pytest.approx(0.25 * (1 - 1e-4), abs=1e-9) and toi < 0.25
    assert ccd(p0, a, b, c, p1, a, b, c, tmax=0.2) == (False, math.inf)
    assert ccd(p0, a, b, c, p0, a, b, c) == (False, math.inf)
    assert ccd(p0, a, b, c, p1, a, b, c, min_distance=0.5)[1] == pytest.approx(0.125, abs=1e-4)
    column = p0[:, np.newaxis]  # ipctk takes columns as well
    assert ccd(column, a, b, c, p1, a, b, c)[0]

    narrow = ipctk.AdditiveCCD()
    c, d, below_c, below_d = [-1, 0, 1], [1, 0, 1], [-1, 0, -1], [1, 0, -1]
    a, b = [0, -1, 0], [0, 1, 0]
    for touches, toi in (
        narrow.edge_edge_ccd(c, d, a, b, below_c, below_d, a, b),
        narrow.point_edge_ccd([0, 0, 1], a, b, [0, 0, -1], a, b),
        narrow.point_point_ccd([0, 0, 1], [0, 0, 0], [0, 0, -1], [0, 0, 0]),
    ):
        assert touches and toi == pytest.approx(0.45)


@pytest.mark.parametrize(("rescaling", "expected"), [(1.0, 0.5), (0.9, 0.45), (0.5, 0.25), (0.1, 0.05)])
def test_single_pairs_keep_what_the_rescaling_says(rescaling: float, expected: float) -> None:
    """Bug: `conservative_rescaling` had no effect on single pairs."""
    narrow = ipctk.AdditiveCCD(conservative_rescaling=rescaling)
    touches, toi = narrow.point_point_ccd([0, 0, 1], [0, 0, 0], [0, 0, -1], [0, 0, 0])
    assert touches and toi == pytest.approx(expected)
    assert narrow.point_point_ccd([0, 0, 1], [0, 0, 0], [0, 0, -1], [0, 0, 0], tmax=0.9 * expected) == (False, math.inf)
    step = narrow.point_point_ccd([0, 0, 1], [0, 0, 0], [0, 0, -1], [0, 0, 0], min_distance=0.2)
    assert step[1] == pytest.approx(0.4 * rescaling)


def test_threads(mesh: ipctk.CollisionMesh, falling: tamis.Scene) -> None:
    everything = os.cpu_count() or 1
    try:
        for given, used in ((1, 1), (0, everything), (10**6, everything)):
            ipctk.set_num_threads(given)
            assert ipctk.get_num_threads() == used
            assert not ipctk.is_step_collision_free(mesh, falling.start, falling.end)
            assert mesh.detector.statistics.threads <= used
        with pytest.raises(tamis.InvalidOptions, match="nthreads"):
            ipctk.set_num_threads(-1)
        kept = mesh.detector
        ipctk.set_num_threads(1)
        assert (mesh.detector is kept) == (everything == 1)
    finally:
        ipctk.set_num_threads(0)


@pytest.mark.parametrize("name", ["NormalCollisions", "BarrierPotential", "TangentialCollisions", "point_triangle_ccd"])
def test_what_is_not_here_says_where_it_is(name: str) -> None:
    with pytest.raises(AttributeError, match=f"no {name}: if ipctk has it, import ipctk"):
        getattr(ipctk, name)
    assert not hasattr(ipctk, name)


def test_counts(mesh: ipctk.CollisionMesh) -> None:
    assert (mesh.num_vertices, mesh.num_edges, mesh.num_faces) == (6, 6, 2)
    assert ipctk.edges([[0, 1, 2]]).tolist() == [[0, 1], [0, 2], [1, 2]]
    with pytest.raises(tamis.InvalidMesh):
        ipctk.CollisionMesh(np.zeros((3, 2)), None, [[0, 1, 2]])


def test_points_of_no_edge_and_no_face(falling: tamis.Scene) -> None:
    """Bug: loose points passed through everything."""
    faces = falling.mesh.faces[:1]
    mesh = ipctk.CollisionMesh(falling.start[:4], ipctk.edges(faces), faces)
    step = falling.start[:4], falling.end[:4]
    assert mesh.codim_vertices.tolist() == [3] and mesh.num_codim_vertices == 1
    assert not ipctk.is_step_collision_free(mesh, *step)
    assert ipctk.compute_collision_free_stepsize(mesh, *step) == pytest.approx(0.49994993209838867, abs=1e-6)
    assert not ipctk.is_step_collision_free(ipctk.CollisionMesh(np.eye(3)), np.eye(3), -np.eye(3), 0.1)


def test_intersections_that_do_not_count(mesh: ipctk.CollisionMesh, falling: tamis.Scene) -> None:
    """Bug: `can_collide` was not asked about intersections, as ipctk does."""
    assert ipctk.has_intersections(mesh, falling.end)
    mesh.can_collide = lambda a, b: {a, b} == {3, 1}
    assert ipctk.has_intersections(mesh, falling.end)
    mesh.can_collide = lambda a, b: False
    assert not ipctk.has_intersections(mesh, falling.end)
