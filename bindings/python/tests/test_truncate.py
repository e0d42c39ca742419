"""`truncate`: the positions at which a step may end."""

from __future__ import annotations

import numpy as np
import pytest

import tamis


def test_a_far_vertex_is_not_stopped_by_a_near_pair(falling: tamis.Scene) -> None:
    end = falling.end.copy()
    end[2, 1] = 1.25  # sideways: it meets nothing
    step = tamis.Detector(falling.mesh).truncate(falling.start, end)
    assert step.fractions.shape == (6,) and (step.fractions >= 0).all() and (step.fractions <= 1).all()
    assert step.fractions[2] > step.fractions[3]
    reached = falling.start + step.fractions[:, np.newaxis] * (end - falling.start)
    assert np.allclose(step.positions, reached, atol=1e-15)


@pytest.mark.parametrize("keep", [0.1, 0.5])
def test_every_pair_keeps_its_fraction(keep: float) -> None:
    scene = tamis.scene("folded-cloth", 400, seed=2)
    detector = tamis.Detector(scene.mesh)
    step = detector.truncate(scene.start, scene.end, keep)
    assert step.is_free and step.fractions.min() < 1
    before = detector.pairs_within(scene.start, 0.05)
    assert tamis.Detector(scene.mesh).safe_step(scene.start, step.positions, keep).toi_lower == 1
    after = tamis.distance_of(before.kind, before.vertices, step.positions)
    assert (after.distance >= keep * before.distance * (1 - 1e-9)).all()


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


def test_floats_are_proven_as_they_are_stored() -> None:
    scene = tamis.scene("folded-cloth", 400, seed=2)
    start = scene.start.astype(np.float32)
    detector = tamis.Detector(scene.mesh)
    step = detector.truncate(start, scene.end, stored="float32")
    kept = step.positions.astype(np.float32)
    assert np.array_equal(kept, step.positions) and 0 < step.fractions.min() < 1
    assert detector.is_free(start, kept)
    assert not np.array_equal(detector.truncate(start, scene.end).positions.astype(np.float32), step.positions)


def test_floats_start_at_floats(falling: tamis.Scene) -> None:
    start = falling.start.copy()
    start[3, 2] = 0.7
    detector = tamis.Detector(falling.mesh)
    with pytest.raises(tamis.InvalidStep, match=r"vertex 3 at the start .* 0\.7, which is no"):
        detector.truncate(start, falling.end, stored="float32")
    with pytest.raises(tamis.InvalidOptions, match="stored is 'float16': give 'float64' or 'float32'"):
        detector.truncate(start, falling.end, stored="float16")


def test_what_touches_at_the_start_stays_and_the_rest_moves(falling: tamis.Scene) -> None:
    start = falling.start.copy()
    start[3, 2] = 0
    step = tamis.Detector(falling.mesh).truncate(start, falling.end)
    assert not step.is_free
    assert np.array_equal(step.positions[3], start[3]) and step.fractions[3] == 0
    assert step.fractions[5] > 0


def test_answers_own_their_memory(falling: tamis.Scene) -> None:
    detector = tamis.Detector(falling.mesh)
    step = detector.truncate(falling.start, falling.end)
    before = step.fractions.copy(), step.positions.copy()
    detector.truncate(falling.start, falling.start)
    del detector
    assert np.array_equal(step.fractions, before[0]) and np.array_equal(step.positions, before[1])


@pytest.mark.parametrize("keep", [0.0, 1.0, -0.5, float("nan")])
def test_bad_fractions(falling: tamis.Scene, keep: float) -> None:
    detector = tamis.Detector(falling.mesh)
    with pytest.raises(tamis.InvalidOptions, match=r"keep is .*fraction"):
        detector.truncate(falling.start, falling.end, keep)
    with pytest.raises(tamis.InvalidStep):
        detector.truncate(falling.start[:5], falling.end)
    with pytest.raises(tamis.InvalidOptions):
        detector.truncate(falling.start, falling.end, min_separation=-1.0)
