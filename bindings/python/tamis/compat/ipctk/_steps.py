"""Questions about poses and steps with ipctk's names."""

from __future__ import annotations

import numpy.typing as npt

from tamis._arrays import Doubles, finite, rows
from tamis._checks import instance, number, number_from_zero
from tamis._errors import InvalidStep
from tamis.compat.ipctk._broad_phase import BroadPhase
from tamis.compat.ipctk._mesh import CollisionMesh, detector_of
from tamis.compat.ipctk._narrow_phase import NarrowPhaseCCD, TightInclusionCCD


def has_intersections(mesh: CollisionMesh, vertices: npt.ArrayLike, broad_phase: BroadPhase | None = None) -> bool:
    """Tell whether any edge passes through a triangle or touches it. Decided exactly."""
    detector = detector_of(mesh)
    _accept(broad_phase)
    positions = rows(vertices, "vertices")
    may = mesh.can_collide
    if may is None:
        return detector.has_intersection(positions)
    found = detector.intersections(positions)  # which do not ask the detector's filter
    return any(
        any(may(a, b) for a in edge for b in face) for edge, face in zip(found.edge.tolist(), found.face.tolist())
    )


def is_step_collision_free(
    mesh: CollisionMesh,
    vertices_t0: npt.ArrayLike,
    vertices_t1: npt.ArrayLike,
    min_distance: float = 0.0,
    broad_phase: BroadPhase | None = None,
    narrow_phase_ccd: NarrowPhaseCCD | None = None,
) -> bool:
    """Tell whether the whole step is free of contacts: exactly, while ipctk may say False if a pair only comes near."""
    _accept(broad_phase)
    _kept_fraction(narrow_phase_ccd)
    start, end, distance = _step(vertices_t0, vertices_t1, min_distance)
    return detector_of(mesh).is_free(start, end, min_separation=distance)


def compute_collision_free_stepsize(
    mesh: CollisionMesh,
    vertices_t0: npt.ArrayLike,
    vertices_t1: npt.ArrayLike,
    min_distance: float = 0.0,
    broad_phase: BroadPhase | None = None,
    narrow_phase_ccd: NarrowPhaseCCD | None = None,
) -> float:
    """Return how far the step may go, in [0, 1], while every pair keeps the narrow phase's `kept_fraction`.

    It is proven that every pair keeps this fraction of its distance until then.
    """
    _accept(broad_phase)
    kept = _kept_fraction(narrow_phase_ccd)
    start, end, distance = _step(vertices_t0, vertices_t1, min_distance)
    return detector_of(mesh).safe_step(start, end, kept, min_separation=distance).toi_lower


class Candidates:
    """Stores no candidates, as Tamis needs no list of them: the calls answer for all pairs of the mesh."""

    def build(
        self,
        mesh: CollisionMesh,
        vertices_t0: npt.ArrayLike,
        vertices_t1: npt.ArrayLike,
        inflation_radius: float = 0.0,
        broad_phase: BroadPhase | None = None,
    ) -> None:
        """Check the arguments, and do nothing else."""
        detector_of(mesh)
        for name, given in (("vertices_t0", vertices_t0), ("vertices_t1", vertices_t1)):
            finite(rows(given, name), name, InvalidStep)
        number_from_zero(inflation_radius, "inflation_radius")
        _accept(broad_phase)

    def is_step_collision_free(
        self,
        mesh: CollisionMesh,
        vertices_t0: npt.ArrayLike,
        vertices_t1: npt.ArrayLike,
        min_distance: float = 0.0,
        narrow_phase_ccd: NarrowPhaseCCD | None = None,
    ) -> bool:
        """Answer as the function of this name."""
        return is_step_collision_free(mesh, vertices_t0, vertices_t1, min_distance, None, narrow_phase_ccd)

    def compute_collision_free_stepsize(
        self,
        mesh: CollisionMesh,
        vertices_t0: npt.ArrayLike,
        vertices_t1: npt.ArrayLike,
        min_distance: float = 0.0,
        narrow_phase_ccd: NarrowPhaseCCD | None = None,
    ) -> float:
        """Answer as the function of this name."""
        return compute_collision_free_stepsize(mesh, vertices_t0, vertices_t1, min_distance, None, narrow_phase_ccd)


def _accept(broad_phase: BroadPhase | None) -> None:
    """Refuse anything but a broad phase, such as a narrow phase in its place, which would be ignored."""
    if broad_phase is not None:
        instance(broad_phase, BroadPhase, "broad_phase", "None, or a broad phase of tamis.compat.ipctk")


def _kept_fraction(narrow_phase_ccd: NarrowPhaseCCD | None) -> float:
    narrow = TightInclusionCCD() if narrow_phase_ccd is None else narrow_phase_ccd
    return instance(narrow, NarrowPhaseCCD, "narrow_phase_ccd", "a TightInclusionCCD or an AdditiveCCD").kept_fraction


def _step(
    vertices_t0: npt.ArrayLike, vertices_t1: npt.ArrayLike, min_distance: float
) -> tuple[Doubles, Doubles, float]:
    start, end = rows(vertices_t0, "vertices_t0"), rows(vertices_t1, "vertices_t1")
    return start, end, number(min_distance, "min_distance")
