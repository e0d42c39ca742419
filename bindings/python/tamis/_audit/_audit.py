"""`audit`: one call for a whole recorded motion, whatever its source."""

from __future__ import annotations

import itertools
import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import indices, point_frames, rows
from tamis._audit._archive import archive_frames
from tamis._audit._gltf import read_gltf
from tamis._audit._options import make_audit_options
from tamis._audit._recorded import Frame, Motion, require_frames_first
from tamis._audit._report import AuditReport
from tamis._audit._shared import Objects, shared_mesh
from tamis._audit._usd import read_usd
from tamis._checks import file_name, function, shown
from tamis._errors import Error, InvalidMesh, InvalidStep
from tamis._files import MeshFile, read_mesh
from tamis._mesh import Mesh


def audit(
    source: str | os.PathLike[str] | Sequence[str] | npt.ArrayLike | Iterable[Any] | Motion,
    *,
    mesh: Mesh | None = None,
    faces: npt.ArrayLike | None = None,
    objects: Objects | None = None,
    min_separation: float = 0.0,
    threads: int = 0,
    intersections: bool = True,
    contacts: bool = True,
    ring_limit: int = 10,
    listed_pairs: int = 1_000_000,
    page_bytes: int = 32 << 20,
    progress: Callable[[int], object] | None = None,
) -> AuditReport:
    """Find the intersections in each frame of a recorded motion, and the contacts in each step between two frames.

    Frames are read one after the other, and freed once they have been tested. Threads test different frames.

    Parameters
    ----------
    source
        Where each vertex is, frame by frame. In a step between two frames each vertex moves on a straight line.

        - array_like, shape (f, n, 3), or an iterable of frames, shape (n, 3) each: needs `mesh` or `faces`. Or what
          `read_frames` returns, which has a mesh.
        - The name of a file, a folder or a glob pattern, or a list of them: mesh files, sorted in natural order;
          a mesh file with a point cache (.pc2, .mdd), or the cache alone with `mesh`; or one .npz archive, whose only
          array of shape (f, n, 3) has the positions, and whose only array of whole numbers of shape (t, 3) has the
          faces (or give `mesh`).
        - A USD stage (.usd, .usda, .usdc, .usdz, or a `Usd.Stage`) or a glTF file (.gltf, .glb), read as by `read_usd`
          and `read_gltf`, which have more options.
        - A `Motion`, which these two return.
    mesh : Mesh, optional
        The mesh that moves, if the source has none.
    faces : array_like of int, shape (t, 3), optional
        Its triangles, instead of `mesh`.
    objects : array_like of int, shape (n,), or dict, optional
        As in `Auditor`.
    min_separation, threads, intersections, contacts, ring_limit, listed_pairs, page_bytes
        As in `Auditor`. The report does not depend on the number of threads.
    progress : callable, optional
        ``progress(frames)`` is called now and then with the number of frames that have been tested.

    Returns
    -------
    AuditReport
        Its `problems` name frames that cannot be used; a report with any is not free. Its `notes` name frames that no
        step leads to, because the topology changes there, or file numbers are missing.

    Raises
    ------
    FileError, InvalidMesh, InvalidStep, InvalidOptions
        An argument or a file cannot be used.
    ModuleNotFoundError
        usd-core or pygltflib is needed and not installed.
    BaseException
        Any exception of the source, and KeyboardInterrupt. The exception's attribute `report` is the report of the
        frames before.

    Examples
    --------
    A point falls through a triangle between the second and the third frame:

    >>> mesh = Mesh([[0, 1, 2]], points=[3])
    >>> frames = [[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.2, 0.2, z]] for z in (2, 1, -1)]
    >>> audit(frames, mesh=mesh).first_bad.frame
    2
    """
    options = make_audit_options(
        min_separation=min_separation,
        threads=threads,
        intersections=intersections,
        contacts=contacts,
        ring_limit=ring_limit,
        listed_pairs=listed_pairs,
        page_bytes=page_bytes,
        progress=None if progress is None else function(progress, "progress", "progress(frames)"),
    )
    known = _Known(mesh, faces, objects)
    found = _ask(source, known, options)
    report = AuditReport(found)
    try:
        found.raise_what_ended_it()
    except BaseException as error:
        error.report = report  # type: ignore[attr-defined]
        raise
    return report


class _Known:
    """The arguments of `audit` about the mesh, checked: `mesh` or `faces`, and `objects`."""

    def __init__(self, mesh: Mesh | None, faces: npt.ArrayLike | None, objects: Objects | None) -> None:
        if mesh is not None and faces is not None:
            raise InvalidMesh("both mesh and faces are given: give one of them")
        self.is_given = mesh is not None or faces is not None
        self.objects = objects
        self._mesh = mesh
        self._faces = None if faces is None else indices(faces, 3, "faces", InvalidMesh)

    def of(self, vertex_count: int | None) -> _core.SharedMesh:
        if self._faces is not None:
            return shared_mesh(Mesh(self._faces, vertex_count), self.objects)
        if self._mesh is None:
            raise InvalidMesh("these frames are positions alone: give mesh=..., or faces=...")
        return shared_mesh(self._mesh, self.objects)

    def require_not_swapped(self, name: str, shape: tuple[int, ...]) -> None:
        """Raise InvalidStep if the array has a row for each vertex where frames belong."""
        if self._mesh is not None:
            require_frames_first(name, shape, self._mesh.vertex_count)
        elif self._faces is not None and self._faces.size:
            require_frames_first(name, shape, int(self._faces.max()) + 1)

    def require_none(self, what: str) -> None:
        if self.is_given:
            raise InvalidMesh(f"{what} brings its own mesh: leave out mesh and faces")


def _ask(source: Any, known: _Known, options: _core.AuditOptions) -> _core.AuditReport:
    names = _names_of(source)
    if names is None:
        return _core.audit_frames(_frames_of(source, known), options)
    suffixes = {os.path.splitext(name)[1].lower() for name in names}
    if suffixes & {".usd", ".usda", ".usdc", ".usdz", ".gltf", ".glb", ".npz"}:
        if len(names) > 1:
            raise Error(f"{names[0]} and {names[1]} are not frames of one motion: give one such file")
        return _core.audit_frames(_frames_of_file(names[0], suffixes.pop(), known), options)
    return _ask_files(names, known, options)


def _names_of(source: Any) -> list[str] | None:
    """Return the names of files that the source is; None if it is not a name and no list of names."""
    if isinstance(source, (str, bytes, os.PathLike)):
        return [file_name(source, "source")]
    is_list = isinstance(source, (list, tuple)) and len(source) > 0
    if is_list and all(isinstance(name, (str, bytes, os.PathLike)) for name in source):
        return [file_name(name, f"source[{i}]") for i, name in enumerate(source)]
    return None


def _frames_of_file(name: str, suffix: str, known: _Known) -> Iterator[Frame]:
    if suffix == ".npz":
        return archive_frames(name, known.of if known.is_given else None, known.objects)
    known.require_none(name)
    motion = read_gltf(name) if suffix in (".gltf", ".glb") else read_usd(name)
    return motion._frames()


def _ask_files(names: list[str], known: _Known, options: _core.AuditOptions) -> _core.AuditReport:
    """Audit mesh files and point caches, which the compiled part reads."""
    paths, has_cache = _core.motion_files(names)
    is_cache_alone = has_cache and len(paths) == 1
    if not is_cache_alone:
        known.require_none(paths[0])
    if known.is_given:
        return _core.audit_files(names, known.of(None), None, options)
    if known.objects is None or is_cache_alone:  # for a cache alone the compiled part raises: it needs a mesh
        return _core.audit_files(names, None, None, options)
    return _core.audit_files(names, None, shared_mesh(read_mesh(paths[0]).mesh, known.objects), options)


def _frames_of(source: Any, known: _Known) -> Iterator[Frame]:
    if isinstance(source, Motion):
        known.require_none("a Motion")
        return source._frames()
    if type(source).__module__.startswith("pxr."):
        known.require_none("a stage")
        return read_usd(source)._frames()
    if isinstance(source, np.ndarray) or not hasattr(source, "__iter__"):
        source = source if _is_stack(source) else point_frames(source, "source", InvalidStep)
    return _frames_of_items(iter(source), known, np.shape(source) if isinstance(source, np.ndarray) else ())


def _is_stack(source: Any) -> bool:
    """Whether the source is an array whose frames can be used one by one, without a copy of the whole."""
    return isinstance(source, np.ndarray) and source.ndim == 3 and source.dtype.kind in "iuf"


def _frames_of_items(items: Iterator[Any], known: _Known, shape: tuple[int, ...]) -> Iterator[Frame]:
    first = next(items, None)
    if first is None:
        raise InvalidStep("source has no frame: give one or more")
    frames = itertools.chain([first], items)
    if isinstance(first, MeshFile):
        known.require_none("what read_frames gives")
        return _frames_of_meshes(frames, known.objects)
    return _frames_of_rows(frames, known, shape)


def _frames_of_rows(items: Iterable[Any], known: _Known, shape: tuple[int, ...]) -> Iterator[Frame]:
    shared: _core.SharedMesh | None = None
    for i, item in enumerate(items):
        frame = rows(item, f"source[{i}]")
        if not i:
            known.require_not_swapped("source", shape)
        shared = shared or known.of(len(frame))
        yield Frame(str(i), frame, shared)


def _frames_of_meshes(items: Iterator[Any], objects: Objects | None) -> Iterator[Frame]:
    last: tuple[Mesh, _core.SharedMesh] | None = None
    said: set[str] = set()
    for i, item in enumerate(items):
        if not isinstance(item, MeshFile):
            raise InvalidStep(f"source[{i}] is {shown(item)}, the first a MeshFile: give frames of one kind")
        if last is None or item.mesh is not last[0]:
            last = (item.mesh, shared_mesh(item.mesh, objects))
        notes = [note for note in item.notes if note not in said]
        said.update(notes)
        yield Frame(str(i), rows(item.positions, f"source[{i}]"), last[1], note="; ".join(notes))
