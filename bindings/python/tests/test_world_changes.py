"""Changes of a world: bodies are added, moved, switched off and removed; and changes that are refused."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from conftest import at

import tamis


def test_removed_switched_off_and_kept_apart(cube: tamis.Shape) -> None:
    world = tamis.World()
    bodies = world.add_many(cube, at((0, 0, 0), (10, 0, 0), (20, 0, 0)))
    flying = world.add(cube, tamis.chain_between(at((-5, 0, 0)), at((25, 0, 0)))[0])

    def met() -> set[int]:
        return {*world.contacts().bodies.ravel().tolist()} - {flying}

    assert met() == {0, 1, 2}
    world.set_enabled(bodies[:2], False)
    assert met() == {2}
    world.set_enabled(0, True)
    world.set_may_touch([[0, flying], [2, flying]], False)
    assert met() == set()
    world.set_may_touch([2, flying], True)
    assert met() == {2}
    world.remove(bodies[1:])
    assert met() == set()
    for ask in (world.remove, lambda body: world.move(body, at((0, 0, 0))[0]), lambda b: world.set_enabled(b, True)):
        with pytest.raises(tamis.InvalidOptions, match="body 1"):
            ask(1)
    assert world.add(cube) == 4


@pytest.mark.parametrize("bad", [-1, 4, 9])
def test_one_that_is_not_there_leaves_all_as_they_were(cube: tamis.Shape, bad: int) -> None:
    """Bug: the bodies named before a wrong one were removed, switched off or moved, though the call failed."""
    world = tamis.World()
    world.add_many(cube, at((0, 0, 0), (0, 10, 0)))
    world.add_many(cube, tamis.chain_between(at((0, 0, 5), (0, 10, 5)), at((0, 0, 0), (0, 10, 0))))
    world.remove(world.add(cube))  # 4
    before = world.contacts()
    assert {*before.bodies.ravel().tolist()} == {0, 1, 2, 3}
    changes: list[Callable[[], object]] = [
        lambda: world.move_many([2, 3, bad], at((50, 0, 0), (60, 0, 0), (70, 0, 0))),
        lambda: world.remove([0, bad]),
        lambda: world.set_enabled([0, 1, bad], False),
        lambda: world.set_may_touch([[0, 2], [1, bad]], False),
        lambda: world.set_may_touch([[0, 2], [bad, 1]], False),
    ]
    for change in changes:
        with pytest.raises(tamis.InvalidOptions, match=f"body {bad}"):
            change()
        assert world.contacts() == before
    with pytest.raises(tamis.InvalidOptions, match="bodies holds 0 twice"):
        world.remove([0, 1, 0])
    assert world.contacts() == before


def test_radii_and_steps_of_bodies_that_turn(cube: tamis.Shape) -> None:
    world = tamis.World()
    low, high = world.add_many(cube, at((0, 0, 0), (0, 0, 3)))
    world.move(high, tamis.interpolated_chain(at((0, 0, 3))[0], np.array([[0, 0, 2], [0, 0, 0.5]])))
    assert world.is_free()
    step = world.safe_step(0.6, tolerance=1e-6)
    assert step.pair is not None
    assert 0.79 < step.toi_lower < 0.81  # from the distance 2 down to 1.2
    world.set_radius([low, high], 0.75)
    assert abs(world.earliest().toi_lower - 0.5) < 1e-6
    for bad in (-1.0, float("nan")):
        with pytest.raises(tamis.InvalidOptions, match="radius"):
            world.set_radius([low, high], bad)
    with pytest.raises(tamis.InvalidOptions, match="no body 5"):
        world.set_radius([low, 5], 0)
    assert abs(world.earliest().toi_lower - 0.5) < 1e-6


def test_thousands_in_one_call(cube: tamis.Shape) -> None:
    """Bodies of a grid go up by less than the gap between them; then one row goes too far."""
    places = np.stack(np.meshgrid(*[np.arange(20) * 2.0] * 3), -1).reshape(-1, 3)
    still = tamis.pose_of(np.tile([1.0, 0, 0, 0], (8000, 1)), places)
    world = tamis.World()
    bodies = world.add_many(cube, still)
    assert world.is_free()
    up = tamis.pose_of(np.tile([1, 0, 0, 0], (8000, 1)).astype(np.float32), places + np.array([0, 0, 0.9]))
    world.move_many(bodies, tamis.chain_between(still, up))
    assert world.is_free()
    one = bodies[places[:, 2] == 0][:1]
    world.move_many(one, tamis.chain_between(still[one], at(places[one[0]] + np.array([0, 0, 2.5]))))
    assert {*world.contacts().bodies.ravel().tolist()} == {int(one[0]), int(one[0]) + 1}
