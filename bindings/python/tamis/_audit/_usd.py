"""`read_usd`: reads the animated meshes of a USD stage with usd-core."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tamis import _core
from tamis._arrays import Doubles, Indices
from tamis._audit._joined import Part, joined
from tamis._audit._recorded import Frame, Motion
from tamis._audit._usd_prims import shown_meshes
from tamis._audit._usd_skins import with_baked_skins
from tamis._audit._usd_times import frame_times
from tamis._checks import file_name, shown, word
from tamis._errors import FileError, InvalidOptions
from tamis._versions import needed

if TYPE_CHECKING:
    from pxr import Usd


def read_usd(stage: str | os.PathLike[str] | Usd.Stage, *, prims: Sequence[str] | None = None) -> Motion:
    """Read the meshes of a USD stage in motion: composed, in world space, polygons cut into triangles.

    The frames are at the times at which points or transforms of a mesh are written. If something turns, scales, follows
    a spline or has a skin, they are also at the times of the stage's own frames (framesPerSecond). Each mesh is an
    object with its path as the name. Skinned meshes (UsdSkel) are baked in memory. Subdivision surfaces are taken as
    their control meshes. Proxies, guides and invisible meshes are skipped unless a path in `prims` names them. Point
    instancers are always skipped.

    Parameters
    ----------
    stage : path_like or Usd.Stage
        The name of a file, or an open stage.
    prims : sequence of str, optional
        Paths such as "/World/Cloth": the prims to read, with all below them. By default all.

    Returns
    -------
    Motion
        For `audit`.

    Raises
    ------
    FileError
        The stage cannot be read, or has no mesh.
    InvalidOptions
        `prims` is not a list of paths, or the stage has no such prim.
    ModuleNotFoundError
        usd-core is not installed: pip install usd-core.
    """
    opened, name = _open(stage)
    roots = _roots(opened, prims)
    meshes = _Meshes(opened, roots, name)
    return Motion(meshes.frames, f"{name}, {len(meshes.prims)} meshes, {len(meshes.times)} frames")


def _open(stage: Any) -> tuple[Any, str]:
    with needed("usd-core", "read_usd"):
        from pxr import Tf, Usd

    if isinstance(stage, Usd.Stage):
        return stage, stage.GetRootLayer().GetDisplayName() or "the stage"
    name = file_name(stage, "stage")
    try:
        return Usd.Stage.Open(name), name
    except Tf.ErrorException:
        raise FileError(f"{name}: cannot be opened as a USD stage: check the path and what the file is") from None


def _roots(stage: Any, prims: Any) -> list[Any]:
    if prims is None:
        return [stage.GetPseudoRoot()]
    if isinstance(prims, (str, bytes)) or not isinstance(prims, Sequence) or not len(prims):
        raise InvalidOptions(f"prims is {shown(prims)}: give a list of paths")
    found = [stage.GetPrimAtPath(word(path, "a path in prims")) for path in prims]
    for path, prim in zip(prims, found):
        if not prim:
            raise InvalidOptions(f"the stage has no prim at {path}: give a path that it has, such as /World/Cloth")
    return found


def _why_no_mesh(left_out: list[str]) -> str:
    if not left_out:
        return "no mesh in it (UsdGeom.Mesh): give a stage, or prims, with meshes"
    named, more = ", ".join(left_out[:3]), f" and {len(left_out) - 3} more" if len(left_out) > 3 else ""
    return f"all of its geometry is left out, {named}{more}: make it visible, or name its paths in prims"


class _Meshes:
    """The meshes below some prims of a stage, and the times of their frames."""

    def __init__(self, stage: Any, roots: list[Any], name: str) -> None:
        self._stage = with_baked_skins(stage, roots)  # kept, because prims do not outlive their stage
        self.prims, left_out = shown_meshes(self._stage, [root.GetPath() for root in roots])
        if not self.prims:
            raise FileError(f"{name}: {_why_no_mesh(left_out)}")
        self._note = f"skipped, {len(left_out)} prims: {', '.join(left_out[:3])}" if left_out else ""
        self.times = frame_times(self._stage, self.prims)

    def frames(self) -> Iterator[Frame]:
        from pxr import UsdGeom

        transforms = UsdGeom.XformCache()
        changes = any(_may_change_topology(mesh) for mesh in self.prims)
        surfaces: list[_Surface] = []
        shared = None
        for i, time in enumerate(self.times):
            new = surfaces if i and not changes else [_surface(mesh, time) for mesh in self.prims]
            transforms.SetTime(time)
            placed = [_world_points(mesh, time, transforms) for mesh in self.prims]
            note = "" if i else self._note
            if shared is None or not _same(new, surfaces):
                surfaces, (shared, cut) = new, _joined(new, placed)
                note = "; ".join(filter(None, (note, cut)))
            name = "default" if time.IsDefault() else f"{time.GetValue():g}"
            yield Frame(name, np.concatenate(placed), shared, note=note)


def _may_change_topology(mesh: Any) -> bool:
    attributes = (mesh.GetFaceVertexCountsAttr(), mesh.GetFaceVertexIndicesAttr(), mesh.GetHoleIndicesAttr())
    return any(attribute.ValueMightBeTimeVarying() for attribute in attributes)


class _Surface(NamedTuple):
    """The polygons of a mesh at one time, without those that are holes."""

    path: str
    vertices: int
    counts: Indices
    corners: Indices
    note: str

    def is_same(self, other: _Surface) -> bool:
        return self.vertices == other.vertices and all(
            np.array_equal(a, b) for a, b in ((self.counts, other.counts), (self.corners, other.corners))
        )

    def part(self, points: Doubles) -> tuple[Part, list[str]]:
        """Cut the polygons as they lie at these points; return sentences on them, too."""
        faces, notes = _core.cut_polygons(self.counts, self.corners, points)
        if self.note:
            notes.append(self.note)
        return Part(self.path, self.vertices, faces), notes


def _surface(mesh: Any, time: Any) -> _Surface:
    counts = np.array(mesh.GetFaceVertexCountsAttr().Get(time) or [], np.int64)
    corners = np.array(mesh.GetFaceVertexIndicesAttr().Get(time) or [], np.int64)
    path, vertices = str(mesh.GetPath()), len(mesh.GetPointsAttr().Get(time) or [])
    is_sound = (counts >= 0).all() and counts.sum() == len(corners)
    if not is_sound or (len(corners) and not 0 <= corners.min() <= corners.max() < vertices):
        raise FileError(f"{path}: its polygons do not fit its {vertices} points at time {time}: write the mesh again")
    is_hole = np.zeros(len(counts), bool)
    holes = np.array(mesh.GetHoleIndicesAttr().Get(time) or [], np.int64)
    is_hole[holes[(holes >= 0) & (holes < len(counts))]] = True
    note = f"{int(is_hole.sum())} of its faces are holes (holeIndices), and are left out" if is_hole.any() else ""
    if note and mesh.GetSubdivisionSchemeAttr().Get(time) == "none":  # by USD's rule only subdivision has holes
        is_hole[:] = False
        note = "holeIndices is for subdivision surfaces, so its faces are taken as faces"
    kept = corners[~np.repeat(is_hole, counts)]
    return _Surface(path, vertices, counts[~is_hole].astype(np.int32), kept.astype(np.int32), note)


def _joined(surfaces: list[_Surface], points: list[Doubles]) -> tuple[_core.SharedMesh, str]:
    """Return one mesh of all surfaces, and what to know about them: the sentences of the first three that have some."""
    cut = [surface.part(where) for surface, where in zip(surfaces, points)]
    noted = [f"{part.name}: {'; '.join(notes)}" for part, notes in cut if notes]
    more = [f"and so on for {len(noted) - 3} more meshes"] if len(noted) > 3 else []
    return joined([part for part, _ in cut]), "; ".join(noted[:3] + more)


def _same(a: list[_Surface], b: list[_Surface]) -> bool:
    return len(a) == len(b) and all(x.is_same(y) for x, y in zip(a, b))


def _world_points(mesh: Any, time: Any, transforms: Any) -> Doubles:
    points = np.array(mesh.GetPointsAttr().Get(time) or np.empty((0, 3)), np.float64).reshape(-1, 3)
    matrix = np.array(transforms.GetLocalToWorldTransform(mesh.GetPrim()), np.float64)
    if np.array_equal(matrix, np.eye(4)):
        return points  # exactly as written: no rounding
    placed: Doubles = points @ matrix[:3, :3] + matrix[3, :3]
    return placed
