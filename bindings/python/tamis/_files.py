"""Mesh files and sequences of frames, in the formats of the command."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import NamedTuple

import numpy.typing as npt

from tamis import _core
from tamis._arrays import Doubles, Indices, finite, indices, indices_or_none, packed_rows
from tamis._checks import file_name
from tamis._errors import FileError, InvalidMesh
from tamis._mesh import Mesh


class MeshFile(NamedTuple):
    """The content of a mesh file: one frame.

    Attributes
    ----------
    positions : array of float64, shape (n, 3)
        One row a vertex.
    mesh : Mesh
        The topology.
    notes : tuple of str
        Notes about the file: polygons that were cut, elements that were skipped.
    """

    positions: Doubles
    mesh: Mesh
    notes: tuple[str, ...]


def read_mesh(path: str | os.PathLike[str]) -> MeshFile:
    """Read a mesh file (docs/files-and-command.md, "Mesh files"); polygons are cut into triangles.

    Parameters
    ----------
    path : path_like
        The format is recognized by content, then by extension.

    Returns
    -------
    MeshFile
        Its positions are the numbers of the file, as doubles.

    Raises
    ------
    FileError
        The file cannot be used; the message says where in it, and why.
    """
    return _mesh_file(_core.read_mesh(file_name(path, "path")))


def write_mesh(
    path: str | os.PathLike[str],
    positions: npt.ArrayLike,
    faces: npt.ArrayLike,
    edges: npt.ArrayLike | None = None,
    points: npt.ArrayLike | None = None,
) -> None:
    """Write a binary PLY file in doubles. If that fails, no file is left, and an existing one stays as it was.

    Parameters
    ----------
    path : path_like
        The file's name, which ends in ``.ply``. An existing file is replaced.
    positions : array_like, shape (n, 3)
        One row a vertex.
    faces : array_like of int, shape (f, 3)
        Vertex indices of each triangle.
    edges : array_like of int, shape (e, 2), optional
        Loose edges: rods.
    points : array_like of int, shape (p,), optional
        Loose points. PLY itself has none: other programs skip them, or show all vertices.

    Raises
    ------
    FileError
        The file cannot be written, or its name has another ending.
    InvalidMesh
        An index that is not a row of the positions, a coordinate that is not finite, or an array of another shape or
        type.
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
        Files, folders and glob patterns. All their files are sorted together in natural order: f2 before f10.

    Yields
    ------
    MeshFile
        One frame. All frames share the `Mesh` of the first. Its notes say if frames are missing before it: from one
        number to the next.

    Raises
    ------
    FileError
        A name stands for no file: raised at once. A file cannot be used, or a frame has another topology than the
        first: raised when that frame is read.
    """
    reader = _core.FrameReader([file_name(name, f"names[{i}]") for i, name in enumerate(names)])
    return _frames(reader)


def _frames(reader: _core.FrameReader) -> Iterator[MeshFile]:
    if not reader.count():
        return
    first = _mesh_file(reader.first())
    yield first
    for i in range(1, reader.count()):
        positions, notes = reader.next(i)
        yield MeshFile(positions, first.mesh, tuple(notes))


def _mesh_file(read: tuple[Doubles, Indices, Indices, Indices, list[str]]) -> MeshFile:
    positions, faces, edges, points, notes = read
    return MeshFile(positions, Mesh(faces, len(positions), edges, points), tuple(notes))
