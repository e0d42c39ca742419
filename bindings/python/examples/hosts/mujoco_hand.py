"""A hand of three fingers grasps a cloth that lies over a ball, in MuJoCo; `tamis.mujoco.Referee` follows every step.

MuJoCo's flag `ipc` keeps flexes apart, but does not support moving bodies: this scene is one that it cannot protect.
With ``--scene ball`` a cloth under that flag falls on a ball at rest. Needs ``pip install '.[mujoco]'`` in the clone.
"""

from __future__ import annotations

import argparse
import time
from typing import Any

import mujoco
import numpy as np

import tamis.mujoco


def finger(name: str, angle: int) -> str:
    """Return the XML of a finger: two links, each with a hinge. `angle`: in degrees around the palm."""
    return f"""
      <body name="{name}" pos="0 0 -0.02" euler="0 0 {angle}">
        <body pos="0.055 0 0">
          <joint name="{name}_knuckle" axis="0 1 0" range="-40 70" damping="0.05"/>
          <geom name="{name}_near" type="capsule" fromto="0 0 0 0.02 0 -0.05" size="0.009"/>
          <body pos="0.02 0 -0.05">
            <joint name="{name}_tip" axis="0 1 0" range="-10 80" damping="0.02"/>
            <geom name="{name}_far" type="capsule" fromto="0 0 0 -0.004 0 -0.04" size="0.008" friction="2"/>
          </body>
        </body>
      </body>"""


def cloth(vertices: int, size: float, height: float, radius: float, rest: str) -> str:
    """Return the XML of a square cloth as a flex; `rest`: its remaining attributes and children."""
    spacing = size / (vertices - 1)
    return f"""
    <flexcomp name="cloth" type="grid" count="{vertices} {vertices} 1" spacing="{spacing} {spacing} {spacing}" dim="2"
              radius="{radius}" pos="0 0 {height}" rgba=".2 .5 .9 1" {rest}
    </flexcomp>"""


def hand_scene(vertices: int) -> str:
    """Return the XML of a palm that goes up and down and turns, three fingers, a table, a ball, a cloth over both."""
    names = [f"finger{i}" for i in range(3)]
    fingers = "".join(finger(name, 120 * i) for i, name in enumerate(names))
    motors = "".join(f'<position joint="{n}_knuckle" kp="3"/><position joint="{n}_tip" kp="1.5"/>' for n in names)
    rest = """mass="0.05"><contact selfcollide="auto" solref="0.004 1"/>
      <elasticity young="2e4" poisson="0.2" thickness="1e-3" elastic2d="both" damping="0.002"/>"""
    return f"""
<mujoco>
  <compiler autolimits="true"/>
  <size memory="500M"/>
  <option integrator="discrete" timestep="0.002" solver="Newton" tolerance="1e-6"/>
  <worldbody>
    <light pos="0.4 -0.6 1.2" dir="-.3 .5 -1"/>
    <geom name="table" type="box" size="0.3 0.3 0.01" pos="0 0 -0.01" rgba=".75 .72 .68 1"/>
    <geom name="ball" type="sphere" size="0.03" pos="0 0 0.03" rgba=".8 .2 .2 1"/>
    {cloth(vertices, 0.4, 0.07, 0.002, rest)}
    <body pos="0 0 0.24">
      <joint name="lift" type="slide" axis="0 0 1" range="-0.2 0.2" damping="20"/>
      <joint name="wrist" axis="0 0 1" range="-180 180" damping="1"/>
      <geom name="palm" type="cylinder" size="0.06 0.012" mass="0.5"/>{fingers}
    </body>
  </worldbody>
  <actuator><position joint="lift" kp="400"/><position joint="wrist" kp="5"/>{motors}</actuator>
</mujoco>"""


def ball_scene(vertices: int) -> str:
    """Return the XML of a cloth that falls on a ball under MuJoCo's flag `ipc`."""
    rest = """mass="0.2" euler="10 5 0"><contact selfcollide="auto"/>
      <elasticity young="1e4" poisson="0.1" thickness="1e-3" elastic2d="both" damping="0.005"/>"""
    return f"""
<mujoco>
  <size memory="2G"/>
  <option integrator="discrete" solver="Newton" tolerance="1e-6" timestep="0.002"><flag ipc="enable"/></option>
  <worldbody>
    <geom name="floor" type="plane" size="3 3 .1" pos="0 0 -0.6"/>
    <geom name="ball" type="sphere" size="0.18" pos="0.02 0.01 -0.25"/>
    {cloth(vertices, 1.0, 0.0, 0.001, rest)}
  </worldbody>
</mujoco>"""


def grasp(seconds: float) -> list[float]:
    """Return the targets of the motors at a time: open above the cloth, go down, close, lift, turn."""

    def part(start: float, end: float) -> float:
        return float(np.clip((seconds - start) / (end - start), 0, 1))

    lift, closed = 0.24 * part(0.9, 1.3) - 0.14 * part(0.1, 0.5), part(0.5, 0.8)
    return [lift, 1.5 * part(1.2, 1.8)] + 3 * [-0.4 + 0.95 * closed, 0.2 + 0.5 * closed]


def follow(model: Any, data: Any, steps: int, shown: int) -> None:
    """Simulate, check each step, and print the first `shown` bad steps, a summary, and the times."""
    referee = tamis.mujoco.Referee(model, data, threads=1)
    print(f"surfaces   {', '.join(referee.names)}: {len(referee.detector.mesh.faces):,} triangles")
    print(f"start      {len(referee.intersections())} intersections")
    took: dict[str, list[float]] = {"mj_step": [], "referee": []}
    for _ in range(steps):
        if model.nu:
            data.ctrl[:] = grasp(data.time)
        before = time.perf_counter()
        mujoco.mj_step(model, data)
        between = time.perf_counter()
        step = referee.check()
        took["mj_step"].append(between - before)
        took["referee"].append(time.perf_counter() - between)
        if not step.is_free and len(referee.report.bad_steps) <= shown:
            print(step)
    print(f"run        {referee.report}")
    for pair, count, first in by_pair(referee.report):
        print(f"  {pair:28} in {count:4} steps, first at {first:.6f}")
    for name, seconds in took.items():
        print(f"{name:10} {1e3 * np.median(seconds):.2f} ms a step")


def by_pair(report: tamis.mujoco.RefereeReport) -> list[tuple[str, int, float]]:
    """Return each pair of surfaces that meets, with the number of its meetings and the time of the first."""
    pairs: dict[str, list[float]] = {}
    for meeting in report.meetings:
        pairs.setdefault(" and ".join(dict.fromkeys((meeting.first, meeting.second))), []).append(meeting.time)
    return sorted((pair, len(times), min(times)) for pair, times in pairs.items())


def main() -> None:
    """Read the command line, and follow the scene."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--scene", choices=["hand", "ball"], default="hand")
    options.add_argument("--steps", type=int, default=900)
    options.add_argument("--vertices", type=int, default=21, help="along each side of the cloth")
    options.add_argument("--shown", type=int, default=3, help="how many bad steps to print")
    given = options.parse_args()
    scene = hand_scene if given.scene == "hand" else ball_scene
    model = mujoco.MjModel.from_xml_string(scene(given.vertices))
    follow(model, mujoco.MjData(model), given.steps, given.shown)


if __name__ == "__main__":
    main()
