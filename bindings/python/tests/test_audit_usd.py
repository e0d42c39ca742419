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
    """Return a spike that falls through a floor of one square, in a world that is moved up."""
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


def test_what_turns_is_asked_frame_by_frame() -> None:
    stage = Usd.Stage.CreateInMemory()
    blade = _mesh(stage, "/Blade", [(1, 0, 0), (2, 0, 0), (2, 0, 1)], [3], [0, 1, 2])
    _mesh(stage, "/Post", [(-1.5, 0.9, 0.5), (1.5, 0.9, 0.5), (0, 1.5, 0.5)], [3], [0, 1, 2])
    turn = blade.AddRotateZOp()
    turn.Set(0, 1)
    turn.Set(180, 19)
    report = tamis.audit(stage)  # straight motion from 1 to 19 would go through the axis, below the post
    assert report.frames.names == [str(time) for time in range(1, 20)]
    assert report.first_bad is not None and report.first_bad.name == "5"
    stage.SetTimeCodesPerSecond(1)
    stage.SetFramesPerSecond(2)
    assert len(tamis.audit(stage).frames) == 37
    turn.Set(180, 1e12)
    with pytest.raises(tamis.FileError, match="frames: write keys nearer to each other"):
        tamis.audit(stage)


def test_splines_are_asked_frame_by_frame() -> None:
    """Would catch that a motion without samples of its own counts as no motion."""
    pxr_ts = pytest.importorskip("pxr.Ts")
    stage = _stage()
    spike = UsdGeom.Mesh(stage.GetPrimAtPath("/World/Spike"))
    spike.ClearXformOpOrder()
    fall = UsdGeom.Xformable(spike).AddTranslateZOp()
    spline = pxr_ts.Spline("double")
    for time, height in ((3, 0.0), (9, -3.0)):
        knot = pxr_ts.Knot("double")
        knot.SetTime(time)
        knot.SetValue(height)
        knot.SetNextInterpolation(pxr_ts.InterpLinear)
        spline.SetKnot(knot)
    assert fall.GetAttr().SetSpline(spline)
    report = tamis.audit(stage)
    assert report.frames.names == [str(time) for time in range(3, 10)]
    assert report.first_bad is not None and report.first_bad.name == "5"
    stage.SetStartTimeCode(1)
    stage.SetEndTimeCode(12)
    assert len(tamis.audit(stage).frames) == 12


@pytest.mark.parametrize("purpose", ["proxy", "guide", "invisible"])
def test_what_is_not_rendered_is_left_out_unless_it_is_named(purpose: str) -> None:
    stage = _stage()
    square = [(-1, -1, 0.2), (2, -1, 0.2), (2, 2, 0.2), (-1, 2, 0.2)]
    other = _mesh(stage, "/World/Spike/Other", square, [4], [0, 1, 2, 3])
    if purpose == "invisible":
        other.CreateVisibilityAttr(UsdGeom.Tokens.invisible)
    else:
        other.CreatePurposeAttr(purpose)
    report = tamis.audit(stage)
    assert len(report.pairs) == len(tamis.audit(_stage()).pairs)
    assert report.notes[0] == f"skipped, 1 prims: /World/Spike/Other ({purpose})"
    assert "1 meshes" in repr(tamis.read_usd(stage, prims=["/World/Spike/Other"]))


def test_of_a_stage_whose_meshes_are_all_invisible_that_is_said() -> None:
    """Bug: "no mesh in it" of a stage whose mesh is hidden."""
    stage = Usd.Stage.CreateInMemory()
    hidden = _mesh(stage, "/World/Cloth", [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [3], [0, 1, 2])
    hidden.CreateVisibilityAttr(UsdGeom.Tokens.invisible)
    with pytest.raises(tamis.FileError, match=r"left out, /World/Cloth \(invisible\): make it visible, or name"):
        tamis.audit(stage)


def test_a_sphere_is_named_as_left_out() -> None:
    stage = _stage()
    UsdGeom.Sphere.Define(stage, "/World/Ball")
    assert tamis.audit(stage).notes[0] == "skipped, 1 prims: /World/Ball (Sphere, no mesh)"


def test_prototypes_of_a_point_instancer_are_no_meshes_of_the_scene() -> None:
    stage = _stage()
    UsdGeom.PointInstancer.Define(stage, "/World/Dust")
    _mesh(stage, "/World/Dust/Prototype", [(0, 0, -1), (1, 0, 1), (0, 1, 1)], [3], [0, 1, 2])
    report = tamis.audit(stage)
    assert len(report.pairs) == len(tamis.audit(_stage()).pairs)
    assert report.notes[0] == "skipped, 1 prims: /World/Dust (point instancer)"


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


def _skinned_stage() -> Any:
    """Return a triangle on a bone that turns by half a turn from time 0 to 2."""
    stage = Usd.Stage.CreateInMemory()
    UsdSkel.Root.Define(stage, "/R")
    skeleton = UsdSkel.Skeleton.Define(stage, "/R/S")
    skeleton.CreateJointsAttr(["bone"])
    skeleton.CreateBindTransformsAttr([Gf.Matrix4d(1)])
    skeleton.CreateRestTransformsAttr([Gf.Matrix4d(1)])
    animation = UsdSkel.Animation.Define(stage, "/R/A")
    animation.CreateJointsAttr(["bone"])
    animation.CreateTranslationsAttr().Set([Gf.Vec3f(0, 0, 3)], 0)
    animation.CreateScalesAttr().Set([Gf.Vec3h(1)], 0)
    for time, turned in ((0, Gf.Quatf(1, 0, 0, 0)), (2, Gf.Quatf(0, 0, 0, 1))):
        animation.CreateRotationsAttr().Set([turned], time)
    mesh = _mesh(stage, "/R/M", [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [3], [0, 1, 2])
    binding = UsdSkel.BindingAPI.Apply(mesh.GetPrim())
    binding.CreateSkeletonRel().SetTargets(["/R/S"])
    binding.CreateJointIndicesPrimvar(True, 1).Set([0])
    binding.CreateJointWeightsPrimvar(True, 1).Set([1.0])
    UsdSkel.BindingAPI.Apply(skeleton.GetPrim()).CreateAnimationSourceRel().SetTargets(["/R/A"])
    return stage


def _second_points(motion: tamis.Motion) -> list[list[float]]:
    return [frame.positions[1].round(6).tolist() for frame in motion._frames() if frame.positions is not None]


_ON_ITS_ARC = [[1, 0, 3], [0, 1, 3], [-1, 0, 3]]


@pytest.mark.parametrize("prims", [None, ["/R/M"]])
def test_skins_are_baked_frame_by_frame_and_the_stage_stays_as_it_is(prims: list[str] | None) -> None:
    stage = _skinned_stage()
    before = stage.ExportToString()
    assert _second_points(tamis.read_usd(stage, prims=prims)) == _ON_ITS_ARC
    assert stage.ExportToString() == before


def test_skins_in_an_instance() -> None:
    stage = _skinned_stage()
    stage.DefinePrim("/I").GetReferences().AddInternalReference("/R")
    stage.GetPrimAtPath("/I").SetInstanceable(True)
    UsdGeom.Xform.Define(stage, "/Both").AddTranslateOp().Set(Gf.Vec3d(0, 0, 1))
    within = stage.DefinePrim("/Both/Within")
    within.GetReferences().AddInternalReference("/R")
    within.SetInstanceable(True)
    assert _second_points(tamis.read_usd(stage, prims=["/I"])) == _ON_ITS_ARC
    assert _second_points(tamis.read_usd(stage, prims=["/Both"])) == [[x, y, z + 1] for x, y, z in _ON_ITS_ARC]


_L = [(2, 0, 0), (2, 1, 0), (1, 1, 0), (1, 2, 0), (0, 2, 0), (0, 0, 0)]


def test_polygons_are_cut_inside() -> None:
    stage = Usd.Stage.CreateInMemory()
    _mesh(stage, "/L", _L, [6], [0, 1, 2, 3, 4, 5])
    report = tamis.audit(stage)
    assert report.is_free and not report.notes
    points = UsdGeom.Mesh(stage.GetPrimAtPath("/L")).GetPointsAttr()
    points.Set([*_L[:5], (0, 0, 1)])
    assert "/L: 1 polygon is not flat" in tamis.audit(stage).notes[0]


def test_the_first_frame_tells_how_polygons_are_cut() -> None:
    stage = Usd.Stage.CreateInMemory()
    points = _mesh(stage, "/Quad", _L[:4], [4], [0, 1, 2, 3]).GetPointsAttr()
    points.Set([(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0)], 0)
    points.Set([(0, 0, 0), (2, 0, 0), (0.1, 0.1, 0), (0, 2, 0)], 1)
    assert len(tamis.audit(stage).steps) == 1


def test_holes_are_left_out() -> None:
    stage = Usd.Stage.CreateInMemory()
    spike = [(0.3, 0.3, -1), (0.6, 0.3, 1), (0.4, 0.6, 1)]
    mesh = _mesh(stage, "/M", [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), *spike], [4, 3], [0, 1, 2, 3, 4, 5, 6])
    assert not tamis.audit(stage).is_free
    mesh.CreateHoleIndicesAttr([0])
    report = tamis.audit(stage)
    assert report.is_free and "1 of its faces are holes" in report.notes[0]
    mesh.CreateSubdivisionSchemeAttr("none")
    report = tamis.audit(stage)
    assert not report.is_free and "taken as faces" in report.notes[0]
