"""Mesh files and frames, as the command reads and writes them."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import Doubles, finite, indices, indices_or_none, packed_rows
from tamis._checks import file_name
from tamis._errors import FileError, InvalidMesh
from tamis._mesh import Mesh


class MeshFile(NamedTuple):
    """One frame: positions (n, 3), the mesh, and what a reader should know (polygons cut, elements skipped)."""

    positions: Doubles
    mesh: Mesh
    notes: tuple[str, ...]


def read_mesh(path: str | os.PathLike[str]) -> MeshFile:
    """Read a PLY or OBJ file; polygons are cut into fans.

    Parameters
    ----------
    path : path_like
        Told apart by content, then by extension.

    Returns
    -------
    MeshFile
        Doubles as they stand in the file.

    Raises
    ------
    FileError
        The file cannot be used; the message says where and why.
    """
    positions, faces, edges, points, notes = _core.read_mesh(file_name(path, "path"))
    return MeshFile(positions, Mesh(faces, len(positions), edges, points), tuple(notes))


def write_mesh(
    path: str | os.PathLike[str],
    positions: npt.ArrayLike,
    faces: npt.ArrayLike,
    edges: npt.ArrayLike | None = None,
    points: npt.ArrayLike | None = None,
) -> None:
    """Write a binary PLY file in doubles: complete or not at all.

    Parameters
    ----------
    path : path_like
        Of the file, ending in ``.ply``; an existing one is replaced.
    positions : array_like, shape (n, 3)
        One row a vertex.
    faces : array_like of int, shape (f, 3)
        Triangles.
    edges : array_like of int, shape (e, 2), optional
        Loose edges: rods.
    points : array_like of int, shape (p,), optional
        Loose points. PLY itself has none: other programs skip them, or show all vertices.

    Raises
    ------
    FileError
        The file cannot be written, or has another ending.
    InvalidMesh
        An index that is no row of the positions, a coordinate that is not finite, or an array of another shape or type.
    """
    vertices = finite(packed_rows(positions, "positions", InvalidMesh), "positions", InvalidMesh)
    triangles, rods = indices(faces, 3, "faces", InvalidMesh), indices_or_none(edges, 2, "edges", InvalidMesh)
    loose = indices_or_none(points, 0, "points", InvalidMesh)
    if triangles.size or rods.size or loose.size:
        Mesh(triangles, len(vertices), rods, loose)  # refuses indices out of range
    name = file_name(path, "path")
    if not str(name).lower().endswith(".ply"):
        raise FileError(f"{name}: meshes are written as PLY alone: give a name that ends in .ply")
    _core.write_mesh(name, vertices, triangles, rods, loose)


def read_frames(*names: str | os.PathLike[str]) -> Iterator[MeshFile]:
    """Read the frames of an animation one after the other.

    Parameters
    ----------
    *names : path_like
        Files, folders and glob patterns, all together in natural order: f2 before f10.

    Yields
    ------
    MeshFile
        One frame. All share the `Mesh` of the first.

    Raises
    ------
    FileError
        A name stands for no file, a file cannot be used, or a frame has another topology than the first.
    """
    paths = _core.frame_files([file_name(name, f"names[{i}]") for i, name in enumerate(names)])
    return _frames(paths)


def _frames(paths: list[str]) -> Iterator[MeshFile]:
    first: Mesh | None = None
    for path in paths:
        frame = read_mesh(path)
        if first is None:
            first = frame.mesh
        if not _same(first, frame.mesh):
            raise FileError(f"{path}: its topology is not that of {paths[0]}: give frames of one mesh")
        yield frame._replace(mesh=first)


def _same(a: Mesh, b: Mesh) -> bool:
    return a.vertex_count == b.vertex_count and all(
        np.array_equal(x, y)
        for x, y in ((a.faces, b.faces), (a.loose_edges, b.loose_edges), (a.loose_points, b.loose_points))
    )
