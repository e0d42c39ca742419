"""A planner's questions about edges between configurations of a linkage."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
from conftest import at

import tamis

NOWHERE = np.zeros((1, 2, 3))


@pytest.fixture
def arm(cube: tamis.Shape) -> tuple[tamis.World, tamis.Linkage]:
    """Return a world of a cube at x = 0, and a cube that slides along x, or turns about the z axis at its place."""
    world = tamis.World(threads=2)
    world.add_many(cube, at((0, 0, 0)))
    body = world.add(cube)
    places = np.concatenate([NOWHERE, NOWHERE])
    axes = [[1, 0, 0], [0, 0, 2]]
    return world, tamis.Linkage([-1, 0], places, ["sliding", "turning"], axes, [0, 1], [body], [1])


def test_edges_have_the_answers_of_plain_questions(arm: tuple[tamis.World, tamis.Linkage]) -> None:
    """Would catch rows of other edges, and bodies that do not go back."""
    world, linkage = arm
    rng = np.random.default_rng(4)
    starts, ends = rng.uniform([-3, -2], [3, 2], (2, 60, 2))
    free = world.edges_are_free(linkage, starts, ends)
    answers = world.last_valid(linkage, starts, ends)
    assert free.dtype == bool
    assert 0 < free.sum() < 60
    assert (answers.is_free == free).all()
    assert str(answers) == f"EdgeAnswers(60 edges, {int((~free).sum())} of them not free)"
    assert (world.configurations_are_free(linkage, starts) == ~answers.overlaps_at_start).all()
    contacts = dict(zip(answers.touching.tolist(), answers.contacts))
    chains = linkage.motions(starts, ends)
    assert chains.shape == (60, 1, 2, 4, 3)
    for i in range(60):
        world.move_many(linkage.bodies, chains[i])
        assert bool(free[i]) == (not world.has_overlap() and world.is_free())
        assert bool(answers.overlaps_at_start[i]) == world.has_overlap()
        if i in contacts:
            first = world.earliest()
            assert abs(first.toi_lower - answers.fraction[i]) <= 1e-9
            assert tuple(answers.bodies[i].tolist()) == contacts[i].bodies
            assert np.isfinite(answers.points[i]).all()
        else:
            assert np.isnan(answers.points[i]).all()
    known = world.edges_are_free(linkage, starts, ends, True)
    assert (known[~answers.overlaps_at_start] == free[~answers.overlaps_at_start]).all()


def test_a_clearance_counts_along_the_whole_edge(arm: tuple[tamis.World, tamis.Linkage]) -> None:
    world, linkage = arm
    edge = [[1.25, 0]], [[3, 0]]
    assert world.edges_are_free(linkage, *edge).all()
    assert not world.edges_are_free(linkage, *edge, min_separation=0.3).any()
    assert not world.configurations_are_free(linkage, edge[0], min_separation=0.3).any()
    assert world.edges_are_free(linkage, *edge, min_separation=0.2).all()


def test_trajectories_and_roadmaps(arm: tuple[tamis.World, tamis.Linkage]) -> None:
    world, linkage = arm
    free = world.first_bad_edge(linkage, [[3, 0], [2, 1], [4, 2]])
    assert free.is_free and free.contact is None and free.fraction == 1
    bad = world.first_bad_edge(linkage, [[3.0, 0.0], [2.0, 0.0], [-2.0, 0.0], [-3.0, 0.0]])
    assert bad.edge == 1 and not bad.is_free
    assert abs(bad.fraction - 0.25) < 1e-8
    assert bad.bodies is not None and set(bad.bodies) == {0, 1}
    assert bad.point is not None and abs(bad.point[0] - 0.5) < 1e-8
    inside = world.first_bad_edge(linkage, [[0.0, 0.1], [3.0, 0.0]])
    assert inside.edge == 0 and inside.overlaps_at_start and inside.bodies == (0, 1) and inside.point is None
    nodes = [[3.0, 0.0], [2.0, 0.0], [-2.0, 0.0], [0.0, 0.1]]
    found = world.roadmap(linkage, nodes, [[0, 1], [1, 2], [2, 3]])
    assert found.configurations_are_free.tolist() == [True, True, True, False]
    assert found.edges_are_free.tolist() == [True, False, False]


def test_linkages_are_pickled_and_described(arm: tuple[tamis.World, tamis.Linkage]) -> None:
    _, linkage = arm
    assert repr(linkage) == "Linkage(2 joints, 1 bodies, dimension 2)"
    again = pickle.loads(pickle.dumps(linkage))
    assert (again.motions([1, 2], [3, 4]) == linkage.motions([1, 2], [3, 4])).all()
    assert linkage.motions([1, 2], [3, 4]).shape == (1, 2, 4, 3)


def test_edges_that_do_not_fit(arm: tuple[tamis.World, tamis.Linkage]) -> None:
    world, linkage = arm
    one = np.zeros((1, 2))
    with pytest.raises(tamis.InvalidPath, match=r"starts has the shape \(1, 3\): give \(n, 2\)"):
        world.edges_are_free(linkage, np.zeros((1, 3)), one)
    with pytest.raises(tamis.InvalidPath, match="starts has 1 rows, ends 2"):
        world.edges_are_free(linkage, one, np.zeros((2, 2)))
    with pytest.raises(tamis.InvalidPath, match=r"give rows, \(1, d\)"):
        world.edges_are_free(linkage, [0, 0], [0, 0])
    with pytest.raises(tamis.InvalidPath, match=r"ends holds a number that is not finite, at \[0, \d\]: "):
        world.last_valid(linkage, one, one + np.inf)
    with pytest.raises(tamis.InvalidOptions, match="two or more"):
        world.first_bad_edge(linkage, one)
    with pytest.raises(tamis.InvalidOptions, match="edge 0 names the configuration 5"):
        world.roadmap(linkage, one, [[0, 5]])
    with pytest.raises(tamis.InvalidStep, match="edge 0: body 1 turns by 5000 radians"):
        world.edges_are_free(linkage, one, [[0, 5000]])
    with pytest.raises(tamis.InvalidOptions, match="no body 7"):
        world.edges_are_free(tamis.Linkage([-1], NOWHERE, ["turning"], [[0, 0, 1]], [0], [7], [0]), [[0]], [[1]])
    with pytest.raises(tamis.InvalidOptions, match="kinds holds 'screw'"):
        tamis.Linkage([-1], NOWHERE, ["screw"], [[0, 0, 1]], [0], [1], [0])  # type: ignore[list-item]
    with pytest.raises(tamis.InvalidOptions, match="axes has 2 entries, and there are 1 joints"):
        tamis.Linkage([-1], NOWHERE, ["turning"], np.ones((2, 3)), [0], [1], [0])
    with pytest.raises(tamis.InvalidOptions, match="joint 0 has the parent 0"):
        tamis.Linkage([0], NOWHERE, ["turning"], [[0, 0, 1]], [0], [1], [0])
