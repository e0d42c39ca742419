"""The interpreter's lock, Ctrl-C, several threads, and forks."""

from __future__ import annotations

import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import pytest

import tamis

# Questions of half a second or more, for minutes unless Ctrl-C ends them.
LONG = """
import signal, sys, time, tamis
signal.signal(signal.SIGINT, signal.default_int_handler)  # also where the parent ignores it
scene = tamis.scene("soup", 6000)
small = tamis.scene("soup", 6)
detector = tamis.Detector(scene.mesh)
print("asking", flush=True)
try:
    {question}
    print("answered")
except KeyboardInterrupt:
    print("interrupted", time.time(), flush=True)
"""


def interrupted_after(code: str) -> float:
    """Return the seconds from Ctrl-C to KeyboardInterrupt."""
    if sys.platform == "win32":
        pytest.skip("Windows sends Ctrl-C to a console, not to one process")
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "asking\n"
        time.sleep(0.5)
        sent = time.time()
        process.send_signal(signal.SIGINT)
        word, _, at = process.stdout.readline().strip().partition(" ")
        process.kill()
        assert word == "interrupted"
        return float(at) - sent


@pytest.mark.parametrize(
    "question",
    ["contacts(scene.start, scene.end, min_separation=0.05)", "pairs_within(scene.start, 0.05)"],
)
def test_ctrl_c_ends_a_long_question(question: str) -> None:
    code = LONG.format(question=f"[detector.{question} for _ in range(1000)]")
    assert interrupted_after(code) < 1


def test_ctrl_c_ends_many_pairs() -> None:
    code = LONG.format(
        question="import numpy as np; p = np.random.default_rng(1).uniform(-1, 1, (1_600_000, 3)); "
        "[tamis.narrow_phase(1, np.arange(1_600_000).reshape(-1, 4), p, -p) for _ in range(1000)]",
    )
    assert interrupted_after(code) < 1


def test_a_cancelled_question_leaves_the_detector_as_it_was() -> None:
    stop = True
    soup = tamis.scene("soup", 3000)
    detector = tamis.Detector(soup.mesh, min_separation=0.15, is_cancelled=lambda: stop)
    with pytest.raises(tamis.Cancelled, match="repeat it"):
        for _ in range(100):  # each takes longer than the pause between two looks
            detector.contacts(soup.start, soup.end)
    stop = False
    assert detector.contacts(soup.start, soup.end) == tamis.Detector(soup.mesh, min_separation=0.15).contacts(
        soup.start, soup.end
    )


def test_a_raising_is_cancelled_arrives() -> None:
    soup = tamis.scene("soup", 3000)

    def is_cancelled() -> bool:
        raise RuntimeError("no more")

    detector = tamis.Detector(soup.mesh, min_separation=0.15, is_cancelled=is_cancelled)
    with pytest.raises(RuntimeError, match="no more"):
        for _ in range(100):
            detector.contacts(soup.start, soup.end)


@pytest.mark.parametrize("answer", [None, "no", 0, 1, np.array([False])])
def test_an_is_cancelled_that_answers_neither_true_nor_false(answer: object) -> None:
    """Would catch that a truthy answer cancels, and that a function without `return` never does."""
    soup = tamis.scene("soup", 3000)
    given: Any = answer
    detector = tamis.Detector(soup.mesh, min_separation=0.15, is_cancelled=lambda: given)
    sentence = "is_cancelled returned an object of the type .*: return True or False"
    with pytest.raises(tamis.InvalidOptions, match=sentence):
        for _ in range(100):  # each takes longer than the pause between two looks
            detector.contacts(soup.start, soup.end)


def test_other_threads_run_during_a_question() -> None:
    """Would catch a question that holds the interpreter's lock: then no tick falls into it."""
    scene = tamis.scene("soup", 3000)
    detector = tamis.Detector(scene.mesh, min_separation=0.15)
    done = threading.Event()
    ticks: list[float] = []
    span: list[float] = []

    def ask() -> None:
        span.append(time.perf_counter())
        detector.contacts(scene.start, scene.end)
        span.append(time.perf_counter())
        done.set()

    thread = threading.Thread(target=ask)
    thread.start()
    while not done.wait(0.002):
        ticks.append(time.perf_counter())
    thread.join()
    assert span[1] - span[0] > 0.05
    assert sum(span[0] < tick < span[1] for tick in ticks) >= 3


def test_a_second_question_at_once_is_refused() -> None:
    scene = tamis.scene("soup", 3000)
    detector = tamis.Detector(scene.mesh, min_separation=0.15)
    first = threading.Thread(target=detector.contacts, args=(scene.start, scene.end))
    first.start()
    refused = 0
    while first.is_alive():
        try:
            detector.is_free(scene.start, scene.start)
        except tamis.Busy:
            refused += 1
        time.sleep(0.001)
    first.join()
    assert refused > 0
    assert len(detector.contacts(scene.start, scene.end)) > 0


def test_a_detector_for_each_thread(soup: tamis.Scene) -> None:
    expected = tamis.Detector(soup.mesh).contacts(soup.start, soup.end)

    def ask(_: int) -> tamis.Contacts:
        return tamis.Detector(soup.mesh).contacts(soup.start, soup.end)

    with ThreadPoolExecutor(4) as pool:
        assert all(found == expected for found in pool.map(ask, range(12)))


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no fork")
@pytest.mark.filterwarnings("ignore:.*multi-threaded.*fork:DeprecationWarning")
def test_a_forked_child_can_ask(soup: tamis.Scene) -> None:
    """The child lacks the threads of the parent's pool: the calling thread alone must answer."""
    detector = tamis.Detector(soup.mesh)
    expected = len(detector.contacts(soup.start, soup.end))
    context = multiprocessing.get_context("fork")
    answers = context.SimpleQueue()

    def ask() -> None:
        answers.put(len(detector.contacts(soup.start, soup.end)))
        answers.put(len(tamis.Detector(soup.mesh).contacts(soup.start, soup.end)))

    child = context.Process(target=ask)
    child.start()
    child.join(60)
    if child.is_alive():
        os.kill(child.pid or 0, signal.SIGKILL)
        pytest.fail("the child hangs")
    assert [answers.get(), answers.get()] == [expected, expected]


def test_spawned_processes_share_a_mesh(soup: tamis.Scene) -> None:
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        found = pool.apply(tamis.contacts, (soup.mesh.faces, soup.start, soup.end))
    assert np.array_equal(found.table, tamis.contacts(soup.mesh.faces, soup.start, soup.end).table)
