"""The times of the frames of a USD stage."""

from __future__ import annotations

from typing import Any

import numpy as np

from tamis._errors import FileError

_MOST_FRAMES = 10_000_000


def frame_times(stage: Any, meshes: list[Any]) -> list[Any]:
    """Return the times at which points or transforms of a mesh are written; the default time if there are none.

    Between two such times the stage interpolates, and points go straight. If anything turns, scales or follows a
    spline, points move on curves: then the stage's frames between the first and the last time are added.
    """
    from pxr import Usd

    written = sorted({time for mesh in meshes for time in _written(stage, mesh)})
    if any(op.MightBeTimeVarying() and _bends(op) for mesh in meshes for op in _ops_above(mesh)):
        written = played(stage, written)
    return [Usd.TimeCode(time) for time in written] or [Usd.TimeCode.Default()]


def played(stage: Any, times: list[float]) -> list[float]:
    """Return these times and the stage's frames (framesPerSecond) between the first and the last, sorted."""
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


def _written(stage: Any, mesh: Any) -> list[float]:
    times = {*mesh.GetPointsAttr().GetTimeSamples(), *mesh.GetFaceVertexIndicesAttr().GetTimeSamples()}
    ops = _ops_above(mesh)
    return sorted(times.union(*(op.GetTimeSamples() for op in ops), *(_times_of_spline(stage, op) for op in ops)))


def _has_spline(op: Any) -> bool:
    attribute = op.GetAttr()
    return hasattr(attribute, "HasSpline") and bool(attribute.HasSpline())  # usd-core has splines from 24.11 on


def _times_of_spline(stage: Any, op: Any) -> set[float]:
    """Return the times of a spline's knots, and the stage's start and end: it may extrapolate beyond the knots."""
    if not _has_spline(op):
        return set()
    spline = op.GetAttr().GetSpline()
    times = set((spline.GetKnotsWithInnerLoopsBaked() if spline.HasInnerLoops() else spline.GetKnots()).keys())
    return times | {stage.GetStartTimeCode(), stage.GetEndTimeCode()} if stage.HasAuthoredTimeCodeRange() else times


def _bends(op: Any) -> bool:
    kind = op.GetOpName().split(":")[1]  # the name is such as xformOp:translate or !invert!xformOp:translate:pivot
    return _has_spline(op) or not kind.startswith("translate")


def _ops_above(mesh: Any) -> list[Any]:
    """Return the transform operations that place a mesh: its own, and the operations of the prims above it."""
    from pxr import UsdGeom

    ops, prim = [], mesh.GetPrim()
    while prim and not prim.IsPseudoRoot():
        if prim.IsA(UsdGeom.Xformable):
            ops += UsdGeom.Xformable(prim).GetOrderedXformOps()
        prim = prim.GetParent()
    return ops
