"""Tamis inside Newton's VBD solver."""

from __future__ import annotations

import warnings
from time import perf_counter
from typing import Any

import numpy as np

from tamis._checks import number, number_from_zero, truth
from tamis._errors import InvalidOptions
from tamis.newton._contact_lists import ContactLists
from tamis.newton._report import AttachmentReport
from tamis.newton._surface import Surface


def attach(
    solver: Any, *, one_ring: bool = True, keep: float = 0.1, min_separation: float = 0.0, threads: int = 0
) -> Attachment:
    """Let Tamis detect self-contacts for a VBD solver, and bound how far its particles go.

    Parameters
    ----------
    solver : newton.solvers.SolverVBD
        Made with `particle_enable_self_contact`. No CUDA graph of it may be captured: a graph would not call Tamis.
    one_ring : bool
        Whether pairs count that an edge joins; Newton leaves these to bending. Their contact forces still depend on
        Newton's `particle_topological_contact_filter_threshold`.
    keep : float
        The fraction of its distance at the start of a step, as far as that exceeds `min_separation`, that every pair
        keeps; 0 < keep < 1.
    min_separation : float
        d >= 0, in the model's unit of length: no pair comes nearer.
    threads : int
        The number of threads that Tamis uses, >= 0; 0: all. Changes speed only.

    Returns
    -------
    Attachment
        Reports on the steps; its `detach` undoes `attach`.

    Raises
    ------
    InvalidOptions
        An option outside its range; `solver` is not a SolverVBD, has no self-contact, has a collision pipeline or an
        attachment, or truncates rigid bodies, too.
    """
    _check_solver(solver)
    if not 0 < number(keep, "keep") < 1:
        raise InvalidOptions(f"keep is {keep}: give a number > 0 and < 1")
    return Attachment(solver, truth(one_ring, "one_ring"), keep, min_separation, threads)


def _check_solver(solver: Any) -> None:
    from newton.solvers import SolverVBD

    if not isinstance(solver, SolverVBD):
        raise InvalidOptions(f"solver is of the type {type(solver).__name__}: give a newton.solvers.SolverVBD")
    if not solver.particle_enable_self_contact or solver.model.tri_count == 0:
        raise InvalidOptions("the solver has no self-contact: make it with particle_enable_self_contact=True")
    if solver.rigid_soft_enable_dat:
        raise InvalidOptions("the solver truncates rigid bodies, too: make it with rigid_soft_enable_dat=False")
    if solver.collision_pipeline is not None:
        raise InvalidOptions("the solver detects self-contacts by a collision_pipeline: make it without one")
    if "_penetration_free_truncation" in vars(solver):
        raise InvalidOptions("the solver has an attachment: detach that first")


class Attachment:
    """Tamis in one solver, as `attach` returns it. The solver keeps it alive.

    Attributes
    ----------
    detector : Detector
        The detector that answers; its mesh has Newton's triangles, in their order.
    report : AttachmentReport
        Counts and times so far.
    """

    def __init__(self, solver: Any, one_ring: bool, keep: float, min_separation: float, threads: int) -> None:
        if solver.device.is_cuda:
            warnings.warn(f"positions are copied from {solver.device} and back for each iteration", stacklevel=3)
        separation = number_from_zero(min_separation, "min_separation")
        surface = Surface(solver.model)
        self.detector = surface.detector(one_ring=one_ring, min_separation=separation, threads=threads)
        self.report = AttachmentReport()
        self._keep = keep
        self._solver = solver
        self._held = surface.held
        self._lists = ContactLists(solver, surface)
        self._end: Any = None
        self._is_near = False
        self._iterations_left = 0
        self._replaced = {
            "_collision_detection_penetration_free": self._detect,
            "_penetration_free_truncation": self._move,
            "_initialize_particles": self._initialize,
            "_solve_particle_iteration": self._iterate,
            "rebuild_bvh": lambda state: None,  # its hierarchy is no longer used
        }
        self._original = {name: getattr(solver, name) for name in self._replaced}
        vars(solver).update(self._replaced)

    def detach(self) -> None:
        """Give the solver its own detection back. Its buffers keep the last pairs."""
        for name in self._replaced:
            vars(self._solver).pop(name, None)

    def _detect(self, state: Any, *, reset_reference: bool = True) -> None:
        begin = perf_counter()
        solver = self._solver
        if solver.device.is_capturing:
            raise InvalidOptions("a graph is being captured, which would hold nothing of Tamis: step without one")
        if reset_reference:
            solver.pos_prev_collision_detection.assign(state.particle_q)
            solver.particle_displacements.zero_()
        near = self.detector.pairs_within(state.particle_q.numpy(), solver._self_contact_query_radius)
        self._is_near = len(near) > 0
        self._lists.fill(near)
        self.report.detection_seconds += perf_counter() - begin

    def _move(self, state: Any, contacts: Any) -> None:
        """Move each particle as the solver wants, but only as far as the contact lists hold all near pairs.

        `_settle` makes the result free of contacts.
        """
        import warp as wp
        from newton._src.solvers.vbd.particle_vbd_kernels import apply_truncation_ts

        solver = self._solver
        farthest = 0.5 * solver._self_contact_query_radius * solver.dat_conservative_bound_relaxation
        solver.truncation_ts.fill_(1.0)
        wp.launch(
            kernel=apply_truncation_ts,
            dim=solver.model.particle_count,
            inputs=[
                solver.pos_prev_collision_detection,
                solver.particle_displacements,
                solver.truncation_ts,
                farthest,
            ],
            outputs=[solver.particle_displacements, state.particle_q],
            device=solver.device,
        )

    def _initialize(self, state_in: Any, state_out: Any, contacts: Any, dt: float) -> None:
        self._look_at_start(state_in.particle_q.numpy())
        self._iterations_left = self._solver.iterations
        self._original["_initialize_particles"](state_in, state_out, contacts, dt)
        self._settle(state_in)

    def _iterate(self, state_in: Any, state_out: Any, contacts: Any, dt: float) -> None:
        self._iterations_left -= 1
        self._original["_solve_particle_iteration"](state_in, state_out, contacts, dt)
        self._settle(state_in)
        state_out.particle_q.assign(state_in.particle_q)
        self._end = state_out.particle_q.numpy().copy()

    def _look_at_start(self, start: Any) -> None:
        """Warn if the caller has moved vertices through others since the last step, or starts with intersections."""
        begin = perf_counter()
        self.report.steps += 1
        if self._end is None:
            is_bad = self.detector.has_intersection(start)
        else:
            is_bad = not (np.array_equal(self._end, start) or self.detector.is_free(self._end, start))
        self.report.moved_into_contact += is_bad
        if is_bad:
            warnings.warn(
                "a step starts where vertices are through others, or were moved through them from outside: "
                "such pairs are kept as they are",
                stacklevel=2,
            )
        self.report.truncation_seconds += perf_counter() - begin

    def _settle(self, state: Any) -> None:
        """Hold back vertices that would come too near to others on the way from the start of the step.

        The last iteration needs it, as the step ends there. Iterations before are held back if any pair is near. So
        contact forces see positions at which nothing has passed through anything. If no pair is near, no vertex goes
        half the way to another feature.
        """
        if self._iterations_left > 0 and not self._is_near:
            return
        begin = perf_counter()
        solver = self._solver
        start, wanted = solver.particle_q_prev.numpy(), state.particle_q.numpy()
        if not np.array_equal(start[self._held], wanted[self._held]):
            raise InvalidOptions("particles that were inactive or without mass when attached move now: attach again")
        step = self.detector.truncate(start, wanted, self._keep, stored="float32")
        end = step.positions.astype(np.float32)
        if not np.array_equal(end, wanted):
            self.report.shortened += 1
            state.particle_q.assign(end)
            solver.particle_displacements.assign(end - solver.pos_prev_collision_detection.numpy())
        self.report.truncation_seconds += perf_counter() - begin
