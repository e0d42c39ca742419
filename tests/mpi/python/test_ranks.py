"""`tamis.distributed` under mpirun: all ranks run the same tests in the same order."""

from __future__ import annotations

import faulthandler
import gc
import pathlib
import re
import time
import weakref
from typing import Any, Callable

import numpy as np
import pytest
from mpi4py import MPI

import tamis
from tamis import distributed

COMM = MPI.COMM_WORLD
RANK, SIZE = COMM.rank, COMM.size
IS_LAST = RANK == SIZE - 1
NEEDS_OTHERS = pytest.mark.skipif(SIZE == 1, reason="one rank agrees with itself")
ROOT = pathlib.Path(__file__).resolve().parents[3]


class Part:
    """The part of a scene that this rank gives: triangles in turns, so that ranks share nearly all vertices."""

    def __init__(self, scene: tamis.Scene) -> None:
        self.faces = scene.mesh.faces[RANK::SIZE]
        self.edges = scene.mesh.loose_edges[RANK::SIZE]
        self.points = scene.mesh.loose_points[RANK::SIZE]
        used = np.concatenate([self.faces.ravel(), self.edges.ravel(), self.points])
        self.vertices = np.unique(used)[::-1]  # descending: the order of rows is the caller's
        self.start, self.end = scene.start[self.vertices], scene.end[self.vertices]
        self.groups = scene.groups[self.vertices]

    def detector(self, **options: Any) -> distributed.Detector:
        return distributed.Detector(
            COMM, self.faces, self.vertices, edges=self.edges, points=self.points, threads=1, **options
        )


@pytest.fixture(scope="module", params=["folded-cloth", "tangle", "rod", "points-on-cloth"])
def scene(request: pytest.FixtureRequest) -> tamis.Scene:
    return tamis.scene(request.param, 300, seed=2)


@pytest.fixture
def cloth() -> Part:
    return Part(tamis.scene("folded-cloth", 400, seed=1))


def raised_on_all(kind: type[Exception], ask: Callable[[], object]) -> str:
    """Expect an error on all ranks; return its sentence, which must be the same on every rank."""
    with pytest.raises(tamis.Error) as caught:
        ask()
    assert type(caught.value) is kind
    sentences: list[str] = COMM.allgather(str(caught.value))
    assert len(set(sentences)) == 1
    return sentences[0]


def expect_same(one: tamis.Contacts, many: tamis.Contacts) -> None:
    assert one.table.dtype == many.table.dtype
    for name in one.table.dtype.names or ():
        np.testing.assert_array_equal(one.table[name], many.table[name])


def test_contacts_are_those_of_one_process(scene: tamis.Scene) -> None:
    part = Part(scene)
    one, many = tamis.Detector(scene.mesh).contacts(scene.start, scene.end), part.detector()
    mine = many.contacts(part.start, part.end)
    assert COMM.allreduce(len(mine)) == len(one) > 0
    assert np.isin(mine.vertices[:, 0], part.vertices).all()
    gathered = many.gather_contacts(SIZE - 1)
    expect_same(one if IS_LAST else one[:0], gathered)


def test_answers_are_those_of_one_process_on_every_rank(scene: tamis.Scene) -> None:
    part = Part(scene)
    one, many = tamis.Detector(scene.mesh), part.detector()
    assert many.earliest(part.start, part.end) == one.earliest(scene.start, scene.end)
    assert many.is_free(part.start, part.end) is one.is_free(scene.start, scene.end)
    for fraction in (0, 0.1):
        assert many.safe_step(part.start, part.end, fraction) == one.safe_step(scene.start, scene.end, fraction)
    assert many.vertex_count == 1 + max(COMM.allgather(int(part.vertices.max(initial=-1))))


def test_options_mean_what_they_mean_there(scene: tamis.Scene) -> None:
    """Would catch groups that are counted on each rank alone."""

    def some(kind: tamis.PairKind, vertices: tuple[int, int, int, int]) -> bool:
        return min(vertices[:2]) % 3 > 0

    count = int(scene.groups.max()) + 1
    part = Part(scene)
    common: dict[str, Any] = {"radii": np.full(count, 0.01), "filter": some}
    one = tamis.Detector(scene.mesh, groups=scene.groups, **common)
    many = part.detector(groups=part.groups, **common)
    many.contacts(part.start, part.end, min_separation=0.02)
    expected = one.contacts(scene.start, scene.end, min_separation=0.02)
    expect_same(expected if RANK == 0 else expected[:0], many.gather_contacts())


def test_statistics(cloth: Part) -> None:
    many = cloth.detector()
    many.contacts(cloth.start, cloth.end)
    statistics = many.statistics
    assert COMM.allreduce(statistics.owned) == COMM.allreduce(len(cloth.faces))
    assert statistics.decomposed_anew and statistics.seconds["total"] > 0
    assert 1 <= many.balance.pairs <= SIZE
    assert len(set(COMM.allgather(many.balance))) == 1


def test_a_rank_may_have_nothing(cloth: Part) -> None:
    scene = tamis.scene("folded-cloth", 400, seed=1)
    mine = scene.mesh.faces if IS_LAST else scene.mesh.faces[:0]
    rows = np.arange(scene.mesh.vertex_count if IS_LAST else 0)
    many = distributed.Detector(COMM, mine, rows)
    found = many.contacts(scene.start[rows], scene.end[rows])
    assert len(found) == (len(tamis.Detector(scene.mesh).contacts(scene.start, scene.end)) if IS_LAST else 0)


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
    (_OPTIONS, "no instruction set is called", lambda d, p: p.detector(isa=or_bad("best", "other"))),
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


def test_results_do_not_change_and_detectors_come_and_go(cloth: Part) -> None:
    for _ in range(50):
        many = cloth.detector()
        first = many.contacts(cloth.start, cloth.end)
    before = first.table.copy()
    many.contacts(cloth.start, cloth.start)
    del many
    np.testing.assert_array_equal(first.table, before)


class Collecting:
    """A key for mpi4py's table of locks that collects garbage when it is hashed: while the table is locked."""

    def __hash__(self) -> int:
        gc.collect()
        return 0


def test_memory_is_collected_inside_a_call_of_mpi4py(cloth: Part, capfd: pytest.CaptureFixture[str]) -> None:
    """Bug: the communicator was freed at once, and so waited for ever for a lock that its own thread held."""
    cycle: list[Any] = [cloth.detector()]
    cycle.append(cycle)
    gone = weakref.ref(cycle[0])
    del cycle
    with capfd.disabled():  # shows the traceback of a thread that waits
        faulthandler.dump_traceback_later(30, exit=True)
        MPI._comm_lock(COMM, Collecting())
        faulthandler.cancel_dump_traceback_later()
    assert gone() is None


class Counted(MPI.Intracomm):
    """A communicator that counts how many of its class, duplicates included, are freed."""

    freed = 0

    def Free(self) -> None:  # noqa: N802
        Counted.freed += 1
        super().Free()


def test_communicators_are_freed_when_all_their_ranks_have_left_them(cloth: Part) -> None:
    """Would catch a rank that frees (a collective call) what another rank still uses, or frees in another order."""

    def make(comm: MPI.Intracomm) -> distributed.Detector:
        return distributed.Detector(comm, cloth.faces, cloth.vertices)

    def freed_by(comm: MPI.Intracomm) -> int:
        before = Counted.freed
        make(comm)
        return Counted.freed - before

    everyone, alone = Counted(COMM), Counted(COMM.Split(RANK))
    first = make(everyone)
    if not IS_LAST:
        del first
    assert freed_by(everyone) == 0  # the last rank holds it
    if IS_LAST:
        del first
    assert freed_by(alone) == (2 if SIZE == 1 else 0)  # a communicator of this rank alone names no other rank's
    assert freed_by(everyone) == (1 if SIZE == 1 else 3)


def test_what_is_said_of_it(cloth: Part) -> None:
    assert repr(cloth.detector()).startswith(f"Detector(rank {RANK} of {SIZE}, min_separation=")
    for thing in (distributed.Detector, distributed.Statistics, distributed.Balance):
        assert thing.__doc__ and len(thing.__doc__) > 20
    with pytest.raises(tamis.Error, match="of many ranks"):
        cloth.detector().contacts(cloth.start, cloth.end).save("step.html")


def test_the_page(capsys: pytest.CaptureFixture[str]) -> None:
    """The Python of docs/distributed.md runs."""
    blocks = re.findall(r"^```python\n(.*?)^```$", (ROOT / "docs/distributed.md").read_text(), re.DOTALL | re.MULTILINE)
    assert blocks
    for code in blocks:
        exec(compile(code, "docs/distributed.md", "exec"), {"__name__": "__page__"})
    assert (capsys.readouterr().out != "") == (RANK == 0)
