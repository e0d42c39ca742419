"""The questions, against the oracle and against each other."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

import oracle
import tamis

COORDINATES = st.integers(-8, 8).map(lambda i: i / 4)


def test_the_example_of_the_readme(detector: tamis.Detector, falling: tamis.Scene) -> None:
    contacts = detector.contacts(falling.start, falling.end)
    assert len(contacts) == 1
    assert contacts.vertices.tolist() == [[3, 0, 1, 2]]
    assert contacts.kind.tolist() == [tamis.PairKind.VERTEX_FACE]
    assert contacts.toi_lower[0] <= 0.5 <= contacts.toi_upper[0]
    assert contacts.u[0] == pytest.approx(0.25) and contacts.v[0] == pytest.approx(0.25)
    assert contacts.normal[0, 2] == pytest.approx(1)  # up, where it falls from
    assert contacts.certified.tolist() == [True]


@settings(max_examples=60)
@given(arrays(np.float64, (6, 3), elements=COORDINATES), arrays(np.float64, (6, 3), elements=COORDINATES))
def test_contacts_are_those_of_the_oracle(start: np.ndarray, end: np.ndarray) -> None:
    """Would catch a pair lost, invented or named wrongly, and a bracket that does not contain the time."""
    faces = [[0, 1, 2], [3, 4, 5]]
    try:
        expected = oracle.contacts(faces, start.tolist(), end.tolist())
    except oracle.Degenerate:
        assume(False)
    found = tamis.contacts(faces, start, end)
    assert {(int(c.kind), *c.vertices) for c in found} == set(expected)
    for contact in found:
        when = expected[(int(contact.kind), *contact.vertices)]
        assert contact.certified
        assert contact.toi_lower <= when.upper and when.lower <= contact.toi_upper


@settings(max_examples=40)
@given(arrays(np.float64, (6, 3), elements=COORDINATES), arrays(np.float64, (6, 3), elements=COORDINATES))
def test_all_questions_agree(start: np.ndarray, end: np.ndarray) -> None:
    detector = tamis.Detector(tamis.Mesh([[0, 1, 2], [3, 4, 5]]))
    contacts = detector.contacts(start, end)
    first = detector.earliest(start, end)
    assert detector.is_free(start, end) == (len(contacts) == 0) == (first.contact is None)
    kept = detector.safe_step(start, end, 0)
    assert kept.toi_lower == first.toi_lower
    assert kept.pair is None or (kept.pair.kind, kept.pair.vertices) == first.contact[:2]  # type: ignore[index]
    if len(contacts):
        assert first.toi_lower <= contacts.toi_lower.min() + 1e-12
        assert detector.safe_step(start, end, 0.5).toi_lower <= first.toi_lower


def test_keeping_half_of_the_distance(detector: tamis.Detector, falling: tamis.Scene) -> None:
    safe = detector.safe_step(falling.start, falling.end, 0.5)
    assert safe.toi_lower == pytest.approx(0.25, abs=1e-6) and safe.toi_lower <= 0.25 <= safe.toi_upper
    assert safe.pair == detector.pairs_within(falling.start, 1)[0]
    assert safe.pair.vertices == (3, 0, 1, 2) and safe.pair.direction == (0, 0, 1)


def test_a_free_step(detector: tamis.Detector, falling: tamis.Scene) -> None:
    assert detector.is_free(falling.start, falling.start)
    assert detector.earliest(falling.start, falling.start) == (1.0, 1.0, None)
    assert detector.safe_step(falling.start, falling.start, 0.9) == (1.0, 1.0, None)
    assert len(detector.contacts(falling.start, falling.start)) == 0


@pytest.mark.parametrize("isa", ["best", "baseline"])
@pytest.mark.parametrize("threads", [1, 3])
def test_instruction_sets_and_threads_change_nothing(soup: tamis.Scene, isa: Any, threads: int) -> None:
    expected = tamis.Detector(soup.mesh).contacts(soup.start, soup.end)
    found = tamis.Detector(soup.mesh, isa=isa, threads=threads).contacts(soup.start, soup.end)
    assert len(found) > 100
    assert np.array_equal(found.kind, expected.kind) and np.array_equal(found.vertices, expected.vertices)


def test_one_line(falling: tamis.Scene) -> None:
    assert len(tamis.contacts(falling.mesh.faces, falling.start, falling.end)) == 1
    assert len(tamis.contacts(falling.mesh.faces, falling.start, falling.end, min_separation=3.0)) > 1


def test_statistics_tell_of_the_last_question(detector: tamis.Detector, falling: tamis.Scene) -> None:
    detector.contacts(falling.start, falling.end)
    first = detector.statistics
    assert first.rebuilt and first.stages["boxes"][0] >= 1 and first.seconds["total"] > 0
    assert sum(first.decided_by.values()) >= 1
    detector.contacts(falling.start, falling.end)
    assert not detector.statistics.rebuilt


def test_rods_and_points_take_part() -> None:
    start = np.array([[0, 0, 0], [2, 0, 0], [1, -1, 1], [1, 1, 1], [1.0, 0, 2]])
    end = start - [[0, 0, 0], [0, 0, 0], [0, 0, 2], [0, 0, 2], [0, 0, 0]]
    rods = tamis.Mesh([], vertex_count=5, edges=[[0, 1], [2, 3]], points=[4])
    found = tamis.Detector(rods).contacts(start, end)
    assert [(c.kind, c.vertices) for c in found] == [(tamis.PairKind.EDGE_EDGE, (0, 1, 2, 3))]
    assert rods.points.tolist() == [0, 1, 2, 3, 4] and rods.loose_points.tolist() == [4]


def test_everything_says_what_it_is(detector: tamis.Detector, falling: tamis.Scene) -> None:
    found = detector.contacts(falling.start, falling.end)
    assert repr(falling.mesh) == "Mesh(6 vertices, 2 triangles, 6 edges)"
    assert repr(detector).startswith("Detector(Mesh(6 vertices") and "min_separation=0" in repr(detector)
    assert repr(found) == "Contacts(1 vertex-face; first at 0.5)"
    assert repr(found[:0]) == "Contacts(none)"
    assert "toi_lower" in repr(found[0]) and "VERTEX_FACE" in repr(found[0])
