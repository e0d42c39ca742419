"""The options `at_start`, for pairs that touch at the start, and `rings`, for neighbours along the mesh."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import tamis

LIES = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.2, 0.2, 0.05]])
UP = LIES + np.array([[0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 1]])

Ask = Callable[..., Any]
QUESTIONS: dict[str, Ask] = {
    "contacts": lambda d, **own: len(d.contacts(LIES, UP, **own)),
    "earliest": lambda d, **own: d.earliest(LIES, UP, **own).toi_lower,
    "is_free": lambda d, **own: d.is_free(LIES, UP, **own),
    "safe_step": lambda d, **own: d.safe_step(LIES, UP, **own).toi_lower,
    "truncate": lambda d, **own: d.truncate(LIES, UP, **own).is_free,
}
REPORTED = {"contacts": 1, "earliest": 0, "is_free": False, "safe_step": 0, "truncate": False}
IGNORED = {"contacts": 0, "earliest": 1, "is_free": True, "safe_step": 1, "truncate": True}


@pytest.fixture
def lying() -> tamis.Detector:
    """Return a point above a triangle, within the separation."""
    return tamis.Detector(tamis.Mesh([[0, 1, 2]], points=[3], vertex_count=4), min_separation=0.1)


@pytest.mark.parametrize("name", QUESTIONS)
def test_every_question_knows_all_ways(lying: tamis.Detector, name: str) -> None:
    ask = QUESTIONS[name]
    assert ask(lying) == ask(lying, at_start="report") == REPORTED[name]
    assert ask(lying, at_start="ignore") == IGNORED[name]
    assert ask(lying, at_start="fail", min_separation=0.01) == IGNORED[name]
    with pytest.raises(tamis.InvalidStep, match="vertex 3 and face 0 1 2 touch at the start"):
        ask(lying, at_start="fail")
    with pytest.raises(tamis.InvalidOptions, match="report, ignore, fail"):
        ask(lying, at_start="forget")


def test_ignored_pairs_are_counted(lying: tamis.Detector) -> None:
    lying.contacts(LIES, UP)
    assert lying.statistics.ignored == 0
    lying.contacts(LIES, UP, at_start="ignore")
    assert lying.statistics.ignored == 1


def test_a_path_ignores_and_fails_too(lying: tamis.Detector) -> None:
    path = tamis.BezierPath(np.stack([LIES, UP]))
    assert not lying.is_free(path)
    assert lying.is_free(path, at_start="ignore")
    with pytest.raises(tamis.InvalidStep, match="touch at the start of the path"):
        lying.is_free(path, at_start="fail")


def test_contacts_are_shown_as_they_were_asked_for(lying: tamis.Detector, tmp_path: Any) -> None:
    contacts = lying.contacts(UP, LIES, at_start="ignore")
    assert len(contacts) == 1
    contacts.save(tmp_path / "contacts.csv")
    assert (tmp_path / "contacts.csv").read_text().count("\n") == 2


def test_rings_leave_out_neighbours() -> None:
    rod = np.array([[float(i), 0, 0] for i in range(6)])
    mesh = tamis.Mesh(np.empty((0, 3), int), edges=[[i, i + 1] for i in range(5)], vertex_count=6)
    counts = [len(tamis.Detector(mesh, min_separation=2.5, rings=k).contacts(rod, rod)) for k in (1, 2, 3)]
    assert counts[0] > counts[1] > counts[2] == 0
    with pytest.raises(tamis.InvalidOptions, match="rings"):
        tamis.Detector(mesh, rings=0)
