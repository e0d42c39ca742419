"""OMPL: plans whose every edge is proven. Needs the package ompl, 2.0.

>>> setup = tamis.robots.ompl.simple_setup(scene)
>>> tamis.robots.ompl.set_start_and_goal(setup, scene, start, goal)
>>> setup.solve(5.0)
>>> waypoints = tamis.robots.ompl.waypoints_of(setup.getSolutionPath(), scene)
>>> scene.first_bad_edge(waypoints).is_free
True
"""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles
from tamis._checks import instance
from tamis._versions import needed
from tamis.robots._scene import Scene

with needed("ompl", "tamis.robots.ompl"):
    from ompl import base as ob
    from ompl import geometric as og

__all__ = [
    "MotionValidator",
    "configuration_of",
    "set_start_and_goal",
    "simple_setup",
    "space_of",
    "state_of",
    "waypoints_of",
]


class MotionValidator(ob.MotionValidator):  # type: ignore[misc]
    """Proves motions free. It tests the edges of `Scene.is_free`. Each joint goes at constant speed.

    As OMPL has it, the start of a motion is valid already: `simple_setup` tests states by `Scene.is_valid`.

    Parameters
    ----------
    information : ompl.base.SpaceInformation
        Of a space that `space_of` has made.
    scene : tamis.robots.Scene
        The robots and obstacles.
    """

    def __init__(self, information: Any, scene: Scene) -> None:
        super().__init__(information)
        self._scene = instance(scene, Scene, "scene", "a tamis.robots.Scene")

    def checkMotion(self, start: Any, end: Any) -> bool:  # noqa: N802 (OMPL's name)
        """Tell whether a motion is free of contacts, proven. OMPL's planners call it."""
        first, last = configuration_of(start, self._scene), configuration_of(end, self._scene)
        free: bool = self._scene.is_free(first, self._scene.shorter_way(first, last), starts_are_valid=True)
        return free


def space_of(scene: Scene) -> Any:
    """Make the space of a scene's configurations: limited joints as real numbers, continuous ones as SO(2).

    Parameters
    ----------
    scene : tamis.robots.Scene
        The robots, whose joints but the continuous ones have limits.

    Returns
    -------
    ompl.base.StateSpace
        A RealVectorStateSpace if no joint is continuous, else a CompoundStateSpace.
    """
    limits, turning = instance(scene, Scene, "scene", "a tamis.robots.Scene").limits, scene.is_continuous
    limited = ob.RealVectorStateSpace(int((~turning).sum()))
    bounds = ob.RealVectorBounds(int((~turning).sum()))
    for i, (low, high) in enumerate(limits[~turning]):
        bounds.setLow(i, low)
        bounds.setHigh(i, high)
    limited.setBounds(bounds)
    if not turning.any():
        return limited
    space = ob.CompoundStateSpace()
    if not turning.all():
        space.addSubspace(limited, 1.0)
    for _ in range(int(turning.sum())):
        space.addSubspace(ob.SO2StateSpace(), 1.0)
    return space


def configuration_of(state: Any, scene: Scene) -> Doubles:
    """Return the configuration of a state of `space_of`.

    Parameters
    ----------
    state : ompl.base.State
        A state.
    scene : tamis.robots.Scene
        The scene of the space.

    Returns
    -------
    array of float64, shape (d,)
        One number for each of the scene's joints.
    """
    turning = scene.is_continuous
    if not turning.any():
        return np.array(state[0 : len(turning)])
    found = np.empty(len(turning))
    after = 0 if turning.all() else 1
    if after:
        found[~turning] = state[0][0 : int((~turning).sum())]
    found[turning] = [state[after + i].value for i in range(int(turning.sum()))]
    return found


def state_of(configuration: npt.ArrayLike, scene: Scene, space: Any) -> Any:
    """Return a new state of `space_of` with the numbers of a configuration, turns reduced to [-pi, pi].

    Parameters
    ----------
    configuration : array_like, shape (d,)
        One number for each of the scene's joints.
    scene : tamis.robots.Scene
        The scene of the space.
    space : ompl.base.StateSpace
        The space.

    Returns
    -------
    ompl.base.State
        The state.
    """
    values = scene.shorter_way(configuration, configuration)
    state, turning = space.allocState(), scene.is_continuous
    limited = state if not turning.any() else state[0]
    if not turning.all():
        for i, value in enumerate(values[~turning]):
            limited[i] = float(value)
    after = 0 if turning.all() else 1
    for i, value in enumerate(values[turning]):
        state[after + i].value = float(np.remainder(value + np.pi, 2 * np.pi) - np.pi)
    return state


def simple_setup(scene: Scene) -> Any:
    """Make OMPL's SimpleSetup for a scene: states are tested by `Scene.is_valid`, motions by `MotionValidator`.

    Parameters
    ----------
    scene : tamis.robots.Scene
        The robots and obstacles.

    Returns
    -------
    ompl.geometric.SimpleSetup
        Give it start and goal by `set_start_and_goal`, and a planner by its `setPlanner`.
    """
    setup = og.SimpleSetup(space_of(scene))
    information = setup.getSpaceInformation()
    information.setMotionValidator(MotionValidator(information, scene))
    setup.setStateValidityChecker(lambda state: bool(scene.is_valid(configuration_of(state, scene))))
    return setup


def set_start_and_goal(setup: Any, scene: Scene, start: npt.ArrayLike, goal: npt.ArrayLike) -> None:
    """Set both ends of the plan.

    Parameters
    ----------
    setup : ompl.geometric.SimpleSetup
        As `simple_setup` makes it.
    scene : tamis.robots.Scene
        Its scene.
    start, goal : array_like, shape (d,)
        Configurations.

    Raises
    ------
    InvalidStep
        Something overlaps at the start or at the goal. The message names it.
    InvalidPath
        A joint beyond its limits, or another shape.
    """
    scene.check(start)
    scene.check(goal)
    space = setup.getStateSpace()
    setup.setStartAndGoalStates(state_of(start, scene, space), state_of(goal, scene, space))


def waypoints_of(path: Any, scene: Scene) -> Doubles:
    """Return the configurations of a path, with continuous joints going the shorter way from one to the next.

    Parameters
    ----------
    path : ompl.geometric.PathGeometric
        Such as ``setup.getSolutionPath()``.
    scene : tamis.robots.Scene
        The scene of its space.

    Returns
    -------
    array of float64, shape (n, d)
        The waypoints, as `Scene.first_bad_edge` takes them.
    """
    found = [configuration_of(state, scene) for state in path.getStates()]
    for i in range(1, len(found)):
        found[i] = scene.shorter_way(found[i - 1], found[i])
    return np.array(found).reshape(-1, len(scene.joints))
