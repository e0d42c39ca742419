"""A world and its shapes as objects: wrong arguments, one question at a time, their lifetime."""

from __future__ import annotations

import pickle
import threading
import weakref
from typing import Any

import numpy as np
import pytest
from conftest import CUBE, CUBE_FACES, at

import tamis

ZERO, NAN, FAR = [0.0, 0.0, 0.0], [np.nan, 0.0, 0.0], [1e160, 0.0, 0.0]


def test_shapes(cube: tamis.Shape) -> None:
    assert np.array_equal(cube.points, CUBE) and cube.memory_bytes > 0 and cube.mesh.vertex_count == 8
    copied = pickle.loads(pickle.dumps(cube))
    assert np.array_equal(copied.points, CUBE) and repr(copied) == repr(cube)
    assert np.array_equal(tamis.Shape(cube.mesh, CUBE, isa="baseline").points, CUBE)
    with pytest.raises(tamis.InvalidOptions, match="best"):
        tamis.Shape(cube.mesh, CUBE, isa="sse9")  # type: ignore[arg-type]
    with pytest.raises(tamis.InvalidMesh, match="7 points"):
        tamis.Shape(tamis.Mesh(CUBE_FACES), CUBE[:7])
    with pytest.raises(TypeError, match="make a World"):
        pickle.dumps(tamis.World())


@pytest.mark.parametrize(
    ("ask", "sentence"),
    [
        (lambda w, s: w.add(s, np.zeros((4, 3))), r"motion has the shape \(4, 3\)"),
        (lambda w, s: w.add_many(s, np.zeros((2, 3))), r"motions has the shape \(2, 3\)"),
        (lambda w, s: w.add_many(s, [[ZERO, ZERO], [ZERO, NAN]]), r"motions\[1\] holds a number that is not finite"),
        (lambda w, s: w.move(2, [NAN, ZERO]), "motion of body 2 holds a number that is not finite"),
        (lambda w, s: w.move_many([0, 2], [[ZERO, ZERO], [ZERO, NAN]]), r"motions\[1\], of body 2, holds a number"),
        (lambda w, s: w.earliest_many([2], [[[[ZERO, ZERO, ZERO, NAN]]]]), r"motions\[0, 0\], of body 2, holds"),
        (lambda w, s: w.move_many([0, 2], [[ZERO, ZERO], [ZERO, FAR]]), "a rotation vector of body 2 is"),
        (
            lambda w, s: w.move(2, tamis.turned_chain(at(ZERO)[0], [0, 0, 5e3], ZERO)),
            "body 2 turns by 5000 radians in one",
        ),
        (lambda w, s: w.add_many(s, [[ZERO, ZERO], [ZERO, FAR]]), "a rotation vector of body 4 is"),
        (lambda w, s: w.move_many([0, 1], at((0, 0, 0))), "motions has 1 entries, bodies 2"),
        (lambda w, s: w.move_many([0, 0], at((0, 0, 0), (1, 1, 1))), "bodies holds 0 twice"),
        (lambda w, s: w.move_many([0, 7], at((0, 0, 0), (1, 1, 1))), "body 7"),
        (lambda w, s: w.set_may_touch([1, 1], True), "does not deform"),
        (lambda w, s: w.set_may_touch([0, 1, 2], True), r"give \(n, 2\)"),
        (lambda w, s: w.contacts(at_start="fail"), "start"),
        (lambda w, s: w.contacts(tolerance=0), "tolerance"),
        (lambda w, s: w.contacts(min_separation=-1), "minimum separation"),
        (lambda w, s: w.add(CUBE, CUBE), "shape"),
    ],
)
def test_misuse_is_refused(cube: tamis.Shape, ask: Any, sentence: str) -> None:
    world = tamis.World()
    world.add(cube)
    world.add(cube)
    world.add(cube, tamis.chain_between(at((0, 0, 0)), at((1, 0, 0)))[0])
    before = world.contacts()
    with pytest.raises(tamis.Error, match=sentence):
        ask(world, cube)
    assert world.contacts() == before


def test_one_question_at_a_time_and_an_end_to_it(cube: tamis.Shape) -> None:
    """A change during a question is refused; a cancelled question leaves the world as it was."""
    random = np.random.default_rng(2)
    stopping = threading.Event()
    refused: list[Exception] = []

    def is_cancelled() -> bool:
        try:
            world.add(cube)
        except tamis.Busy as error:
            refused.append(error)
        return stopping.is_set() or bool(refused)

    world = tamis.World(threads=1, is_cancelled=is_cancelled)
    world.add_many(
        cube,
        tamis.chain_between(
            *(tamis.pose_of(random.normal(size=(300, 3)), random.normal(size=(300, 3))) for _ in range(2))
        ),
    )
    with pytest.raises(tamis.Cancelled):
        world.contacts()
    assert refused and world.add(cube) == 300


def test_a_world_and_its_callback_are_collected(cube: tamis.Shape) -> None:
    import gc

    class Owner:
        def __init__(self) -> None:
            self.world = tamis.World(is_cancelled=self.stop)

        def stop(self) -> bool:
            return False

    owner = Owner()
    owner.world.add(cube)
    gone = weakref.ref(owner)
    del owner
    gc.collect()
    assert gone() is None
