"""The referee of MuJoCo: the motion between two states, and the answers about steps."""

from __future__ import annotations

import numpy as np
import pytest

import tamis

mujoco = pytest.importorskip("mujoco", reason="MuJoCo is not installed: bindings/python/requirements-hosts.txt")

import tamis.mujoco  # noqa: E402
from mujoco_models import loaded  # noqa: E402
from tamis._motion import CurvedMotion  # noqa: E402

ARM = """
<mujoco>
  <option gravity="0 0 0" timestep="0.01"><flag contact="disable"/></option>
  <worldbody>
    <body pos="0.1 0.2 0.3" euler="10 20 30">
      <joint type="slide" axis="1 1 0"/>
      <joint type="hinge" axis="0 1 0" pos="0.1 0 0"/>
      <joint type="hinge" axis="1 0 0" pos="0 0.2 0"/>
      <geom name="upper" type="box" size="0.1 0.2 0.3"/>
      <body pos="0 0 0.5" euler="0 40 0">
        <joint type="ball" pos="0 0 -0.1"/>
        <geom name="middle" type="capsule" size="0.05 0.1"/>
        <body pos="0 0.4 0">
          <joint type="hinge" axis="0 0 1"/>
          <joint type="slide" axis="0 0 1"/>
          <geom name="lower" type="cylinder" size="0.05 0.1"/>
        </body>
      </body>
    </body>
    <body name="free" pos="3 0 0"><freejoint/><geom name="egg" type="ellipsoid" size="0.1 0.2 0.3"/></body>
    <body mocap="true" pos="-3 0 0" euler="0 0 45"><geom name="told" type="box" size="0.1 0.1 0.1"/></body>
  </worldbody>
</mujoco>"""

# A flat bar turns about z past a thin post.
SWEEP = """
<mujoco>
  <option gravity="0 0 0" timestep="0.05"><flag contact="disable"/></option>
  <worldbody>
    <body><joint type="hinge" axis="0 0 1"/><geom name="bar" type="box" size="1 0.01 0.1"/></body>
    <geom name="post" type="box" size="0.002 0.002 0.5" pos="{x} {y} 0"/>
  </worldbody>
</mujoco>"""


def test_the_path_is_where_mujoco_integrates_to_at_every_time() -> None:
    """Bugs: joints composed in the wrong order; a slide forgotten; a ball's velocity taken in the world's frame."""
    model, data = loaded(ARM)
    rng = np.random.default_rng(3)
    for _ in range(10):
        data.qpos[:] += rng.normal(size=model.nq) * 0.3
        mujoco.mj_normalizeQuat(model, data.qpos)
        referee = tamis.mujoco.Referee(model, data)
        start, velocity = data.qpos.copy(), rng.normal(size=model.nv) * 60
        velocity[3:6] *= 0.5
        mocap = data.mocap_pos.copy(), rng.normal(size=3)
        for time in (0.25, 0.5, 1.0):
            data.qpos[:] = start
            mujoco.mj_integratePos(model, data.qpos, velocity, time * model.opt.timestep)
            data.mocap_pos[:] = mocap[0] + time * mocap[1]
            other = tamis.mujoco.Referee(model, data)
            if time == 0.25:
                early = other.positions
            elif time == 0.5:
                middle = other.positions
        data.time += model.opt.timestep
        before = referee.positions
        referee._look()
        moving = referee._motion(before)
        assert isinstance(moving, CurvedMotion)
        for time, positions in ((0, before), (0.25, early), (0.5, middle), (1, referee.positions)):
            assert np.abs(moving.path.points_at(time) - positions).max() < 1e-12


def test_a_turning_bar_meets_a_post_between_two_states() -> None:
    """Would catch straight motion between both states, which misses the post."""
    angle, radius = 0.5, 0.99
    model, data = loaded(SWEEP.format(x=radius * np.cos(angle), y=radius * np.sin(angle)))
    data.qvel[0] = 20  # one radian a step
    referee = tamis.mujoco.Referee(model, data)
    assert not len(referee.intersections())
    start = referee.positions
    mujoco.mj_step(model, data)
    step = referee.check()
    assert not step.is_free and [(m.first, m.second) for m in step.meetings] == [("post", "bar")]
    assert step.meetings[0].time == pytest.approx(0.05 * (angle - 0.0121), abs=2e-4) and step.meetings[0].certified
    assert "post and bar" in str(step) and step.contacts.toi_lower.min() < 0.5
    assert referee.detector.is_free(start, referee.positions)
    mujoco.mj_step(model, data)
    assert referee.check().is_free and referee.report.bad_steps == [0]
    assert str(referee.report).startswith("2 steps, 1 of them with contacts")


@pytest.mark.parametrize("offset", [1e-6, 0.1])
def test_a_post_out_of_reach_is_proven_free(offset: float) -> None:
    """On its curve the bar's corner passes the post at a distance of a millionth."""
    reach = np.hypot(1, 0.01) + 0.002 + offset
    model, data = loaded(SWEEP.format(x=0, y=reach))
    data.qvel[0] = 30
    referee = tamis.mujoco.Referee(model, data)
    for _ in range(3):
        mujoco.mj_step(model, data)
        assert referee.check().is_free
    assert referee.report.is_free and str(referee.report) == "3 steps, all free"


CLOTH = """
<mujoco>
  <option integrator="discrete" timestep="0.002"><flag contact="{contact}"/></option>
  <worldbody>
    <geom name="floor" type="plane" size="0 0 1" pos="0 0 {floor}"/>
    <flexcomp name="cloth" type="grid" count="6 6 1" spacing=".05 .05 .05" radius="0.005" dim="2" mass="0.1">
      <contact selfcollide="auto"/>
      <elasticity young="1e4" poisson="0.1" thickness="1e-3" elastic2d="both"/>
    </flexcomp>
  </worldbody>
</mujoco>"""


def test_a_cloth_that_falls_through_the_floor_is_named() -> None:
    model, data = loaded(CLOTH.format(contact="disable", floor=-0.05))
    referee = tamis.mujoco.Referee(model, data)
    assert referee.names == ["cloth", "floor"]
    for _ in range(60):
        mujoco.mj_step(model, data)
        referee.check()
    first = referee.report.meetings[0]
    assert (first.first, first.second) == ("cloth", "floor")
    assert first.time == pytest.approx(np.sqrt(2 * 0.05 / 9.81), abs=0.002)  # steps are 0.002 long


def test_a_cloth_that_lands_is_free() -> None:
    model, data = loaded(CLOTH.format(contact="enable", floor=-0.007))
    referee = tamis.mujoco.Referee(model, data)
    for _ in range(60):
        mujoco.mj_step(model, data)
        referee.check()
    assert referee.report.is_free and data.ncon > 0


def test_a_solid_moved_by_nodes_and_a_rope() -> None:
    xml = """
<mujoco>
  <option integrator="discrete" gravity="0 0 0"/>
  <worldbody>
    <flexcomp name="solid" type="grid" count="4 4 4" spacing=".1 .1 .1" radius=".01" dim="3" mass="1" dof="trilinear">
      <elasticity young="1e4" poisson="0.1"/><contact selfcollide="none"/>
    </flexcomp>
    <flexcomp name="rope" type="grid" count="8 1 1" spacing=".1 .1 .1" radius=".01" dim="1" mass="1" pos="0 0 1">
      <edge equality="true"/><contact selfcollide="none"/>
    </flexcomp>
  </worldbody>
</mujoco>"""
    model, data = loaded(xml)
    referee = tamis.mujoco.Referee(model, data)
    mesh = referee.detector.mesh
    assert len(mesh.faces) == 108 and mesh.vertex_count == 64 + 8
    assert np.allclose(referee.positions, data.flexvert_xpos)
    mujoco.mj_step(model, data)
    assert referee.check().is_free


def test_what_is_no_single_step_is_refused() -> None:
    model, data = loaded(SWEEP.format(x=2, y=2))
    referee = tamis.mujoco.Referee(model, data)
    with pytest.raises(tamis.InvalidStep, match="call check\\(\\) after every mj_step"):
        referee.check()
    mujoco.mj_step(model, data, 2)
    with pytest.raises(tamis.InvalidStep, match=r"advanced by 0.1 .* a step takes 0.05"):
        referee.check()
    mujoco.mj_resetData(model, data)
    referee.restart()
    mujoco.mj_step(model, data)
    assert referee.check().is_free


RESTING = """
<mujoco>
  <worldbody>
    <geom name="floor" type="plane" size="5 5 .1"/>
    <geom name="wall" type="box" size=".1 1 1" pos="1 0 1"/>
    <body name="free" pos="0 0 .11"><freejoint/><geom name="box" type="box" size=".1 .1 .1"/></body>
    <body name="hand" mocap="true" pos="2 0 1"><geom name="hand" type="box" size=".1 .1 .1"/></body>
  </worldbody>
</mujoco>"""


def test_positions_set_by_hand_are_refused() -> None:
    """Bug: a free body that was set behind a wall counted as having gone through it in one step."""
    model, data = loaded(RESTING)
    referee = tamis.mujoco.Referee(model, data)
    mujoco.mj_step(model, data)
    data.qpos[0] += 3
    with pytest.raises(
        tamis.InvalidStep, match=r"free is 3 from where its velocity takes it .* call check\(\) right after"
    ):
        referee.check()
    referee.restart()
    mujoco.mj_step(model, data)
    referee.check()


def test_what_no_joint_carries_passes_what_stands_as_in_mujoco() -> None:
    model, data = loaded(RESTING)
    referee = tamis.mujoco.Referee(model, data)
    mujoco.mj_step(model, data)
    data.mocap_pos[0, 0] = 0
    assert referee.check().is_free
    assert data.ncon == 0


def test_a_body_that_spins_too_fast_is_refused() -> None:
    model, data = loaded(ARM)
    referee = tamis.mujoco.Referee(model, data)
    mujoco.mj_step(model, data)
    data.qvel[-1] = 400
    with pytest.raises(tamis.InvalidStep, match="free turns by more than half a turn"):
        referee.check()


def test_bad_input() -> None:
    model, data = loaded(SWEEP.format(x=2, y=2))
    with pytest.raises(tamis.InvalidOptions, match="tolerance is 0"):
        tamis.mujoco.Referee(model, data, tolerance=0)
    with pytest.raises(tamis.InvalidOptions, match=r"model is .*give a mujoco.MjModel"):
        tamis.mujoco.Referee("model", data)
    empty, nothing = loaded("<mujoco/>")
    with pytest.raises(tamis.InvalidMesh, match="nothing to watch"):
        tamis.mujoco.Referee(empty, nothing)
    hills = """<mujoco><asset><hfield name="h" nrow="2" ncol="2" size="1 1 1 1" elevation="0 1 0 1"/></asset>
      <worldbody><geom name="hills" type="hfield" hfield="h"/></worldbody></mujoco>"""
    with pytest.raises(tamis.InvalidMesh, match="hills is a geom of the type hfield"):
        tamis.mujoco.Referee(*loaded(hills))
    model, data = loaded(CLOTH.format(contact="disable", floor=-0.05))
    with pytest.raises(tamis.InvalidStep, match="give a larger plane_reach"):
        tamis.mujoco.Referee(model, data, plane_reach=0.01)
