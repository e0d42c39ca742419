"""Every option reaches the library, and every bad option is refused with a sentence."""

from __future__ import annotations

import gc
import weakref
from typing import Any

import numpy as np
import pytest

import tamis


def count(scene: tamis.Scene, **options: Any) -> int:
    return len(tamis.Detector(scene.mesh, **options).contacts(scene.start, scene.end))


def test_an_instruction_set_and_threads(falling: tamis.Scene) -> None:
    assert count(falling, isa="baseline", threads=1) == 1


def test_groups_leave_out_pairs(falling: tamis.Scene) -> None:
    other = ~np.eye(2, dtype=bool)
    assert count(falling, groups=falling.groups, may_touch=other) == 1
    assert count(falling, groups=falling.groups, may_touch=~other) == 0
    assert count(falling, groups=falling.groups) == 1
    assert count(falling, groups=falling.groups * 0, may_touch=other) == 0


def test_thickness_and_a_separation_of_one_question(falling: tamis.Scene) -> None:
    detector = tamis.Detector(falling.mesh, groups=falling.groups, radii=[0.1, 0.2])
    assert detector.earliest(falling.start, falling.end).toi_lower == pytest.approx(0.35)
    assert detector.earliest(falling.start, falling.end, min_separation=0.2).toi_lower == pytest.approx(0.25)
    assert detector.is_free(falling.start, falling.start, min_separation=0.6)
    assert not detector.is_free(falling.start, falling.start, min_separation=0.8)
    assert len(detector.contacts(falling.start, falling.start, min_separation=0.8)) > 0
    plain = tamis.Detector(falling.mesh)
    safe = plain.safe_step(falling.start, falling.end, 0.5, min_separation=0.5)
    assert safe.toi_lower == pytest.approx(0.125, abs=1e-6)
    for bad in (-1.0, float("nan"), float("inf")):
        with pytest.raises(tamis.InvalidOptions):
            plain.is_free(falling.start, falling.end, min_separation=bad)


def test_a_filter_is_asked_about_each_pair(falling: tamis.Scene) -> None:
    asked = []

    def accepts(kind: tamis.PairKind, vertices: tuple[int, int, int, int]) -> bool:
        asked.append((kind, vertices))
        return False

    assert count(falling, filter=accepts) == 0
    assert (tamis.PairKind.VERTEX_FACE, (3, 0, 1, 2)) in asked
    assert count(falling, filter=lambda kind, vertices: True) == 1


def test_a_filter_that_raises(soup: tamis.Scene) -> None:
    """The exception reaches the caller unchanged, from any thread, and the detector can be asked again."""
    calls = 0

    def accepts(kind: tamis.PairKind, vertices: tuple[int, int, int, int]) -> bool:
        nonlocal calls
        calls += 1
        if broken and calls > 50:
            raise KeyError("not this one")
        return True

    expected = tamis.Detector(soup.mesh).contacts(soup.start, soup.end)
    detector = tamis.Detector(soup.mesh, filter=accepts, threads=2)
    for _ in range(5):
        broken, calls = True, 0
        with pytest.raises(KeyError, match="not this one"):
            detector.contacts(soup.start, soup.end)
        broken = False
        assert detector.contacts(soup.start, soup.end) == expected


@pytest.mark.parametrize("answer", [None, "no", 1, np.array([True])])
def test_a_filter_that_answers_neither_true_nor_false(falling: tamis.Scene, answer: object) -> None:
    sentence = r"filter, asked about the pair \(3, 0, 1, 2\), returned an object of the type .*: return True or False"
    with pytest.raises(tamis.InvalidOptions, match=sentence):
        count(falling, filter=lambda kind, vertices: answer)
    assert count(falling, filter=lambda kind, vertices: np.True_) == 1


def test_a_filter_that_asks_its_own_detector(falling: tamis.Scene) -> None:
    """Would catch a detector that waits for itself for ever."""

    def accepts(kind: tamis.PairKind, vertices: tuple[int, int, int, int]) -> bool:
        return bool(detector.contacts(falling.start, falling.end))

    detector = tamis.Detector(falling.mesh, filter=accepts)
    with pytest.raises(tamis.Busy, match="another question"):
        detector.contacts(falling.start, falling.end)


def test_a_filter_that_refers_to_its_detector_is_collected(falling: tamis.Scene) -> None:
    """Would catch a cycle through the compiled part that Python's garbage collector does not see."""

    class Simulator:
        def __init__(self) -> None:
            self.detector = tamis.Detector(falling.mesh, filter=self.accepts)

        def accepts(self, kind: tamis.PairKind, vertices: tuple[int, int, int, int]) -> bool:
            return True

    gone = weakref.ref(Simulator().detector._detector)
    gc.collect()
    assert gone() is None


BAD: dict[str, dict[str, Any]] = {
    "isa": {"isa": "sse9"},
    "negative threads": {"threads": -1},
    "too many threads": {"threads": 2**40},
    "negative separation": {"min_separation": -1.0},
    "separation that is not a number": {"min_separation": float("nan")},
    "groups of another size": {"groups": [0, 1]},
    "negative groups": {"groups": [-1] * 6},
    "groups that are no integers": {"groups": [0.5] * 6},
    "a lopsided matrix": {"groups": [0, 0, 0, 1, 1, 1], "may_touch": [[True, False], [True, True]]},
    "a matrix that is not square": {"groups": [0, 0, 0, 1, 1, 1], "may_touch": [[True, False]]},
    "a matrix that is too small": {"groups": [0, 0, 0, 2, 2, 2], "may_touch": np.ones((2, 2), bool)},
    "negative radii": {"groups": [0, 0, 0, 1, 1, 1], "radii": [-1.0, 0.0]},
    "radii of too few groups": {"groups": [0, 0, 0, 1, 1, 1], "radii": [0.1]},
    "radii in two dimensions": {"radii": [[0.1]]},
}


@pytest.mark.parametrize("name", BAD)
def test_bad_options_are_refused(falling: tamis.Scene, name: str) -> None:
    with pytest.raises(tamis.InvalidOptions, match=":"):
        count(falling, **BAD[name])


def test_bad_fractions(detector: tamis.Detector, falling: tamis.Scene) -> None:
    for fraction in (-0.1, 1.0, float("nan")):
        with pytest.raises(tamis.InvalidOptions):
            detector.safe_step(falling.start, falling.end, fraction)


def test_errors_are_of_one_family() -> None:
    for name in ("InvalidMesh", "InvalidStep", "InvalidOptions", "FileError", "Busy", "Cancelled"):
        assert issubclass(getattr(tamis, name), tamis.Error)
    assert issubclass(tamis.InvalidStep, ValueError) and issubclass(tamis.FileError, OSError)
