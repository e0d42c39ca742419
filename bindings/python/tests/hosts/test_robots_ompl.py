"""OMPL with Tamis's motion validator: every edge of every plan is proven, and a sampled plan that collides is not."""

from __future__ import annotations

import pathlib
from typing import Any

import numpy as np
import pytest
from conftest import CUBE, CUBE_FACES
from test_robots import ELBOW, LINKS, SHOULDER, Cube, joint

import tamis
from tamis import robots

pytest.importorskip("ompl", reason="ompl is not installed: bindings/python/requirements-hosts.txt")
from ompl import base as ob
from ompl import geometric as og
from ompl import util

from tamis.robots import ompl

pytestmark = pytest.mark.filterwarnings("default")
START, GOAL = [-0.9, 0.3], [0.9, -0.3]


@pytest.fixture(autouse=True)
def quiet() -> None:
    util.setLogLevel(util.LogLevel.LOG_ERROR)
    util.RNG.setSeed(7)


@pytest.fixture
def scene(tmp_path: pathlib.Path) -> robots.Scene:
    """Return an arm that must fold to pass between two posts."""
    path = tmp_path / "arm.urdf"
    path.write_text(f'<robot name="arm">{LINKS}{SHOULDER}{ELBOW}</robot>')
    made = robots.Scene(robots.load(path), threads=1)
    made.add("post", Cube(0.3, [1.9, 0, 0.2]))
    return made


@pytest.mark.parametrize("planner", [og.RRTConnect, og.PRM, og.BITstar, og.KPIECE1])
def test_every_edge_of_a_plan_is_proven(scene: robots.Scene, planner: Any) -> None:
    setup = ompl.simple_setup(scene)
    ompl.set_start_and_goal(setup, scene, START, GOAL)
    setup.setPlanner(planner(setup.getSpaceInformation()))
    assert not scene.is_free(START, GOAL)
    assert setup.solve(2.0 if planner is og.BITstar else 10.0) and setup.haveExactSolutionPath()
    ways = ompl.waypoints_of(setup.getSolutionPath(), scene)
    assert len(ways) > 2 and np.allclose(ways[[0, -1]], [START, GOAL])
    assert scene.first_bad_edge(ways).is_free
    setup.simplifySolution(0.2)
    assert scene.first_bad_edge(ompl.waypoints_of(setup.getSolutionPath(), scene)).is_free


def test_sampling_passes_what_the_proof_finds(scene: robots.Scene) -> None:
    """Would catch a validator that OMPL does not call: a sheet is thinner than the distance of two samples."""
    thin = CUBE * [0.3, 0.0001, 0.3] + [1.9, 0.3, 0.2]
    scene.add("sheet", tamis.Shape(tamis.Mesh(CUBE_FACES), thin))
    start, goal = [0.4, -0.2], [0.2, -0.2]
    setup = ompl.simple_setup(scene)
    information = setup.getSpaceInformation()
    proof = information.getMotionValidator()
    ompl.set_start_and_goal(setup, scene, start, goal)
    space = setup.getStateSpace()
    ends = ompl.state_of(start, scene, space), ompl.state_of(goal, scene, space)
    information.setStateValidityCheckingResolution(0.05)
    setup.setup()
    assert not proof.checkMotion(*ends)
    assert ob.DiscreteMotionValidator(information).checkMotion(*ends)


def test_a_continuous_joint_goes_the_shorter_way(tmp_path: pathlib.Path) -> None:
    path = tmp_path / "arm.urdf"
    path.write_text(f'<robot name="arm">{LINKS}{joint("spin", "base", "upper", "", "continuous")}{ELBOW}</robot>')
    scene = robots.Scene(robots.load(path), threads=1)
    scene.add("post", Cube(0.3, [1.4, 0.1, 0.0]))  # in the longer way
    setup = ompl.simple_setup(scene)
    space = setup.getStateSpace()
    states = [ompl.state_of(q, scene, space) for q in ([3.0, 1.0], [-3.0, 1.0])]
    assert [ompl.configuration_of(state, scene).tolist() for state in states] == [[3.0, 1.0], [-3.0, 1.0]]
    assert setup.getSpaceInformation().getMotionValidator().checkMotion(*states)
    assert not scene.is_free([3.0, 1.0], [-3.0, 1.0], whole_turns=True)
    ompl.set_start_and_goal(setup, scene, [3.0, 1.0], [-3.0, 1.0])
    setup.setPlanner(og.RRTConnect(setup.getSpaceInformation()))
    assert setup.solve(5.0)
    assert scene.first_bad_edge(ompl.waypoints_of(setup.getSolutionPath(), scene)).is_free


def test_a_start_that_overlaps_is_named(scene: robots.Scene) -> None:
    setup = ompl.simple_setup(scene)
    with pytest.raises(tamis.InvalidStep, match="'lower' and 'post' overlap at this configuration"):
        ompl.set_start_and_goal(setup, scene, [0, 0], GOAL)
