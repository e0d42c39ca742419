"""The frames of a USD stage."""

from __future__ import annotations

from typing import Any

import numpy as np

from tamis._errors import FileError

_MOST_FRAMES = 10_000_000


def frame_times(stage: Any, meshes: list[Any]) -> list[Any]:
    """Return the times at which points or transforms of a mesh are written; the default where none are.

    Between two of them the stage interpolates, points on straight lines. What turns or grows does not go straight:
    where something does, all frames that are played between the first time and the last are taken, too.
    """
    from pxr import Usd

    written = sorted({time for mesh in meshes for time in _written(mesh)})
    if any(op.MightBeTimeVarying() and _bends(op) for mesh in meshes for op in _ops_above(mesh)):
        written = played(stage, written)
    return [Usd.TimeCode(time) for time in written] or [Usd.TimeCode.Default()]


def played(stage: Any, times: list[float]) -> list[float]:
    """Return these sorted times, and between the first and the last also those of the frames that are played."""
    if len(times) < 2:
        return times
    rate, codes = stage.GetFramesPerSecond(), stage.GetTimeCodesPerSecond()
    step = codes / rate if rate > 0 and codes > 0 else 1.0
    first, last = np.ceil(times[0] / step), np.floor(times[-1] / step)
    if last - first > _MOST_FRAMES:
        raise FileError(
            f"{stage.GetRootLayer().GetDisplayName()}: its keys go from time {times[0]:g} to {times[-1]:g}, "
            f"{last - first:.3g} frames: write keys nearer to each other, or another framesPerSecond"
        )
    return sorted({*times, *(np.arange(first, last + 1) * step).tolist()})


def _written(mesh: Any) -> list[float]:
    times = {*mesh.GetPointsAttr().GetTimeSamples(), *mesh.GetFaceVertexIndicesAttr().GetTimeSamples()}
    return sorted(times.union(*(op.GetTimeSamples() for op in _ops_above(mesh))))


def _bends(op: Any) -> bool:
    kind = op.GetOpName().split(":")[1]  # of xformOp:translate, !invert!xformOp:translate:pivot
    return not kind.startswith("translate")


def _ops_above(mesh: Any) -> list[Any]:
    """Return the operations that place a mesh: its own and those of the prims above it."""
    from pxr import UsdGeom

    ops, prim = [], mesh.GetPrim()
    while prim and not prim.IsPseudoRoot():
        if prim.IsA(UsdGeom.Xformable):
            ops += UsdGeom.Xformable(prim).GetOrderedXformOps()
        prim = prim.GetParent()
    return ops
