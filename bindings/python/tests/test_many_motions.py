"""The first contact for each of many motions, as a planner asks."""

from __future__ import annotations

import numpy as np
import pytest
from conftest import at

import tamis


def test_many_motions_have_the_answers_that_they_have_alone(cube: tamis.Shape) -> None:
    """Would catch bodies that another motion has moved, or an answer at the wrong motion."""
    world = tamis.World(threads=2)
    world.add_many(cube, at((0, 0, 0), (4, 0, 0)))
    arm = world.add_many(cube, at((0, 5, 0), (4, 5, 0)))
    rng = np.random.default_rng(5)
    start = at((0, 5, 0), (4, 5, 0)) + rng.uniform(-1, 1, (40, 2, 2, 3))
    end = start + rng.uniform(-1, 1, (40, 2, 2, 3)) + [[0, -2.5, 0], [0, 0, 0]]
    motions = tamis.interpolated_chain(start.reshape(-1, 2, 3), end.reshape(-1, 2, 3)).reshape(40, 2, 1, 4, 3)
    found = world.earliest_many(arm, motions)
    assert world.is_free()  # the bodies still have their own motions
    assert found.toi_lower.shape == found.toi_upper.shape == found.is_free.shape == (40,)
    assert 0 < found.is_free.sum() < 40
    assert len(found.contacts) == len(found.touching)
    assert str(found) == f"EarliestMany(40 motions, {len(found.touching)} of them not free)"  # would catch 500 lines
    contacts = dict(zip(found.touching.tolist(), found.contacts, strict=True))
    for i, motion in enumerate(motions):
        world.move_many(arm, motion)
        alone = world.earliest()
        assert (alone.toi_lower, alone.toi_upper) == (found.toi_lower[i], found.toi_upper[i])
        assert alone.contact == contacts.get(i)
        assert bool(found.is_free[i]) == world.is_free()


def test_many_motions_that_do_not_fit(cube: tamis.Shape) -> None:
    world = tamis.World()
    places = at((0, 0, 0), (4, 0, 0))
    bodies = world.add_many(cube, places)
    motions = np.broadcast_to(tamis.chain_between(places, places), (3, 2, 2, 4, 3))
    assert world.earliest_many(bodies, motions).is_free.all()
    assert len(world.earliest_many(bodies, motions[:0]).toi_lower) == 0
    assert not world.earliest_many(
        bodies, motions[:, :, :0]
    ).is_free.any()  # without links both are where their shape is
    with pytest.raises(tamis.InvalidPath, match=r"give \(n, 1, links, 4, 3\)"):
        world.earliest_many(bodies[:1], motions)
    with pytest.raises(tamis.InvalidOptions, match="body 1 is named twice: give each once"):
        world.earliest_many([1, 1], motions)
    with pytest.raises(tamis.InvalidOptions, match="bodies is empty"):
        world.earliest_many([], motions[:, :0])
    with pytest.raises(tamis.InvalidOptions, match="no body 7"):
        world.earliest_many([0, 7], motions)
    with pytest.raises(tamis.InvalidPath, match="motions"):
        world.earliest_many(bodies, np.where(motions == 0, np.nan, motions))
