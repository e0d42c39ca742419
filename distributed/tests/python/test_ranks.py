"""`tamis.distributed` under mpirun: all ranks run the same tests in the same order."""

from __future__ import annotations

import faulthandler
import gc
import pathlib
import re
import weakref
from typing import Any

import numpy as np
import pytest
from mpi4py import MPI
from ranks import COMM, IS_LAST, RANK, SIZE, Part

import tamis
from tamis import distributed

ROOT = pathlib.Path(__file__).resolve().parents[3]


@pytest.fixture(scope="module", params=["folded-cloth", "tangle", "rod", "points-on-cloth"])
def scene(request: pytest.FixtureRequest) -> tamis.Scene:
    return tamis.scene(request.param, 300, seed=2)


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
    with pytest.raises(tamis.Error, match="ranks"):
        cloth.detector().contacts(cloth.start, cloth.end).save("step.html")


def test_the_page(capsys: pytest.CaptureFixture[str]) -> None:
    """The Python of docs/distributed.md runs."""
    blocks = re.findall(r"^```python\n(.*?)^```$", (ROOT / "docs/distributed.md").read_text(), re.DOTALL | re.MULTILINE)
    assert blocks
    for code in blocks:
        exec(compile(code, "docs/distributed.md", "exec"), {"__name__": "__page__"})
    assert (capsys.readouterr().out != "") == (RANK == 0)
