"""Tamis inside Newton's VBD solver: no step has a contact, no pair is dropped, and other solvers are refused."""

from __future__ import annotations

import os
import pathlib
import subprocess
import sys
from typing import Any

import numpy as np
import pytest

import tamis

newton = pytest.importorskip("newton", reason="newton is not installed: bindings/python/requirements-hosts.txt")
wp = pytest.importorskip("warp")

import tamis.newton  # noqa: E402

wp.config.enable_backward = False  # No test differentiates: kernels compile in half the time.
ROOT = pathlib.Path(__file__).resolve().parents[4]
pytestmark = pytest.mark.filterwarnings("default")
MARGIN, GAP = 0.02, 0.01


def falling_cloths(layers: int = 3, floor: Any = None) -> Any:
    """Return sheets above each other, a little more than the margin apart, each faster than the one below.

    `floor`: the corners of triangles under them, which are inactive and the last particles of the model.
    """
    builder = newton.ModelBuilder(gravity=(0.0, 0.0, -10.0))
    for layer in range(layers):
        builder.add_cloth_grid(
            pos=wp.vec3(0.003 * layer, 0.001 * layer, 0.035 * layer),
            rot=wp.quat_identity(),
            vel=wp.vec3(0.0, 0.0, -6.0 * layer),
            dim_x=8,
            dim_y=8,
            cell_x=0.05,
            cell_y=0.05,
            mass=0.01,
            fix_left=layer == 0,
            fix_right=layer == 0,
            tri_ke=1e3,
            tri_ka=1e3,
            edge_ke=1.0,
        )
    if floor is not None:
        place = {"pos": wp.vec3(), "rot": wp.quat_identity(), "vel": wp.vec3(), "scale": 1.0, "density": 0.1}
        builder.add_cloth_mesh(**place, vertices=floor.tolist(), indices=list(range(len(floor))))
    builder.color(include_bending=True)
    model = builder.finalize(device="cpu")
    if floor is not None:
        flags = model.particle_flags.numpy()
        flags[-len(floor) :] &= ~newton.ParticleFlags.ACTIVE
        model.particle_flags.assign(flags)
    model.soft_contact_ke = 1e3
    return model


def solver_of(model: Any, **options: Any) -> Any:
    given = {"particle_self_contact_margin": MARGIN, "particle_self_contact_gap": GAP, **options}
    return newton.solvers.SolverVBD(model, iterations=4, particle_enable_self_contact=True, **given)


def run(solver: Any, steps: int) -> list[tuple[Any, Any]]:
    """Return the positions at the start and at the end of each step."""
    state, following, ways = solver.model.state(), solver.model.state(), []
    for _ in range(steps):
        start = state.particle_q.numpy().copy()
        solver.step(state, following, None, None, 1 / 600)
        ways.append((start, following.particle_q.numpy().copy()))
        state, following = following, state
    return ways


def contacts_of(model: Any, ways: list[tuple[Any, Any]]) -> int:
    mesh = tamis.Mesh(model.tri_indices.numpy().reshape(-1, 3), vertex_count=model.particle_count)
    return sum(len(tamis.Detector(mesh).contacts(start, end)) for start, end in ways)


# Bug: pairs for which Newton's buffers have no room are dropped, and pass through each other.
def test_no_step_touches_however_small_the_buffers_are() -> None:
    model = falling_cloths()
    small = {"particle_vertex_contact_buffer_size": 1, "particle_edge_contact_buffer_size": 1}
    own = run(solver_of(model, **small), 40)
    assert contacts_of(model, own) > 0
    solver = solver_of(model, **small)
    attachment = tamis.newton.attach(solver)
    ways = run(solver, 40)
    assert contacts_of(model, ways) == 0
    assert attachment.report.steps == 40 and attachment.report.shortened > 0
    assert attachment.report.moved_into_contact == 0
    moved = np.abs(ways[-1][1] - ways[0][0]).max(0)
    assert moved[2] > 0.02 and np.isfinite(ways[-1][1]).all()


def lists_of(solver: Any) -> tuple[set[tuple[int, int]], set[tuple[int, int]]]:
    """Return all pairs from which contact forces are summed."""
    info = solver.trimesh_collision_info
    found = []
    for name in ("vertex_colliding_triangles", "edge_colliding_edges"):
        pairs, offsets, counts = (getattr(info, name + suffix).numpy() for suffix in ("", "_offsets", "_count"))
        rows = pairs.reshape(-1, 2)
        assert (counts <= getattr(info, name + "_buffer_sizes").numpy()).all()
        found.append({tuple(row) for o, c in zip(offsets, counts) for row in rows[o : o + c].tolist()})
    return found[0], found[1]


# Bug: lists that differ from Newton's own with enough room: with neighbours, or edges in one direction only.
@pytest.mark.parametrize("rest_radius", [0.0, 0.036])
def test_forces_see_the_pairs_that_newton_would_see(rest_radius: float) -> None:
    model = falling_cloths()
    wide = {"particle_vertex_contact_buffer_size": 200, "particle_edge_contact_buffer_size": 400}
    options = {**wide, "particle_rest_shape_contact_exclusion_radius": rest_radius}
    own, with_tamis = solver_of(model, **options), solver_of(model, **options)
    state = model.state()
    squeezed = state.particle_q.numpy() * np.array([1, 1, 0.6], np.float32)
    state.particle_q.assign(squeezed)
    own._collision_detection_penetration_free(state)
    tamis.newton.attach(with_tamis)
    with_tamis._collision_detection_penetration_free(state)
    assert lists_of(with_tamis) == lists_of(own)
    assert rest_radius > 0 or min(len(pairs) for pairs in lists_of(own)) > 100


def test_pairs_of_one_ring_are_a_choice() -> None:
    model = falling_cloths(1)
    start = model.state().particle_q.numpy()
    end = start.copy()
    # Over the next square, whose triangles an edge joins to vertex 0.
    end[0] = start[20] + np.array([0, 0, 0.01], np.float32)
    end[0, 2] = -0.1
    crossing = start.copy()
    crossing[0] = start[11] * np.float32(0.5) + start[12] * np.float32(0.5) + np.array([0.01, 0.01, 0.05], np.float32)
    with_ring = tamis.newton.attach(solver_of(model)).detector.contacts(crossing, end)
    without = tamis.newton.attach(solver_of(model), one_ring=False).detector.contacts(crossing, end)
    assert 0 < len(without) < len(with_ring)


def test_says_when_the_caller_moves_vertices_through_others() -> None:
    model = falling_cloths(2)
    solver = solver_of(model)
    attachment = tamis.newton.attach(solver)
    state, following = model.state(), model.state()
    solver.step(state, following, None, None, 1 / 600)
    moved = following.particle_q.numpy().copy()
    moved[81:, 2] -= 1  # the upper cloth
    following.particle_q.assign(moved)
    with pytest.warns(UserWarning, match="moved through them from outside"):
        solver.step(following, state, None, None, 1 / 600)
    assert attachment.report.moved_into_contact == 1


# Bug: the triangles of such a floor touch each other at the start of every step.
@pytest.mark.filterwarnings("error")
def test_what_no_step_moves_meets_all_but_itself() -> None:
    corner, x, y = np.array([-0.1, -0.1, -0.005]), np.array([0.6, 0, 0]), np.array([0, 0.6, 0])
    floor = corner + np.array([0 * x, x, y, x, x + y, y])  # two triangles whose corners coincide
    model = falling_cloths(floor=floor)
    solver = solver_of(model)
    attachment = tamis.newton.attach(solver)
    ways = run(solver, 60)
    moved = [(start != end).any(axis=1) for start, end in ways]
    mesh = tamis.Mesh(model.tri_indices.numpy().reshape(-1, 3), vertex_count=model.particle_count)
    touching = [tamis.Detector(mesh).contacts(*way).vertices for way in ways]
    assert all(len(pairs) > 0 for pairs in touching)  # pairs of the floor with itself
    assert not any(moves[pairs].any() for moves, pairs in zip(moved, touching))
    heights = ways[-1][1][:-6, 2]
    assert heights.min() > -0.005 and attachment.report.shortened > 0
    flags = model.particle_flags.numpy()
    flags[-6:] |= newton.ParticleFlags.ACTIVE
    model.particle_flags.assign(flags)
    with pytest.raises(tamis.InvalidOptions, match="inactive or without mass when attached move now: attach again"):
        run(solver, 1)


def test_gives_the_solver_back() -> None:
    solver = solver_of(falling_cloths(1))
    before = solver._penetration_free_truncation
    attachment = tamis.newton.attach(solver)
    with pytest.raises(tamis.InvalidOptions, match="has an attachment: detach"):
        tamis.newton.attach(solver)
    attachment.detach()
    assert solver._penetration_free_truncation == before
    tamis.newton.attach(solver)


def test_refuses_what_it_does_not_know() -> None:
    model = falling_cloths(1)
    with pytest.raises(tamis.InvalidOptions, match=r"of the type dict: give a newton.solvers.SolverVBD"):
        tamis.newton.attach({})
    plain = newton.solvers.SolverVBD(model, iterations=1)
    with pytest.raises(tamis.InvalidOptions, match="no self-contact: make it with particle_enable_self_contact"):
        tamis.newton.attach(plain)
    with pytest.raises(tamis.InvalidOptions, match="keep"):
        tamis.newton.attach(solver_of(model), keep=1.5)


@pytest.mark.skipif("TAMIS_LONG" not in os.environ, reason="compiles its kernels for 20 s: for the night, TAMIS_LONG")
def test_a_recording_of_its_viewer_can_be_audited(tmp_path: pathlib.Path) -> None:
    model, file = falling_cloths(layers=2), tmp_path / "sheets.usda"
    viewer = newton.viewer.ViewerUSD(str(file), num_frames=3)
    viewer.set_model(model)
    state = model.state()
    for frame, fallen in enumerate((0, 0.02, 0.05)):
        positions = model.particle_q.numpy()
        positions[len(positions) // 2 :, 2] -= fallen
        state.particle_q.assign(positions)
        viewer.begin_frame(frame / 60)
        viewer.log_state(state)
        viewer.end_frame()
    viewer.close()
    report = tamis.audit(file)
    assert report.frames.names == ["0", "1", "2"] and not report.problems
    assert [frame.frame for frame in report.frames if frame.contacts] == [2]


def test_tamis_itself_needs_no_newton() -> None:
    code = "import tamis, tamis.newton, sys; assert not {'newton', 'warp'} & set(sys.modules)"
    subprocess.run([sys.executable, "-c", code], check=True)


@pytest.mark.skipif("TAMIS_NEWTON_FRAMES" not in os.environ, reason="minutes each: TAMIS_NEWTON_FRAMES=650")
@pytest.mark.parametrize("example", ["twist", "hanging", "poker_cards", "rollers"])
def test_examples_touch_nowhere(example: str) -> None:
    frames = os.environ["TAMIS_NEWTON_FRAMES"]
    script = ROOT / "benchmarks/python/newton_example.py"
    subprocess.run([sys.executable, script, example, "--frames", frames, "--attach"], check=True)
