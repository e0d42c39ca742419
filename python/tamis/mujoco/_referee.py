"""Follows a simulation step by step, and proves each step free of contacts or names them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles, Indices
from tamis._checks import instance, number_from_zero
from tamis._detector._detector import Detector
from tamis._errors import InvalidOptions, InvalidStep
from tamis._motion import CurvedMotion, Motion, StraightMotion
from tamis._options import query_options
from tamis._paths._path import Path
from tamis._paths._rigid_path import RigidPath
from tamis._tables._near import Intersections
from tamis.mujoco._kinematics import Carriers
from tamis.mujoco._steps import RefereedStep, RefereeReport, meetings_of
from tamis.mujoco._surfaces import may_touch, name_of, surfaces_of, vertices_by_nodes

# Of the size of the scene: how far positions that MuJoCo computes may be from those that the chains of joints give.
_SEAM = 1e-10


@dataclass(frozen=True)
class _Turned:
    """Vertices with a place in the frame of a body that turns."""

    vertices: npt.NDArray[np.intp]
    bodies: Indices
    in_body: Doubles

    @classmethod
    def of(cls, which: npt.NDArray[np.bool_], bodies: Indices, in_body: Doubles) -> _Turned:
        """Choose some of all vertices."""
        return cls(np.flatnonzero(which), bodies[which], in_body[which])

    def add(self, state: Any, points: Doubles) -> None:
        """Add to the places of their bodies, as a `MjData` has them, where they are in their frames."""
        if len(self.vertices):
            turns = state.xmat[self.bodies].reshape(-1, 3, 3)
            points[self.vertices] += np.einsum("nij,nj->ni", turns, self.in_body)


class Referee:
    """Asks of each step of a MuJoCo simulation whether anything has passed through anything.

    >>> referee = tamis.mujoco.Referee(model, data)
    >>> while data.time < 1:
    ...     mujoco.mj_step(model, data)
    ...     step = referee.check()
    ...     if not step.is_free:
    ...         print(step)

    Surfaces are those that MuJoCo collides: flexes (triangles, the shell of solids, edges of ropes) and geoms with a
    bit for contacts. Meshes are taken as their own triangles, whose hull MuJoCo collides. Spheres, capsules, cylinders
    and ellipsoids become triangles around them, at most `tolerance` farther out: who comes from outside and does not
    touch these does not touch the true surface. A plane is a square.

    Between two states the motion is MuJoCo's own: each joint at the constant velocity that takes one to the other, each
    body carried by its parents on its curve; vertices of flexes go straight, in the frame of what carries them; mocap
    bodies go straight and turn about a fixed axis. Free means: no two surfaces touch at any time of the step. That a
    run is free is this of every step, and of the first state that nothing passes through anything there:
    `intersections`.

    Parameters
    ----------
    model : mujoco.MjModel
        Which surfaces may touch is what its bits, bodies and lists of pairs say. Read once.
    data : mujoco.MjData
        The simulation to follow, from its present state on. It is read, never written.
    min_separation : float
        d >= 0, in the model's unit of length: contact means a distance <= d.
    tolerance : float
        > 0, in the model's unit of length: how far outside a curved surface its triangles may be. Less than the radius
        of a flex, so that one that rests on the surface does not touch the triangles.
    plane_reach : float, optional
        > 0: half the side of the square that stands for a plane; by default ten times the model's extent.
    threads : int
        To use; 0: all. Speed only.

    Raises
    ------
    InvalidMesh
        A height field or a signed distance field that collides; no surface at all.
    InvalidOptions
        An option outside its range.
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
        self._now, self._before = mujoco.MjData(model), mujoco.MjData(model)
        self._set_up_vertices()
        self.detector = Detector(
            self._surfaces.mesh,
            threads=threads,
            min_separation=min_separation,
            groups=self._surfaces.groups,
            may_touch=may_touch(model, self._surfaces.parts),
        )
        self._asking = query_options(None, "report")
        self._report = RefereeReport()
        self.restart()

    @property
    def names(self) -> list[str]:
        """Of the surfaces, as the model names them; a surface is a group of `detector`, by its number in this list."""
        return [part.name for part in self._surfaces.parts]

    @property
    def report(self) -> RefereeReport:
        """How many steps were checked so far, and what met in them."""
        return self._report

    @property
    def positions(self) -> Doubles:
        """Of all vertices of `detector.mesh` in the last state that was seen, shape (n, 3)."""
        return self._points

    def restart(self) -> None:
        """Go on from the present state, whatever was before: after a reset, or when positions were set by hand."""
        self._look()

    def intersections(self) -> Intersections:
        """Find what passes through what in the last state that was seen, exactly; the first state is the one to ask."""
        return self.detector.intersections(self._points)

    def check(self) -> RefereedStep:
        """Prove the step from the last state that was seen to the present one free, or name what touches.

        Call it after every `mj_step`.

        Returns
        -------
        RefereedStep
            Its contacts, with the surfaces they are between and the simulated time of each.

        Raises
        ------
        InvalidStep
            The simulation has gone on by more or less than one step, or a body has turned too far in one; or positions
            are not where joints at constant velocity take them. Call `restart` where that was meant.
        """
        start, span = self._points, (self._now.time, self._data.time)
        self._require_one_step(*span)
        self._look()
        found = self.detector._contacts_of(self._motion(start, self._points), self._asking)
        report = self._report
        met = meetings_of(found, self._surfaces.groups, self.names, report.steps, span)
        report.steps += 1
        report.meetings += met
        return RefereedStep(report.steps - 1, *span, found, met)

    def _set_up_vertices(self) -> None:
        model, parts, carriers = self._model, self._surfaces.parts, self._carriers
        bodies, in_body = np.concatenate([part.bodies for part in parts]), np.vstack([part.points for part in parts])
        self._carrier = carriers.of_body[bodies]
        self._turning = np.flatnonzero(self._carrier)
        self._by_nodes = list(vertices_by_nodes(model, parts))
        is_sliding, is_moving = carriers.is_sliding[bodies], carriers.is_moving[bodies]
        for mine, _ in self._by_nodes:
            is_sliding[mine] = True
        self._sliding = np.flatnonzero((self._carrier > 0) & is_sliding)
        is_turned = is_moving & (self._carrier > 0) & in_body.any(axis=1)
        self._turned = _Turned.of(is_turned, bodies, in_body)
        mujoco.mj_kinematics(model, self._now)
        shifts = np.zeros_like(in_body)
        _Turned.of(~is_turned, bodies, in_body).add(self._now, shifts)
        self._points: Doubles = self._now.xpos[bodies] + shifts
        moving = np.flatnonzero(is_moving)
        self._moving, self._bodies = _span(moving), _span(bodies[moving])
        self._shifts = shifts[moving] if shifts[moving].any() else None
        self._planes = [part for part in parts if part.is_plane]

    def _look(self) -> None:
        """Copy the present state, and compute where it puts every vertex."""
        self._now, self._before = self._before, self._now
        model, data, now = self._model, self._data, self._now
        now.time, now.qpos[:] = data.time, data.qpos
        if model.nmocap:
            now.mocap_pos[:], now.mocap_quat[:] = data.mocap_pos, data.mocap_quat
        mujoco.mj_kinematics(model, now)
        self._points = self._points.copy()
        moved = now.xpos[self._bodies]
        self._points[self._moving] = moved if self._shifts is None else moved + self._shifts
        self._turned.add(now, self._points)
        if self._by_nodes:
            mujoco.mj_flex(model, now)
        for mine, theirs in self._by_nodes:
            self._points[mine] = now.flexvert_xpos[theirs]
        self._require_reach()

    def _require_reach(self) -> None:
        """No vertex may leave the square that stands for a plane."""
        if not self._planes:
            return
        moved = self._points[self._moving]
        # The farthest that a coordinate can tell, which is next to always enough.
        most = max(np.maximum.reduce(moved, axis=None, initial=0), -np.minimum.reduce(moved, axis=None, initial=0))
        for plane in self._planes:
            centre = self._now.geom_xpos[plane.geom]
            if 2 * (most + max(map(abs, centre.tolist()))) <= self._reach:
                continue
            across = self._now.geom_xmat[plane.geom].reshape(3, 3)[:, :2]
            far = np.abs((moved - centre) @ across).max(initial=0)
            if far > self._reach:
                raise InvalidStep(
                    f"a vertex is {far:.6g} from the middle of {plane.name}, and the square that stands for this "
                    f"plane ends at {self._reach:.6g}: give a larger plane_reach"
                )

    def _motion(self, start: Doubles, end: Doubles) -> Motion:
        """Return a straight step where nothing turns, else a path."""
        turning = self._carriers.chains(self._before, self._now)
        if turning is None:
            return StraightMotion(start, end)
        chains, origins = turning
        rest, rest_end, some = start.copy(), end.copy(), self._turning
        rest[some] -= origins[self._carrier[some]]
        rest_end[some] = rest[some]
        self._pull_back(rest_end, end, origins)
        path = RigidPath(rest, self._carrier, chains, rest_end)
        self._require_seam(path, end)
        return CurvedMotion(path)

    def _pull_back(self, rest_end: Doubles, end: Doubles, origins: Doubles) -> None:
        """Write where vertices that slide in a turning frame are in it at the end."""
        some = self._sliding
        if not len(some):
            return
        carrier, bodies = self._carrier[some], self._carriers.bodies
        first, last = (data.xmat[bodies].reshape(-1, 3, 3) for data in (self._before, self._now))
        back = first @ last.transpose(0, 2, 1)
        since = end[some] - self._now.xpos[bodies][carrier]
        rest_end[some] = np.einsum("nij,nj->ni", back[carrier], since)
        rest_end[some] += (self._before.xpos[bodies] - origins)[carrier]

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
                f"the simulation has gone on by {passed:.9g} since it was looked at last, and a step takes {step:.9g}: "
                "call check() after every mj_step, or restart() after a reset"
            )
        body = self._carriers.turned_too_far(self._data.qvel, step)
        if body is not None:
            name = name_of(self._model, mujoco.mjtObj.mjOBJ_BODY, body)
            raise InvalidStep(
                f"{name} turns by more than half a turn in one step, and the states at both ends do not show which "
                "way: take a shorter timestep"
            )


def _span(numbers: npt.NDArray[Any]) -> npt.NDArray[Any] | slice:
    """Return the same as a slice where each is one more than the last, which spares NumPy a copy."""
    first = int(numbers[0]) if len(numbers) else 0
    last = first + len(numbers)
    return slice(first, last) if np.array_equal(numbers, np.arange(first, last)) else numbers


def _above_zero(given: Any, name: str) -> float:
    value = number_from_zero(given, name)
    if value == 0:
        raise InvalidOptions(f"{name} is 0: give a number > 0")
    return value
