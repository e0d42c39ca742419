"""Scenes that Tamis makes itself: for examples, tests and benchmarks."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import NamedTuple

from tamis import _core
from tamis._arrays import Doubles, Indices
from tamis._checks import file_name, whole, word
from tamis._files import MeshFile, read_frames
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
    start, end, faces, edges, points, groups = _core.scene(
        word(name, "name"), whole(triangles, "triangles", 1), whole(seed, "seed")
    )
    return Scene(Mesh(faces, len(start), edges, points), start, end, groups)


def simulate(
    name: str, folder: str | os.PathLike[str], triangles: int | None = None, frames: int | None = None, seed: int = 1
) -> Iterator[MeshFile]:
    """Simulate one of the scenes of `tamis scene` into a folder, and read its frames one after the other.

    Every frame is free of intersections. Ctrl-C ends it after a frame; the same call goes on from there.

    Parameters
    ----------
    name : str
        One of `simulated_scenes()`.
    folder : path_like
        Where frame_0000.ply, frame_0001.ply, ... go; made if it is not there.
    triangles : int, optional
        About so many, obstacles included, at least 500; by default the scene's full size, for which it takes hours.
    frames : int, optional
        After the first; by default the whole scene.
    seed : int
        Of the small disorder at the start.

    Yields
    ------
    MeshFile
        One frame. All share one `Mesh`.

    Raises
    ------
    InvalidOptions
        No scene has this name, or a number is out of range.
    Error
        The folder holds another run, or a file that the scene needs is missing.
    """
    count = None if triangles is None else whole(triangles, "triangles", 500)
    most = None if frames is None else whole(frames, "frames")
    place = file_name(folder, "folder")
    last = _core.simulate(word(name, "name"), place, count, most, whole(seed, "seed"))
    return read_frames(*(_core.frame_path(place, frame) for frame in range(last + 1)))


def simulated_scenes() -> dict[str, str]:
    """Return the name of every scene of the simulator, and what it shows."""
    return _core.simulated_scenes()


def scene_names() -> dict[str, str]:
    """Return the name of every scene, and what it shows."""
    return _core.scene_names()
