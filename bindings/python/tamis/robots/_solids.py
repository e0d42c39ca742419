"""Triangles of links and obstacles: mesh files by trimesh, triangles around primitives."""

from __future__ import annotations

import os
import pathlib
from collections.abc import Iterable
from typing import Any

import numpy as np

from tamis import _primitives
from tamis._arrays import Doubles, Indices
from tamis._errors import FileError, InvalidMesh
from tamis._mesh import Mesh
from tamis._versions import needed
from tamis._world._bodies import Shape
from tamis.robots._frames import moved
from tamis.robots._urdf import FileLink, Solid

Triangles = tuple[Doubles, Indices]


class MeshFiles:
    """Finds and reads the mesh files that a URDF file names. Each file is read once."""

    def __init__(self, urdf: str, package_dirs: Iterable[str | os.PathLike[str]]) -> None:
        self._urdf, self._folder = urdf, pathlib.Path(urdf).resolve().parent
        self._packages = [pathlib.Path(folder) for folder in package_dirs]
        self._read: dict[pathlib.Path, Triangles] = {}

    def triangles(self, name: str, link: str) -> Triangles:
        """Return points and triangles of a file that a link names."""
        path = self._find(name, link)
        if path not in self._read:
            self._read[path] = _load(path, f"{self._urdf}: link {link!r}")
        return self._read[path]

    def _find(self, name: str, link: str) -> pathlib.Path:
        places = self._places(name)
        for place in places:
            if place.is_file():
                return place
        raise FileError(
            f"{self._urdf}: link {link!r} names the mesh {name!r}, which is not there: {places[0]}"
            f"{' nor elsewhere' if len(places) > 1 else ''}; put it there, or name the folder of its package by "
            "package_dirs"
        )

    def _places(self, name: str) -> list[pathlib.Path]:
        """Return where a file may be. A package is a folder of that name in `package_dirs`, or around the URDF file."""
        scheme, parted, rest = name.partition("://")
        if not parted:
            return [self._folder / name]
        if scheme == "package":
            around = [*self._packages, self._folder, *self._folder.parents]
            return [folder / rest for folder in around]
        return [pathlib.Path(rest)]


def _load(path: pathlib.Path, where: str) -> Triangles:
    with needed("trimesh", "tamis.robots"):
        import trimesh
    try:
        read: Any = trimesh.load(str(path), process=False)
        mesh: Any = read.to_geometry() if isinstance(read, trimesh.Scene) else read
        points, faces = np.array(mesh.vertices, float), np.array(mesh.faces, np.int32)
    except Exception as error:  # of any of trimesh's readers
        raise FileError(
            f"{where}: {path} cannot be read as a mesh ({type(error).__name__}: {error}): mend it, or save it as STL"
        ) from None
    if not len(faces) or not np.isfinite(points).all():
        fault = "has a point that is not finite" if len(faces) else "has no triangle"
        raise FileError(f"{where}: {path} {fault}: save the mesh again")
    return points * _unit(path, mesh, where), faces


def _unit(path: pathlib.Path, mesh: Any, where: str) -> float:
    """Return how many metres the unit of a Collada file is; other formats are in metres, as URDF has it."""
    if path.suffix.lower() != ".dae":
        return 1.0
    if b"Z_UP" not in path.read_bytes():
        raise FileError(
            f"{where}: {path} does not say <up_axis>Z_UP</up_axis>, and programs read such files in different ways: "
            "save it so, or as STL"
        )
    said = str(mesh.metadata.get("units", mesh.units or "meters"))
    return 1.0 if said in ("meters", "meter", "m") else float(said.split()[0])


def link_triangles(link: FileLink, files: MeshFiles, tolerance: float) -> Triangles | None:
    """Return all solids of a link as one mesh in its frame, or None if it has none."""
    parts = [_placed_triangles(solid, link.name, files, tolerance) for solid in link.solids]
    if not parts:
        return None
    first = np.cumsum([0, *(len(points) for points, _ in parts)])
    return np.vstack([p for p, _ in parts]), np.vstack([f + np.int32(n) for (_, f), n in zip(parts, first)])


def _placed_triangles(solid: Solid, link: str, files: MeshFiles, tolerance: float) -> Triangles:
    if solid.kind != "mesh":
        points, faces = around(solid.kind, solid.size, tolerance)
        return moved(points, solid.place), faces
    points, faces = files.triangles(solid.file, link)
    # A mirrored solid is inside out until its faces go around the other way.
    mirrored = faces[:, ::-1] if np.prod(solid.size) < 0 else faces
    return moved(points * solid.size, solid.place), mirrored


def around(kind: str, size: Doubles, tolerance: float) -> Triangles:
    """Return triangles around a primitive, nowhere farther from it than the tolerance."""
    if kind == "box":
        shape = _primitives.box(size / 2)
    elif kind == "cylinder":
        shape = _primitives.cylinder(size[0], size[1] / 2, tolerance)
    else:
        shape = _primitives.capsule(size[0], size[1] / 2 if kind == "capsule" else 0.0, tolerance)
    return shape.points, shape.faces


def welded(triangles: Triangles) -> Shape:
    """Return a shape whose vertices at one place are one. Triangles without three corners become edges."""
    places, number = np.unique(triangles[0] + 0.0, axis=0, return_inverse=True)
    faces = number.reshape(-1)[triangles[1]]
    flat = (faces == np.roll(faces, 1, 1)).any(1)
    edges = faces[flat][:, [0, 1, 1, 2]].reshape(-1, 2)
    return Shape(Mesh(faces[~flat], len(places), edges[edges[:, 0] != edges[:, 1]]), places)


def shape_of(body: Any, name: str) -> Shape:
    """Return a tamis.Shape of one, or of an object with `vertices` and `faces`, such as a trimesh.Trimesh."""
    if isinstance(body, Shape):
        return body
    if not hasattr(body, "vertices") or not hasattr(body, "faces"):
        raise InvalidMesh(f"{name} is of the type {type(body).__name__}: give a tamis.Shape or a trimesh.Trimesh")
    return welded((np.array(body.vertices, float), np.array(body.faces, np.int32)))
