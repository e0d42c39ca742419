"""Questions about steps by ipctk's names."""

from __future__ import annotations

import numpy.typing as npt

from tamis._errors import InvalidOptions
from tamis.compat.ipctk._broad_phase import BroadPhase
from tamis.compat.ipctk._mesh import CollisionMesh, detector_of
from tamis.compat.ipctk._narrow_phase import NarrowPhaseCCD, TightInclusionCCD


def has_intersections(mesh: CollisionMesh, vertices: npt.ArrayLike, broad_phase: BroadPhase | None = None) -> bool:
    """Tell whether any edge passes through a triangle or touches it: exactly."""
    return detector_of(mesh).has_intersection(vertices)


def is_step_collision_free(
    mesh: CollisionMesh,
    vertices_t0: npt.ArrayLike,
    vertices_t1: npt.ArrayLike,
    min_distance: float = 0.0,
    broad_phase: BroadPhase | None = None,
    narrow_phase_ccd: NarrowPhaseCCD | None = None,
) -> bool:
    """Tell whether the whole step is free of contacts: exactly; ipctk may say no of a step that comes near one."""
    return detector_of(mesh).is_free(vertices_t0, vertices_t1, min_separation=min_distance)


def compute_collision_free_stepsize(
    mesh: CollisionMesh,
    vertices_t0: npt.ArrayLike,
    vertices_t1: npt.ArrayLike,
    min_distance: float = 0.0,
    broad_phase: BroadPhase | None = None,
    narrow_phase_ccd: NarrowPhaseCCD | None = None,
) -> float:
    """Return how far the step may go so that every pair keeps a part of its distance, in [0, 1].

    The part is the narrow phase's `kept_fraction`. That they keep it is proven, and no longer step would do.
    """
    narrow_phase = narrow_phase_ccd or TightInclusionCCD()
    if not 0 < narrow_phase.conservative_rescaling <= 1:
        raise InvalidOptions(
            f"conservative_rescaling is {narrow_phase.conservative_rescaling}: give a number > 0 and <= 1"
        )
    kept = narrow_phase.kept_fraction
    return detector_of(mesh).keep_distance(vertices_t0, vertices_t1, kept, min_separation=min_distance).lower


class Candidates:
    """Stores no candidates: Tamis needs no list of them. The calls answer for all pairs of the mesh."""

    def build(
        self,
        mesh: CollisionMesh,
        vertices_t0: npt.ArrayLike,
        vertices_t1: npt.ArrayLike,
        inflation_radius: float = 0.0,
        broad_phase: BroadPhase | None = None,
    ) -> None:
        """Do nothing."""

    def is_step_collision_free(
        self,
        mesh: CollisionMesh,
        vertices_t0: npt.ArrayLike,
        vertices_t1: npt.ArrayLike,
        min_distance: float = 0.0,
        narrow_phase_ccd: NarrowPhaseCCD | None = None,
    ) -> bool:
        """As the function of this name."""
        return is_step_collision_free(mesh, vertices_t0, vertices_t1, min_distance, None, narrow_phase_ccd)

    def compute_collision_free_stepsize(
        self,
        mesh: CollisionMesh,
        vertices_t0: npt.ArrayLike,
        vertices_t1: npt.ArrayLike,
        min_distance: float = 0.0,
        narrow_phase_ccd: NarrowPhaseCCD | None = None,
    ) -> float:
        """As the function of this name."""
        return compute_collision_free_stepsize(mesh, vertices_t0, vertices_t1, min_distance, None, narrow_phase_ccd)
