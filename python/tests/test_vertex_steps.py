"""Every vertex its own step: how far each may go, and to which positions."""

from __future__ import annotations

import numpy as np
import pytest

import tamis


def test_a_far_vertex_is_not_stopped_by_a_near_pair(falling: tamis.Scene) -> None:
    end = falling.end.copy()
    end[2, 1] = 1.25  # sideways: it meets nothing
    detector = tamis.Detector(falling.mesh)
    steps = detector.vertex_steps(falling.start, end)
    assert steps.together == detector.keep_distance(falling.start, end, 0.1).lower < 0.5
    assert steps.until.shape == (6,) and (steps.until >= steps.together).all() and (steps.until <= 1).all()
    assert steps.until[2] > steps.together


def test_any_combination_of_steps_is_free() -> None:
    scene = tamis.scene("soup", 60, seed=2)
    start = scene.start
    detector = tamis.Detector(scene.mesh)
    if detector.has_intersection(start):
        start = scene.start * 4  # the same triangles, farther apart
    steps = detector.vertex_steps(start, scene.end)
    together = start + steps.together * (scene.end - start)
    random = np.random.default_rng(1)
    for _ in range(20):
        share = steps.together + random.random(len(start)) * (steps.until - steps.together)
        assert detector.is_free(together, start + share[:, np.newaxis] * (scene.end - start))


def test_truncated_positions_are_proven_free(falling: tamis.Scene) -> None:
    detector = tamis.Detector(falling.mesh)
    step = detector.truncate(falling.start, falling.end)
    assert step.is_free and step.positions.shape == (6, 3)
    assert detector.is_free(falling.start, step.positions)
    assert not detector.is_free(falling.start, falling.end)
    farther = detector.truncate(falling.start, falling.end, 0.01).positions
    assert 0 < farther[3, 2] < step.positions[3, 2] < falling.start[3, 2]
    kept = detector.truncate(falling.start, falling.end, min_separation=0.5).positions
    assert kept[3, 2] > 0.5


def test_what_touches_at_the_start_stays(falling: tamis.Scene) -> None:
    start = falling.start.copy()
    start[3, 2] = 0
    step = tamis.Detector(falling.mesh).truncate(start, falling.end)
    assert not step.is_free and np.array_equal(step.positions, start)


def test_answers_own_their_memory(falling: tamis.Scene) -> None:
    detector = tamis.Detector(falling.mesh)
    until, positions = (
        detector.vertex_steps(falling.start, falling.end).until,
        detector.truncate(falling.start, falling.end),
    )
    before = until.copy(), positions.positions.copy()
    detector.truncate(falling.start, falling.start)
    detector.vertex_steps(falling.start, falling.start)
    del detector
    assert np.array_equal(until, before[0]) and np.array_equal(positions.positions, before[1])


@pytest.mark.parametrize("fraction", [0.0, 1.0, -0.5, float("nan")])
def test_bad_fractions(falling: tamis.Scene, fraction: float) -> None:
    detector = tamis.Detector(falling.mesh)
    for ask in (detector.vertex_steps, detector.truncate):
        with pytest.raises(tamis.InvalidOptions, match="fraction"):
            ask(falling.start, falling.end, fraction)
        with pytest.raises(tamis.InvalidStep):
            ask(falling.start[:5], falling.end)
        with pytest.raises(tamis.InvalidOptions):
            ask(falling.start, falling.end, min_separation=-1.0)
