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


@pytest.mark.parametrize(("kind", "ask"), [(0, tamis.vertex_face), (1, tamis.edge_edge)])
def test_decided_as_the_oracle_does(kind: int, ask) -> None:  # type: ignore[no-untyped-def]
    @settings(max_examples=80)
    @given(PAIRS, PAIRS)
    def check(start: np.ndarray, end: np.ndarray) -> None:
        try:
            expected = oracle.first_contact(kind, start.tolist(), end.tolist())
        except oracle.Degenerate:
            assume(False)
        found = ask(start, end)
        assert len(found) == 1
        assert bool(found.touches[0]) == (expected is not None)
        if expected is not None:
            assert found.certified[0]
            assert found.toi_lower[0] <= expected.upper and expected.lower <= found.toi_upper[0]

    check()


def test_each_pair_by_itself() -> None:
    """Would catch rows that are mixed up."""
    random = np.random.default_rng(5)
    start, end = random.uniform(-1, 1, (2, 500, 4, 3))
    for ask in (tamis.vertex_face, tamis.edge_edge):
        together = ask(start, end)
        assert 0 < together.touches.sum() < 500
        one_by_one = np.concatenate([ask(s, e).table for s, e in zip(start, end)])
        for name in ("touches", "certainty", "toi_lower", "toi_upper", "u", "v", "normal"):
            assert np.array_equal(together.table[name], one_by_one[name])


def test_points_against_segments_and_points() -> None:
    start = np.array([[0, 0, 1.0], [-1, 0, 0], [1, 0, 0]])
    end = start * [[1, 1, -1], [1, 1, 1], [1, 1, 1]]
    found = tamis.vertex_edge(start, end)
    assert found.touches[0] and found.toi_lower[0] <= 0.5 <= found.toi_upper[0] and found.u[0] == pytest.approx(0.5)
    apart = tamis.vertex_vertex(start[:2], end[:2])
    assert not apart.touches[0]
    met = tamis.vertex_vertex(start[:2] * [0, 0, 1], [[0, 0, -3], [0, 0, 0]])
    assert met.touches[0] and met.toi_lower[0] <= 0.25 <= met.toi_upper[0]


def test_separation() -> None:
    start = np.array([[0.2, 0.2, 1.5], [0, 0, 0], [1, 0, 0], [0, 1, 0]])
    end = start - [[0, 0, 1], [0, 0, 0], [0, 0, 0], [0, 0, 0]]
    assert not tamis.vertex_face(start, end).touches[0]
    near = tamis.vertex_face(start, end, min_separation=1.0)
    assert near.touches[0] and near.toi_lower[0] <= 0.5 <= near.toi_upper[0]
    with pytest.raises(tamis.InvalidOptions):
        tamis.vertex_face(start, end, min_separation=-1)


def test_none_at_all() -> None:
    none = tamis.edge_edge(np.empty((0, 4, 3)), np.empty((0, 4, 3)))
    assert len(none) == 0 and repr(none) == "Pairs(0 edge-edge, 0 touch)"


def test_bad_pairs_are_named() -> None:
    good = np.zeros((5, 4, 3))
    bad = good.copy()
    bad[3, 2, 1] = np.nan
    with pytest.raises(tamis.InvalidStep, match="pair 3"):
        tamis.vertex_face(good, bad)
    with pytest.raises(tamis.InvalidStep, match="5 pairs"):
        tamis.edge_edge(good, good[:4])
    with pytest.raises(tamis.InvalidStep, match=r"\(n, 4, 3\)"):
        tamis.edge_edge(good[:, :3], good[:, :3])


def test_pickled_and_back() -> None:
    found = tamis.edge_edge(np.eye(4, 3), -np.eye(4, 3))
    assert pickle.loads(pickle.dumps(found)).table.tobytes() == found.table.tobytes()
