"""Single pairs, many at once, against the oracle."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

import oracle
import tamis

COORDINATES = st.one_of(
    st.integers(-4, 4).map(float),
    st.floats(-2, 2, width=16),
    st.integers(-64, 64).map(lambda i: i * 2**-20),
)
PAIRS = arrays(np.float64, (4, 3), elements=COORDINATES)


@pytest.mark.parametrize("kind", [tamis.PairKind.VERTEX_FACE, tamis.PairKind.EDGE_EDGE])
def test_decided_as_the_oracle_does(kind: tamis.PairKind) -> None:
    @settings(max_examples=80)
    @given(PAIRS, PAIRS)
    def check(start: np.ndarray, end: np.ndarray) -> None:
        try:
            expected = oracle.first_contact(kind, start.tolist(), end.tolist())
        except oracle.Degenerate:
            assume(False)
        found = tamis.narrow_phase(kind, [0, 1, 2, 3], start, end)
        assert len(found) == 1
        assert bool(found.touches[0]) == (expected is not None)
        if expected is not None:
            assert found.certified[0]
            assert found.toi_lower[0] <= expected.upper and expected.lower <= found.toi_upper[0]

    check()


def test_each_pair_by_itself() -> None:
    """Would catch rows that are mixed up where kinds follow each other in any order."""
    random = np.random.default_rng(5)
    start, end = random.uniform(-1, 1, (2, 100, 3))
    kinds, vertices = random.integers(0, 4, 800), random.permuted(np.tile(np.arange(100), (800, 1)), axis=1)[:, :4]
    together = tamis.narrow_phase(kinds, vertices, start, end, min_separation=0.01)
    assert 50 < together.touches.sum() < 750 and np.array_equal(together.kind, kinds)
    for i, row in enumerate(together):
        alone = tamis.narrow_phase(kinds[i], vertices[i], start, end, min_separation=0.01)
        assert alone[0] == row == together[i] and alone.table == together.table[i : i + 1]
        assert row.vertices == tuple(vertices[i]) and row.kind == kinds[i]


def test_points_against_segments_and_points() -> None:
    start = np.array([[0, 0, 1.0], [-1, 0, 0], [1, 0, 0]])
    end = start * [[1, 1, -1], [1, 1, 1], [1, 1, 1]]
    found = tamis.narrow_phase(tamis.PairKind.VERTEX_EDGE, [0, 1, 2, -1], start, end)
    assert found.touches[0] and found.toi_lower[0] <= 0.5 <= found.toi_upper[0] and found.u[0] == pytest.approx(0.5)
    kind, both = tamis.PairKind.VERTEX_VERTEX, [0, 1, -1, -1]
    assert not tamis.narrow_phase(kind, both, start, end).touches[0]
    met = tamis.narrow_phase(kind, both, start * [0, 0, 1], end * [0, 0, 3])
    assert met.touches[0] and met.toi_lower[0] <= 0.25 <= met.toi_upper[0]


def test_separation() -> None:
    start = np.array([[0.2, 0.2, 1.5], [0, 0, 0], [1, 0, 0], [0, 1, 0]])
    pair = tamis.PairKind.VERTEX_FACE, [0, 1, 2, 3], start, start - [[0, 0, 1], [0, 0, 0], [0, 0, 0], [0, 0, 0]]
    assert not tamis.narrow_phase(*pair).touches[0]
    near = tamis.narrow_phase(*pair, min_separation=1.0)
    assert near.touches[0] and near.toi_lower[0] <= 0.5 <= near.toi_upper[0]
    with pytest.raises(tamis.InvalidOptions):
        tamis.narrow_phase(*pair, min_separation=-1)


def test_none_at_all() -> None:
    none = tamis.narrow_phase(tamis.PairKind.EDGE_EDGE, [], np.eye(3), np.eye(3))
    assert len(none) == 0 and repr(none) == "Pairs(0 pairs, 0 touch)" and list(none) == []


def test_bad_pairs_are_named() -> None:
    kind, good, vertices = tamis.PairKind.VERTEX_FACE, np.zeros((20, 3)), np.arange(20).reshape(-1, 4)
    bad = good.copy()
    bad[14, 1] = np.nan
    with pytest.raises(tamis.InvalidStep, match="pair 3"):
        tamis.narrow_phase(kind, vertices, good, bad)
    with pytest.raises(tamis.InvalidStep, match="pair 4"):
        tamis.narrow_phase(kind, vertices + 1, good, good)
    with pytest.raises(tamis.InvalidStep, match=r"\(n, 4\)"):
        tamis.narrow_phase(kind, vertices[:, :3], good, good)
    with pytest.raises(tamis.InvalidStep, match="kind has 2 entries, vertices 5 rows"):
        tamis.narrow_phase([0, 1], vertices, good, good)
    path = tamis.BezierPath(good[np.newaxis])
    with pytest.raises(tamis.InvalidPath, match="vertices"):
        tamis.narrow_phase(kind, vertices[:, :3], path)
    with pytest.raises(tamis.InvalidOptions, match="latest is an option of steps"):
        tamis.narrow_phase(kind, vertices, path, latest=0.5)  # type: ignore[call-overload]
    with pytest.raises(tamis.InvalidOptions, match="tolerance is an option of paths"):
        tamis.narrow_phase(kind, vertices, good, good, tolerance=0.5)  # type: ignore[call-overload]


def test_what_was_asked_is_the_answers_own() -> None:
    """Bug: an answer changed when the caller reused the array of its vertices."""
    kinds, vertices = np.ones(1, np.uint8), np.arange(4, dtype=np.int32)[np.newaxis]
    found = tamis.narrow_phase(kinds, vertices, np.eye(4, 3), -np.eye(4, 3))
    kinds[:], vertices[:] = 0, 0
    assert found.vertices.tolist() == [[0, 1, 2, 3]] and found.kind.tolist() == [1]


def test_pickled_and_back() -> None:
    found = tamis.narrow_phase(tamis.PairKind.EDGE_EDGE, [0, 1, 2, 3], np.eye(4, 3), -np.eye(4, 3))
    copy = pickle.loads(pickle.dumps(found))
    assert copy == found and copy.table.tobytes() == found.table.tobytes()
    assert copy != tamis.narrow_phase(tamis.PairKind.EDGE_EDGE, [1, 0, 2, 3], np.eye(4, 3), -np.eye(4, 3))
