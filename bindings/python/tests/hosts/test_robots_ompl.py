"""OMPL with Tamis's motion validator: every edge of every plan is proven, and a sampled plan that collides is not."""

from __future__ import annotations

import pathlib
import subprocess
import sys
from typing import Any

import numpy as np
import pytest
import test_docs
from test_robots import ELBOW, LINKS, SHOULDER, Cube, joint

import tamis
from tamis import robots

pytest.importorskip("ompl", reason="ompl is not installed: bindings/python/requirements-hosts.txt")

from ompl import geometric as og
from ompl import util

from tamis.robots import ompl

pytestmark = pytest.mark.filterwarnings("default")
START, GOAL = [-0.9, 0.3], [0.9, -0.3]


@pytest.fixture(autouse=True)
def quiet() -> None:
    util.setLogLevel(util.LogLevel.LOG_ERROR)


@pytest.fixture
def scene(tmp_path: pathlib.Path) -> robots.Scene:
    """Return an arm that must fold to pass a post."""
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
    """Would catch a validator that OMPL does not call: the rod is thinner than the way between two samples."""
    thin = robots.Scene(*scene.robots, threads=1)
    thin.add("rod", Cube(0.05, [1.9, 0, 0.2]))
    for setup, passes in ((sampled(thin), True), (ompl.simple_setup(thin), False)):
        ompl.set_start_and_goal(setup, thin, [-0.5, 0], [0.5, 0])
        information = setup.getSpaceInformation()
        information.setStateValidityCheckingResolution(0.05)
        setup.setup()
        ends = [ompl.state_of(q, thin, setup.getStateSpace()) for q in ([-0.5, 0], [0.5, 0])]
        assert information.checkMotion(*ends) is passes


def sampled(scene: robots.Scene) -> Any:
    """Return a setup whose motions OMPL samples."""
    setup = og.SimpleSetup(ompl.space_of(scene))
    setup.setStateValidityChecker(lambda state: bool(scene.is_valid(ompl.configuration_of(state, scene))))
    return setup


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


def test_the_page_for_planners() -> None:
    """Every block of the page runs, and prints what the page says."""
    trimesh = pytest.importorskip("trimesh", reason="trimesh is not installed: bindings/python/requirements-hosts.txt")
    data = pathlib.Path(trimesh.__file__).parents[1] / "cmeel.prefix/share/example-robot-data"
    if not data.is_dir():
        pytest.skip("example-robot-data is not installed: bindings/python/requirements-hosts.txt")
    test_docs.test_page("docs/planners.md")
    folder = test_docs.ROOT / "examples/assembly"
    printed = subprocess.run(
        [sys.executable, str(folder / "insertion.py")], check=True, capture_output=True, text=True
    ).stdout
    assert printed == (folder / "insertion.py.txt").read_text()
