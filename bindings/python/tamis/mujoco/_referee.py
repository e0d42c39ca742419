"""Follows a simulation step by step, and proves each step free of contacts or names the contacts."""

from __future__ import annotations

from typing import Any

import mujoco
import numpy as np

from tamis._arrays import Doubles
from tamis._checks import instance, number_from_zero
from tamis._detector._detector import Detector
from tamis._errors import InvalidOptions, InvalidStep
from tamis._motion import AskedMotion, CurvedMotion, StraightMotion, own_options
from tamis._paths._path import Path
from tamis._tables._near import Intersections
from tamis.mujoco._kinematics import Carriers
from tamis.mujoco._pins import Pins
from tamis.mujoco._places import Places
from tamis.mujoco._steps import RefereedStep, RefereeReport, meetings_of
from tamis.mujoco._surfaces import may_touch, name_of, surfaces_of
from tamis.mujoco._watch import Watch

# Tolerance of positions by chains of joints against MuJoCo's, relative to the largest coordinate of the scene.
_SEAM = 1e-10
# Tolerance of joint positions after a step against those by its velocities, relative to 1 + the largest |qpos|.
_STEP_SEAM = 1e-9


class Referee:
    """Proves each step of a MuJoCo simulation free of contacts, or says which surfaces touch and when.

    >>> referee = tamis.mujoco.Referee(model, data)
    >>> while data.time < 1:
    ...     mujoco.mj_step(model, data)
    ...     step = referee.check()
    ...     if not step.is_free:
    ...         print(step)

    Surfaces are those that MuJoCo collides: flexes (triangles, the shell of solids, edges of ropes), and geoms that can
    collide. A mesh is its own triangles; MuJoCo collides its convex hull. Spheres, capsules, cylinders and ellipsoids
    become triangles around them, at most `tolerance` farther out: a surface outside that does not touch these does not
    touch the true surface. A plane is a triangle around a square.

    Between two states the motion is MuJoCo's own. Each joint moves at the constant velocity that leads from one state
    to the other, and bodies are carried on curves by all joints above them. Vertices of flexes go straight in the frame
    of the body that carries them. Mocap bodies go straight and turn about a fixed axis. A step is free if no two
    surfaces touch at any time of it. A run is free if its first state has no `intersections` and every step is free.

    Parameters
    ----------
    model : mujoco.MjModel
        Its bits, bodies, parents and lists of pairs say which surfaces may touch. It is read once and must not change.
    data : mujoco.MjData
        The simulation to follow, from its present state on. It is read, never written.
    min_separation : float
        d >= 0, in the model's unit of length: contact means Euclidean distance <= d.
    tolerance : float
        > 0, in the model's unit of length: the largest distance of triangles from the curved surface that they
        surround. Take less than the radius of a flex: then a flex at rest on the surface does not touch them.
    plane_reach : float, optional
        > 0, in the model's unit of length: half the side of the square that stands for a plane. By default ten times
        the model's extent.
    threads : int
        The number of threads to use, >= 0; 0: all. Changes speed only.

    Attributes
    ----------
    detector : Detector
        The detector that answers. Each surface is a group of it, with the surface's place in `names` as its number.

    Raises
    ------
    InvalidMesh
        A height field or a signed distance field collides, or the model has no surface.
    InvalidOptions
        An option outside its range, or a tolerance so small that a round surface needs more than two million triangles.
    """

    def __init__(
        self,
        model: Any,
        data: Any,
        *,
        min_separation: float = 0.0,
        tolerance: float = 5e-4,
        plane_reach: float | None = None,
        threads: int = 0,
    ) -> None:
        self._model = instance(model, mujoco.MjModel, "model", "a mujoco.MjModel")
        self._data = instance(data, mujoco.MjData, "data", "the mujoco.MjData of this model")
        self._reach = 10 * model.stat.extent if plane_reach is None else _above_zero(plane_reach, "plane_reach")
        self._surfaces = surfaces_of(model, _above_zero(tolerance, "tolerance"), self._reach)
        self._carriers = Carriers(model)
        self._places = Places(model, self._surfaces.parts, self._carriers)
        self._pins = Pins(model, self._surfaces.parts)
        states = [self._places.now, self._places.before]
        self._watch = Watch(model, states, self._surfaces.parts, self._carriers.is_moving)
        self._planes = [part for part in self._surfaces.parts if part.is_plane]
        self.detector = Detector(
            self._surfaces.mesh,
            threads=threads,
            min_separation=min_separation,
            groups=self._surfaces.groups,
            may_touch=may_touch(model, self._surfaces.parts),
        )
        self._report = RefereeReport()
        self.restart()

    @property
    def names(self) -> list[str]:
        """The model's names of the surfaces, in the order of the detector's groups."""
        return [part.name for part in self._surfaces.parts]

    @property
    def report(self) -> RefereeReport:
        """The number of steps that were checked so far, and the surfaces that met in them."""
        return self._report

    @property
    def positions(self) -> Doubles:
        """Where the vertices of `detector.mesh` are in the last state that was seen, shape (n, 3)."""
        return self._places.points

    def restart(self) -> None:
        """Continue from the present state. Call it after a reset, or when positions were set by hand."""
        self._look()

    def intersections(self) -> Intersections:
        """Find every intersection in the last state that was seen. Decided exactly. Call it before the first step."""
        return self._pins.without_intersections(self.detector.intersections(self._places.points))

    def check(self) -> RefereedStep:
        """Prove the step from the last state that was seen to the present state free, or name its contacts.

        Call it after every `mj_step`.

        Returns
        -------
        RefereedStep
            The contacts of the step, and the pairs of surfaces that meet, each with the simulated time.

        Raises
        ------
        InvalidStep
            The simulation has gone on by more or less than one step. A body has turned by (nearly) half a turn or more.
            Positions are not where the velocities take them, for example because they were set by hand: call `restart`
            if that was intended. A vertex has left the square of a plane. Or the model's surfaces were changed: make
            another referee.
        """
        start, span = self._places.points, (self._places.now.time, self._data.time)
        self._require_one_step(*span)
        self._require_integrated()
        self._look()
        moving = self._motion(start)
        found = self._pins.without(self.detector._contacts_of(moving, own_options(moving)))
        report = self._report
        met = meetings_of(found, self._surfaces.groups, self.names, report.steps, span)
        report.steps += 1
        report.meetings += met
        return RefereedStep(report.steps - 1, *span, found, met)

    def _look(self) -> None:
        self._places.look(self._data)
        self._watch.require_same(self._places.now)
        self._require_reach()

    def _require_reach(self) -> None:
        """Raise if a vertex has left the square that stands for a plane."""
        if not self._planes:
            return
        moved, now = self._places.moving_points, self._places.now
        # A bound by the largest coordinate, which is nearly always enough.
        most = max(np.maximum.reduce(moved, axis=None, initial=0), -np.minimum.reduce(moved, axis=None, initial=0))
        for plane in self._planes:
            centre = now.geom_xpos[plane.geom]
            if 2 * (most + max(map(abs, centre.tolist()))) <= self._reach:
                continue
            across = now.geom_xmat[plane.geom].reshape(3, 3)[:, :2]
            far = np.abs((moved - centre) @ across).max(initial=0)
            if far > self._reach:
                raise InvalidStep(
                    f"a vertex is {far:.6g} from the middle of {plane.name}, and the square that stands for this "
                    f"plane ends at {self._reach:.6g}: give a larger plane_reach"
                )

    def _motion(self, start: Doubles) -> AskedMotion:
        """Return the motion from the state before to the present one: a step if nothing turns, else a path."""
        path, end = self._places.path(start), self._places.points
        if path is None:
            return StraightMotion(start, end)
        self._require_seam(path, end)
        return CurvedMotion(path)

    def _require_seam(self, path: Path, end: Doubles) -> None:
        gap, size = np.abs(path.points_at(1) - end).max(axis=1), np.abs(end).max()
        worst = int(gap.argmax())
        if gap[worst] > _SEAM * size:
            name = self.names[self._surfaces.groups[worst]]
            raise InvalidStep(
                f"{name} is {gap[worst]:.3g} from where joints at constant velocity take it: call restart() where "
                "positions were set by hand"
            )

    def _require_one_step(self, start: float, end: float) -> None:
        step, passed = self._model.opt.timestep, end - start
        if not abs(passed - step) <= 1e-6 * step:
            raise InvalidStep(
                f"the simulation advanced by {passed:.9g} since the last check, and a step takes {step:.9g}: "
                "call check() after every mj_step, or restart() after a reset"
            )
        body = self._carriers.turned_too_far(self._data.qvel, step)
        if body is not None:
            name = name_of(self._model, mujoco.mjtObj.mjOBJ_BODY, body)
            raise InvalidStep(
                f"{name} turns by more than half a turn in one step, and the states at both ends do not show which "
                "way: take a shorter timestep"
            )

    def _require_integrated(self) -> None:
        """Raise if positions are not where this step's velocities take them; not with RK4, which goes another way."""
        before, data, step = self._places.now.qpos, self._data, self._model.opt.timestep
        if self._model.opt.integrator == mujoco.mjtIntegrator.mjINT_RK4:
            return
        velocities = np.empty(self._model.nv)
        mujoco.mj_differentiatePos(self._model, velocities, step, before, data.qpos)
        gaps = np.abs(velocities - data.qvel) * step
        if gaps.max(initial=0) > _STEP_SEAM * (1 + np.abs(data.qpos).max(initial=0)):
            body = int(self._model.dof_bodyid[gaps.argmax()])
            name = name_of(self._model, mujoco.mjtObj.mjOBJ_BODY, body)
            raise InvalidStep(
                f"{name} is {gaps.max():.3g} from where its velocity takes it in this step: call check() right after "
                "mj_step, and restart() where positions were set by hand"
            )


def _above_zero(given: Any, name: str) -> float:
    value = number_from_zero(given, name)
    if value == 0:
        raise InvalidOptions(f"{name} is 0: give a number > 0")
    return value
