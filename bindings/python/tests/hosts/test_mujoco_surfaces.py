"""The referee of MuJoCo: the triangles of its surfaces, and which of them may touch."""

from __future__ import annotations

import numpy as np
import pytest

import tamis

mujoco = pytest.importorskip("mujoco", reason="MuJoCo is not installed: bindings/python/requirements-hosts.txt")

import tamis.mujoco  # noqa: E402
from mujoco_models import loaded  # noqa: E402
from tamis import _primitives  # noqa: E402
from tamis.mujoco import _surfaces  # noqa: E402


@pytest.mark.parametrize("tolerance", [0.1, 1e-2, 1e-3])
def test_triangles_are_around_the_true_surface_and_near_it(tolerance: float) -> None:
    radius, half = 0.5, 0.7
    for shape, axis in (
        (_primitives.capsule(radius, 0.0, tolerance), 0.0),
        (_primitives.capsule(radius, half, tolerance), half),
        (_primitives.cylinder(radius, half, tolerance), None),
    ):
        a, b, c = shape.points[shape.faces].transpose(1, 0, 2)
        normals = np.cross(b - a, c - a)
        assert ((normals * a).sum(1) > 0).all(), "a triangle looks inward"
        sides = np.sort(np.vstack([shape.faces[:, [0, 1]], shape.faces[:, [1, 2]], shape.faces[:, [2, 0]]]), axis=1)
        assert (np.unique(sides, axis=0, return_counts=True)[1] == 2).all(), "the surface has a gap"
        out = shape.points.copy()
        if axis is None:
            assert np.abs(shape.points[:, 2]).max() == half
            out[:, 2] = 0
        else:
            out[:, 2] = np.sign(out[:, 2]) * np.maximum(np.abs(out[:, 2]) - axis, 0)
        assert np.linalg.norm(out, axis=1).max() <= radius + tolerance
        unit = normals / np.linalg.norm(normals, axis=1, keepdims=True)
        support = radius * np.linalg.norm(unit[:, :2], axis=1) + np.abs(unit[:, 2]) * half
        if axis is not None:
            support = radius + np.abs(unit[:, 2]) * axis
        assert ((unit * a).sum(1) >= support).all(), "a plane cuts the solid"


def test_who_may_touch_is_as_the_model_says() -> None:
    xml = """
<mujoco>
  <worldbody>
    <geom name="ground" type="box" size="1 1 0.1"/>
    <body name="a" pos="0 0 1"><freejoint/><geom name="a" type="box" size=".1 .1 .1"/>
      <geom name="a2" type="box" size=".1 .1 .1"/>
      <body name="b"><joint/><geom name="b" type="box" size=".1 .1 .1"/></body></body>
    <body name="c" pos="0 0 2"><freejoint/><geom name="c" type="box" size=".1 .1 .1"/>
      <geom name="ghost" type="box" size=".1 .1 .1" contype="0" conaffinity="0"/></body>
  </worldbody>
  <contact><exclude body1="b" body2="c"/></contact>
</mujoco>"""
    model, data = loaded(xml)
    referee = tamis.mujoco.Referee(model, data)
    assert referee.names == ["ground", "a", "a2", "b", "c"]
    allowed = _surfaces.may_touch(model, referee._surfaces.parts)
    touching = {(i, j) for i, j in zip(*np.nonzero(allowed)) if i < j}
    assert touching == {(0, 1), (0, 2), (0, 3), (0, 4), (1, 4), (2, 4)}


def test_what_rests_on_a_plane_touches_it_once() -> None:
    """Bug: a box at the plane's origin had edges exactly on a diagonal of the plane, and touched it in each step."""
    xml = """<mujoco><option><flag sleep='enable'/></option><worldbody><geom type='plane' size='5 5 .1'/>
      <body pos='0 0 .12'><freejoint/><geom type='box' size='.1 .1 .1'/></body></worldbody></mujoco>"""
    model, data = loaded(xml)
    referee = tamis.mujoco.Referee(model, data)
    for _ in range(400):
        mujoco.mj_step(model, data)
        referee.check()
    assert len(referee.report.bad_steps) == 1


PINNED = """
<mujoco>
  <worldbody>
    <body name="pole" pos="0 0 1">
      <joint type="hinge" axis="0 0 1"/>
      <geom name="pole" type="capsule" size=".02" fromto="{pole} -.3 0 {pole} .3 0"/>
      <flexcomp name="flag" type="grid" count="4 4 1" spacing=".1 .1 .1" radius=".001" dim="2" mass=".1">
        <contact selfcollide="auto" contype="{bits}" conaffinity="{bits}"/><pin id="0 1 2 3"/>
      </flexcomp>
    </body>
  </worldbody>
</mujoco>"""


@pytest.mark.parametrize(("pole", "is_pinned"), [(-0.15, True), (0.05, False)])
def test_what_is_pinned_to_a_body_passes_its_geoms_as_in_mujoco(pole: float, is_pinned: bool) -> None:
    model, data = loaded(PINNED.format(pole=pole, bits=1))
    referee = tamis.mujoco.Referee(model, data)
    assert (len(referee.intersections()) == 0) == is_pinned
    mujoco.mj_step(model, data)
    assert referee.check().is_free == is_pinned
    assert (data.ncon == 0) == is_pinned


def test_a_flex_without_bits_does_not_meet_itself() -> None:
    for bits in (0, 1):
        model, _ = loaded(PINNED.format(pole=-0.15, bits=bits))
        parts = _surfaces.surfaces_of(model, 0.01, 1).parts
        assert _surfaces.may_touch(model, parts)[0, 0] == bool(bits)


STANDING = """
<mujoco>
  <option gravity="0 0 0"/>
  <worldbody>
    <body name="table"><geom name="top" type="box" size="1 1 .1"/></body>
    <body pos="0 0 1"><freejoint/><geom name="cube" type="box" size=".1 .1 .1"/></body>
    <body name="sign"><geom name="sign" type="box" size=".1 .1 .1" contype="0" conaffinity="0"/></body>
  </worldbody>
</mujoco>"""


@pytest.mark.parametrize("field", ["body_pos", "body_quat", "geom_size", "geom_pos", "geom_quat", "geom_contype"])
@pytest.mark.parametrize("what", ["table", "sign"])
def test_a_model_is_refused_if_what_collides_has_changed(field: str, what: str) -> None:
    model, data = loaded(STANDING)
    referee = tamis.mujoco.Referee(model, data)
    number = model.geom(what if what == "sign" else "top").id if "geom" in field else model.body(what).id
    getattr(model, field)[number] = 2 if field == "geom_contype" else [0.5] * getattr(model, field).shape[1]
    mujoco.mj_step(model, data)
    if what == "sign" and field != "geom_contype":
        assert referee.check().is_free
        return
    with pytest.raises(tamis.InvalidStep, match="make another one after each change of the model"):
        referee.check()
    with pytest.raises(tamis.InvalidStep, match="make another one"):
        referee.restart()


def test_a_tolerance_that_asks_for_too_many_triangles_is_refused() -> None:
    earth = '<mujoco><worldbody><geom type="sphere" size="6000"/></worldbody></mujoco>'
    with pytest.raises(tamis.InvalidOptions, match="two million triangles"):
        tamis.mujoco.Referee(*loaded(earth))
