"""Audits of USD stages; skipped where usd-core is not installed."""

from __future__ import annotations

import pathlib
from typing import Any

import numpy as np
import pytest

import tamis

pxr = pytest.importorskip("pxr")
from pxr import Gf, Usd, UsdGeom, UsdSkel  # noqa: E402


def _mesh(stage: Any, path: str, points: Any, counts: list[int], corners: list[int]) -> Any:
    mesh = UsdGeom.Mesh.Define(stage, path)
    mesh.CreatePointsAttr(points)
    mesh.CreateFaceVertexCountsAttr(counts)
    mesh.CreateFaceVertexIndicesAttr(corners)
    return mesh


def _stage() -> Any:
    """A spike that falls through a floor of one square, in a world that is moved up."""
    stage = Usd.Stage.CreateInMemory()
    UsdGeom.Xform.Define(stage, "/World").AddTranslateOp().Set(Gf.Vec3d(0, 0, 5))
    _mesh(stage, "/World/Floor", [(-1, -1, 0), (2, -1, 0), (2, 2, 0), (-1, 2, 0)], [4], [0, 1, 2, 3])
    spike = _mesh(stage, "/World/Spike", [(0, 0.1, 1), (0.3, 0, 1.5), (0, 0.3, 1.5)], [3], [0, 1, 2])
    fall = spike.AddTranslateOp()
    for time in range(5):
        fall.Set(Gf.Vec3d(0, 0, -0.3 * time), time)
    return stage


def test_transforms_are_composed_and_prims_are_objects() -> None:
    report = tamis.audit(_stage())
    assert len(report.frames) == 5 and report.first_bad is not None and report.first_bad.name == "4"
    assert {frozenset(pair.objects) for pair in report.pairs} == {frozenset({"/World/Floor", "/World/Spike"})}
    contacts = report.pairs[report.pairs.kind == tamis.AuditKind.VERTEX_FACE]
    assert abs(contacts.toi_upper[0] - 1 / 3) < 1e-6


def test_a_file_and_chosen_prims(tmp_path: pathlib.Path) -> None:
    stage = _stage()
    for name in ("a.usda", "a.usdc"):
        stage.Export(str(tmp_path / name))
        assert not tamis.audit(tmp_path / name).is_free
    assert tamis.audit(tamis.read_usd(tmp_path / "a.usda", prims=["/World/Spike"])).is_free
    assert not tamis.audit(tamis.read_usd(tmp_path / "a.usda", prims=["/World"])).is_free


def test_points_that_are_written_at_times() -> None:
    stage = _stage()
    points = UsdGeom.Mesh(stage.GetPrimAtPath("/World/Floor")).GetPointsAttr()
    points.Set([(-1, -1, 0), (2, -1, 0), (2, 2, 0), (-1, 2, 0)], 0)
    points.Set([(-1, -1, -9), (2, -1, -9), (2, 2, -9), (-1, 2, -9)], 2.5)
    report = tamis.audit(stage)
    assert report.is_free and report.frames.names == ["0", "1", "2", "2.5", "3", "4"]


def test_topology_that_changes_is_split_and_said() -> None:
    stage = _stage()
    floor = UsdGeom.Mesh(stage.GetPrimAtPath("/World/Floor"))
    for time in range(5):
        floor.GetFaceVertexCountsAttr().Set([4] if time < 2 else [3], time)
        floor.GetFaceVertexIndicesAttr().Set([0, 1, 2, 3] if time < 2 else [0, 1, 2], time)
    report = tamis.audit(stage)
    assert list(report.notes) == [2] and "topology changes" in report.notes[2]
    assert len(report.steps) == 3


def test_proxies_are_left_out() -> None:
    stage = _stage()
    square = [(-1, -1, 0.2), (2, -1, 0.2), (2, 2, 0.2), (-1, 2, 0.2)]
    proxy = _mesh(stage, "/World/Spike/Proxy", square, [4], [0, 1, 2, 3])
    proxy.CreatePurposeAttr(UsdGeom.Tokens.proxy)
    assert len(tamis.audit(stage).pairs) == len(tamis.audit(_stage()).pairs)


def test_what_cannot_be_used(tmp_path: pathlib.Path) -> None:
    with pytest.raises(tamis.FileError, match="no mesh in it"):
        tamis.audit(Usd.Stage.CreateInMemory())
    with pytest.raises(tamis.FileError, match="cannot be opened"):
        tamis.audit(tmp_path / "none.usda")
    (tmp_path / "bad.usda").write_text("no stage")
    with pytest.raises(tamis.FileError, match="cannot be opened"):
        tamis.read_usd(tmp_path / "bad.usda")
    with pytest.raises(tamis.InvalidOptions, match="no prim at /Nowhere"):
        tamis.read_usd(_stage(), prims=["/Nowhere"])
    stage = _stage()
    UsdGeom.Mesh(stage.GetPrimAtPath("/World/Floor")).GetFaceVertexIndicesAttr().Set([0, 1, 2, 9])
    with pytest.raises(tamis.FileError, match="do not fit its 4 points"):
        tamis.audit(stage)


def test_points_that_become_none_are_a_frame_that_cannot_be_used() -> None:
    stage = _stage()
    points = UsdGeom.Mesh(stage.GetPrimAtPath("/World/Spike")).GetPointsAttr()
    for time in range(5):
        points.Set([(0, 0.1, 1), (0.3, 0, 1.5), (0, 0.3, 1.5)] if time != 1 else [], time)
    report = tamis.audit(stage)
    assert list(report.problems) == [1] and not report.is_free
    assert np.isfinite(report.frames.toi_lower).all()


def test_skins_are_baked_and_the_stage_stays_as_it_is() -> None:
    stage = Usd.Stage.CreateInMemory()
    UsdSkel.Root.Define(stage, "/R")
    skeleton = UsdSkel.Skeleton.Define(stage, "/R/S")
    skeleton.CreateJointsAttr(["bone"])
    skeleton.CreateBindTransformsAttr([Gf.Matrix4d(1)])
    skeleton.CreateRestTransformsAttr([Gf.Matrix4d(1)])
    animation = UsdSkel.Animation.Define(stage, "/R/A")
    animation.CreateJointsAttr(["bone"])
    for time in range(3):
        animation.CreateTranslationsAttr().Set([Gf.Vec3f(0, 0, time)], time)
        animation.CreateRotationsAttr().Set([Gf.Quatf(1)], time)
        animation.CreateScalesAttr().Set([Gf.Vec3h(1)], time)
    mesh = _mesh(stage, "/R/M", [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [3], [0, 1, 2])
    binding = UsdSkel.BindingAPI.Apply(mesh.GetPrim())
    binding.CreateSkeletonRel().SetTargets(["/R/S"])
    binding.CreateJointIndicesPrimvar(True, 1).Set([0])
    binding.CreateJointWeightsPrimvar(True, 1).Set([1.0])
    UsdSkel.BindingAPI.Apply(skeleton.GetPrim()).CreateAnimationSourceRel().SetTargets(["/R/A"])
    before = stage.GetRootLayer().ExportToString()
    heights = [frame.positions[0, 2] for frame in tamis.read_usd(stage)._frames() if frame.positions is not None]
    assert heights == [0, 1, 2] and stage.GetRootLayer().ExportToString() == before
