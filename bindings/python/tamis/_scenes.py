"""Scenes that Tamis generates or simulates, for examples, tests and benchmarks."""

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
    """A mesh and one step of its motion.

    Attributes
    ----------
    mesh : Mesh
        The topology.
    start, end : array of float64, shape (n, 3)
        Where each vertex is at the start and at the end of the step.
    groups : array of int32, shape (n,)
        The object that each vertex belongs to, >= 0; `Detector` takes them as `groups`.
    """

    mesh: Mesh
    start: Doubles
    end: Doubles
    groups: Indices


def scene(name: str, triangles: int = 1000, seed: int = 1) -> Scene:
    """Generate one of the scenes of `tamis bench --scene`.

    Parameters
    ----------
    name : str
        One of `scene_names()`.
    triangles : int
        The approximate number of triangles, >= 1.
    seed : int
        >= 0. The same seed makes the same scene on every machine.

    Returns
    -------
    Scene
        Topology and one step.

    Raises
    ------
    InvalidOptions
        No scene has this name, or a number is out of range.
    """
    start, end, faces, edges, points, groups = _core.scene(
        word(name, "name"), whole(triangles, "triangles", 1), whole(seed, "seed")
    )
    return Scene(Mesh(faces, len(start), edges, points), start, end, groups)


def simulate(
    name: str, folder: str | os.PathLike[str], triangles: int | None = None, frames: int | None = None, seed: int = 1
) -> Iterator[MeshFile]:
    """Simulate one of the scenes of `tamis scene` into a folder; return its frames, which are read one after the other.

    Every frame is free of intersections. Ctrl-C ends the simulation after a frame; the same call continues from there.

    Parameters
    ----------
    name : str
        One of `simulated_scenes()`.
    folder : path_like
        The folder for frame_0000.ply, frame_0001.ply, ...; created if it does not exist.
    triangles : int, optional
        The approximate number of triangles, obstacles included, >= 500; by default the full size, which takes hours.
    frames : int, optional
        The number of frames after the first, >= 0; by default the whole scene.
    seed : int
        >= 0: the seed of the small disorder at the start.

    Yields
    ------
    MeshFile
        One frame. All frames share one `Mesh`.

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
    """Return the scenes of `simulate`: for each name, a description."""
    return _core.simulated_scenes()


def scene_names() -> dict[str, str]:
    """Return the scenes of `scene`: for each name, a description."""
    return _core.scene_names()
