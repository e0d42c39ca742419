"""What one rank gives wrong, differently or not at all is raised on all of them."""

from __future__ import annotations

import time
from typing import Any, Callable

import numpy as np
import pytest
from ranks import COMM, IS_LAST, NEEDS_OTHERS, SIZE, Part, raised_on_all

import tamis
from tamis import distributed


@NEEDS_OTHERS
def test_options_that_differ(cloth: Part) -> None:
    sentence = raised_on_all(tamis.InvalidOptions, lambda: cloth.detector(min_separation=0.5 if IS_LAST else 0.0))
    assert sentence.startswith(f"rank {SIZE - 1}: here it is 'min_separation 0.5'")


@NEEDS_OTHERS
def test_questions_that_differ(cloth: Part) -> None:
    many = cloth.detector()
    ask: Callable[..., object] = many.earliest if IS_LAST else many.contacts
    sentence = raised_on_all(tamis.InvalidOptions, lambda: ask(cloth.start, cloth.end))
    assert sentence.startswith(f"rank {SIZE - 1}: here it is 'earliest'")


def test_not_a_number_on_one_rank(cloth: Part) -> None:
    many, right = cloth.detector(), cloth.end.copy()
    if IS_LAST:
        cloth.end[0, 1] = np.nan
    sentence = raised_on_all(tamis.InvalidStep, lambda: many.contacts(cloth.start, cloth.end))
    assert sentence.startswith("rank ") and "in the end of the step" in sentence
    assert COMM.allreduce(len(many.contacts(cloth.start, right))) > 0


Ask = Callable[[distributed.Detector, Part], object]
_MESH, _STEP, _OPTIONS = tamis.InvalidMesh, tamis.InvalidStep, tamis.InvalidOptions


def or_bad(right: Any, bad: Any) -> Any:
    return bad if IS_LAST else right


WRONG: list[tuple[type[Exception], str, Ask]] = [
    (_STEP, "start has the shape (2)", lambda d, p: d.contacts(or_bad(p.start, [1, 2]), p.end)),
    (_STEP, "of the dtype object", lambda d, p: d.is_free(p.start, or_bad(p.end, [[None] * 3]))),
    (_STEP, "has 1 positions", lambda d, p: d.earliest(or_bad(p.start, p.start[:1]), p.end)),
    (tamis.InvalidOptions, "keep is 'all'", lambda d, p: d.safe_step(p.start, p.end, or_bad(0.1, "all"))),
    (
        tamis.InvalidOptions,
        "min_separation is [1]",
        lambda d, p: d.contacts(p.start, p.end, min_separation=or_bad(None, [1])),
    ),
    (tamis.InvalidOptions, "root is None", lambda d, p: d.gather_contacts(or_bad(0, None))),
    (_MESH, "faces has the shape", lambda d, p: distributed.Detector(COMM, or_bad([], [[1]]), [])),
    (_MESH, "names vertex -7", lambda d, p: distributed.Detector(COMM, or_bad([], [[0, 1, -7]]), [])),
    (_OPTIONS, "unknown instruction set", lambda d, p: p.detector(isa=or_bad("best", "other"))),
    (_OPTIONS, "threads is -1", lambda d, p: distributed.Detector(COMM, p.faces, p.vertices, threads=or_bad(1, -1))),
    (_OPTIONS, "of the dtype <U1", lambda d, p: p.detector(groups=or_bad(p.groups, ["a"]))),
    (_OPTIONS, "groups holds 2147483647", lambda d, p: p.detector(groups=or_bad(p.groups, [2**31 - 1]))),
]


@pytest.mark.parametrize(("kind", "sentence", "ask"), WRONG)
def test_what_one_rank_gives_wrong_is_raised_on_all(
    cloth: Part, kind: type[Exception], sentence: str, ask: Ask
) -> None:
    many = cloth.detector()
    said = raised_on_all(kind, lambda: ask(many, cloth))
    assert said.startswith(f"rank {SIZE - 1}: ") and sentence in said
    assert many.earliest(cloth.start, cloth.end).contact


def test_a_rank_that_is_none(cloth: Part) -> None:
    many = cloth.detector()
    assert "root is -1" in raised_on_all(tamis.InvalidOptions, lambda: many.gather_contacts(-1))


class Mute(Exception):
    """Says nothing."""

    def __str__(self) -> str:
        raise ValueError


@pytest.mark.parametrize(
    ("reason", "text"),
    [
        (KeyError("not ready"), "KeyError: 'not ready'"),
        (ValueError("\udc80"), "ValueError: \\udc80"),  # bug: the rank died
        (Mute(), "Mute: its text raises an exception, too"),
    ],
)
def test_a_filter_that_raises_on_one_rank(cloth: Part, reason: Exception, text: str) -> None:
    def accepts(kind: tamis.PairKind, vertices: tuple[int, int, int, int]) -> bool:
        if IS_LAST:
            raise reason
        return True

    many = cloth.detector(filter=accepts)
    said = raised_on_all(tamis.Error, lambda: many.contacts(cloth.start, cloth.end))
    assert said == f"rank {SIZE - 1}: the filter raised {text}"


class Silent:
    """An argument that cannot be read, for a reason that cannot be said."""

    def __array__(self, *_: Any, **__: Any) -> Any:
        raise Mute


def test_what_cannot_be_said_is_raised_on_all(cloth: Part) -> None:
    """Bug: the rank raised that alone, while the others waited for its reason."""
    many = cloth.detector()
    said = raised_on_all(tamis.Error, lambda: many.contacts(or_bad(cloth.start, Silent()), cloth.end))
    assert said == f"rank {SIZE - 1}: Mute: its text raises an exception, too"


class Half:
    """A number of a type of its own."""

    def __float__(self) -> float:
        return 0.5


def test_a_number_may_be_of_any_type(cloth: Part) -> None:
    """Bug: the rank raised TypeError alone, once the detector was made."""
    assert "min_separation=0.5" in repr(cloth.detector(min_separation=or_bad(0.5, Half())))
    assert cloth.detector(min_separation=or_bad(0.0, -0.0)).vertex_count


def waiting(kind: tamis.PairKind, vertices: tuple[int, int, int, int]) -> bool:
    """Accept every pair, but make the last rank's search longer than the pause between two calls of is_cancelled."""
    time.sleep(0.001 * IS_LAST)
    return True


def test_one_rank_cancels(cloth: Part) -> None:
    many = cloth.detector(is_cancelled=lambda: IS_LAST, filter=waiting)
    said = raised_on_all(tamis.Cancelled, lambda: many.contacts(cloth.start, cloth.end))
    assert said.startswith(f"rank {SIZE - 1}: the question was cancelled")


def test_an_interrupt_stays_itself_on_its_rank(cloth: Part) -> None:
    def interrupted() -> bool:
        if IS_LAST:
            raise KeyboardInterrupt
        return False

    many = cloth.detector(is_cancelled=interrupted, filter=waiting)
    with pytest.raises(KeyboardInterrupt if IS_LAST else tamis.Cancelled):
        many.contacts(cloth.start, cloth.end)


def test_a_question_within_a_question(cloth: Part) -> None:
    many: distributed.Detector = cloth.detector(filter=lambda kind, v: many.is_free(cloth.start, cloth.end))
    said = raised_on_all(tamis.Error, lambda: many.contacts(cloth.start, cloth.end))
    assert "the filter raised Busy: the detector is answering another question" in said
