"""Scenes that Tamis makes itself: for examples, tests and benchmarks."""

from __future__ import annotations

from typing import NamedTuple

from tamis import _core
from tamis._arrays import Doubles, Indices
from tamis._mesh import Mesh


class Scene(NamedTuple):
    """A moving mesh: positions at the start and the end of a step, (n, 3), and the object of each vertex, (n,)."""

    mesh: Mesh
    start: Doubles
    end: Doubles
    groups: Indices


def scene(name: str, triangles: int = 1000, seed: int = 1) -> Scene:
    """Make one of the scenes that `tamis bench --scene` knows.

    Parameters
    ----------
    name : str
        One of `scene_names()`.
    triangles : int
        About so many.
    seed : int
        The same seed makes the same scene on every machine.

    Returns
    -------
    Scene
        Topology and one step.

    Raises
    ------
    InvalidOptions
        No scene has this name, or less than one triangle is asked for.
    """
    start, end, faces, edges, points, groups = _core.scene(name, triangles, seed)
    return Scene(Mesh(faces, len(start), edges, points), start, end, groups)


def scene_names() -> dict[str, str]:
    """Return the name of every scene, and what it shows."""
    return _core.scene_names()
