"""Reads the frames of an .npz archive one after the other. So it may be larger than the memory."""

from __future__ import annotations

import zipfile
from collections.abc import Callable, Iterator
from typing import IO, NamedTuple

import numpy as np
import numpy.lib.format as npy
import numpy.typing as npt

from tamis import _core
from tamis._arrays import indices, rows
from tamis._audit._recorded import Frame, require_frames_first
from tamis._audit._shared import Objects, shared_mesh
from tamis._errors import Error, FileError, InvalidMesh
from tamis._mesh import Mesh


class _Member(NamedTuple):
    name: str
    shape: tuple[int, ...]
    dtype: np.dtype[np.generic]
    is_fortran: bool


def archive_frames(
    path: str, mesh_of: Callable[[int], _core.SharedMesh] | None, objects: Objects | None
) -> Iterator[Frame]:
    """Yield the frames. `mesh_of` returns the mesh, given the number of vertices; None: the archive has the faces."""
    try:
        with zipfile.ZipFile(path) as archive:
            members = [_header(archive, name) for name in archive.namelist() if name.endswith(".npy")]
            positions = _only(
                path, members, "fiu", lambda shape: len(shape) == 3 and shape[2] == 3, "(f, n, 3), the positions"
            )
            shared = mesh_of(positions.shape[1]) if mesh_of else _mesh_in(path, archive, members, positions, objects)
            yield from _stream(path, archive, positions, shared)
    except (OSError, zipfile.BadZipFile, ValueError, EOFError) as error:
        if isinstance(error, Error):
            raise
        raise FileError(f"{path}: cannot be read ({error}): give an archive that numpy.savez has written") from None


def _header(archive: zipfile.ZipFile, name: str) -> _Member:
    with archive.open(name) as file:
        return _member(file, name)


def _member(file: IO[bytes], name: str) -> _Member:
    version = npy.read_magic(file)
    read = npy.read_array_header_1_0 if version == (1, 0) else npy.read_array_header_2_0
    shape, is_fortran, dtype = read(file)
    return _Member(name, shape, dtype, is_fortran)


def _only(
    path: str, members: list[_Member], kinds: str, suits: Callable[[tuple[int, ...]], bool], what: str
) -> _Member:
    found = [m for m in members if m.dtype.kind in kinds and suits(m.shape)]
    if len(found) != 1:
        names = ", ".join(f"{m.name[:-4]} {m.shape} {m.dtype}" for m in members) or "nothing"
        raise FileError(f"{path}: {len(found)} of its arrays have the shape {what}: give one; it has {names}")
    return found[0]


def _mesh_in(
    path: str, archive: zipfile.ZipFile, members: list[_Member], positions: _Member, objects: Objects | None
) -> _core.SharedMesh:
    faces = _only(
        path, members, "iu", lambda shape: len(shape) == 2 and shape[1] == 3, "(t, 3), whole numbers, the faces"
    )
    with archive.open(faces.name) as file:
        triangles: npt.NDArray[np.generic] = npy.read_array(file)
    rows_of_faces = indices(triangles, 3, faces.name, InvalidMesh)
    if rows_of_faces.size:
        require_frames_first(positions.name, positions.shape, int(rows_of_faces.max()) + 1)
    return shared_mesh(Mesh(rows_of_faces, positions.shape[1]), objects)


def _stream(path: str, archive: zipfile.ZipFile, member: _Member, shared: _core.SharedMesh) -> Iterator[Frame]:
    if member.is_fortran:
        raise FileError(f"{path}: {member.name} is in Fortran's order: save numpy.ascontiguousarray of it")
    frames, vertices, _ = member.shape
    size = vertices * 3 * member.dtype.itemsize
    with archive.open(member.name) as file:
        _member(file, member.name)
        for i in range(frames):
            bytes_ = file.read(size)
            if len(bytes_) < size:
                yield Frame(
                    str(i), None, None, f"the file ends here: {frames - i} of its {frames} frames are not there"
                )
                return
            frame = np.frombuffer(bytes_, member.dtype).reshape(vertices, 3)
            yield Frame(str(i), rows(frame, f"frame {i}"), shared)
