"""The calls of ipctk's users for continuous collision detection, by their names and argument orders.

>>> import tamis.compat.ipctk as ipctk  # instead of: import ipctk

Broad phases are accepted and ignored: Tamis has its own, and the answer is that of all pairs. The narrow phases decide
how much of its distance every pair keeps; contacts themselves are decided by Tamis, exactly. Everything else of ipctk
(distances, barriers, potentials, friction) is not here: keep importing ipctk for it.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles, Indices, indices, rows
from tamis._detector import Detector
from tamis._errors import InvalidMesh, InvalidOptions
from tamis._mesh import Mesh
from tamis._pairs import Pairs
from tamis._pairs import edge_edge as _edge_edge
from tamis._pairs import vertex_edge as _vertex_edge
from tamis._pairs import vertex_face as _vertex_face
from tamis._pairs import vertex_vertex as _vertex_vertex

__all__ = [
    "LBVH",
    "AdditiveCCD",
    "BroadPhase",
    "BruteForce",
    "Candidates",
    "CollisionMesh",
    "HashGrid",
    "NarrowPhaseCCD",
    "SpatialHash",
    "SweepAndPrune",
    "TightInclusionCCD",
    "compute_collision_free_stepsize",
    "edge_edge_ccd",
    "edges",
    "has_intersections",
    "is_step_collision_free",
    "point_edge_ccd",
    "point_point_ccd",
    "point_triangle_ccd",
]


class BroadPhase:
    """Accepted where ipctk takes one, and ignored."""


class BruteForce(BroadPhase):
    """Accepted where ipctk takes a broad phase, and ignored."""


class HashGrid(BroadPhase):
    """Accepted where ipctk takes a broad phase, and ignored."""


class LBVH(BroadPhase):
    """Accepted where ipctk takes a broad phase, and ignored."""


class SpatialHash(BroadPhase):
    """Accepted where ipctk takes a broad phase, and ignored."""


class SweepAndPrune(BroadPhase):
    """Accepted where ipctk takes a broad phase, and ignored."""


class NarrowPhaseCCD:
    """Single pairs, and how far a step may go towards a contact.

    Attributes
    ----------
    conservative_rescaling : float
        The part of the distance at the start that a step may use up, in (0, 1].
    """

    conservative_rescaling: float

    @property
    def kept_fraction(self) -> float:
        """The part of its distance that every pair keeps during a step."""
        return 1 - self.conservative_rescaling

    def point_triangle_ccd(
        self,
        p_t0: npt.ArrayLike,
        t0_t0: npt.ArrayLike,
        t1_t0: npt.ArrayLike,
        t2_t0: npt.ArrayLike,
        p_t1: npt.ArrayLike,
        t0_t1: npt.ArrayLike,
        t1_t1: npt.ArrayLike,
        t2_t1: npt.ArrayLike,
        min_distance: float = 0.0,
        tmax: float = 1.0,
    ) -> tuple[bool, float]:
        """Tell whether a point meets a triangle until tmax, and before which time it does not."""
        return point_triangle_ccd(p_t0, t0_t0, t1_t0, t2_t0, p_t1, t0_t1, t1_t1, t2_t1, min_distance, tmax)

    def edge_edge_ccd(
        self,
        ea0_t0: npt.ArrayLike,
        ea1_t0: npt.ArrayLike,
        eb0_t0: npt.ArrayLike,
        eb1_t0: npt.ArrayLike,
        ea0_t1: npt.ArrayLike,
        ea1_t1: npt.ArrayLike,
        eb0_t1: npt.ArrayLike,
        eb1_t1: npt.ArrayLike,
        min_distance: float = 0.0,
        tmax: float = 1.0,
    ) -> tuple[bool, float]:
        """Tell whether two edges meet until tmax, and before which time they do not."""
        return edge_edge_ccd(ea0_t0, ea1_t0, eb0_t0, eb1_t0, ea0_t1, ea1_t1, eb0_t1, eb1_t1, min_distance, tmax)

    def point_edge_ccd(
        self,
        p_t0: npt.ArrayLike,
        e0_t0: npt.ArrayLike,
        e1_t0: npt.ArrayLike,
        p_t1: npt.ArrayLike,
        e0_t1: npt.ArrayLike,
        e1_t1: npt.ArrayLike,
        min_distance: float = 0.0,
        tmax: float = 1.0,
    ) -> tuple[bool, float]:
        """Tell whether a point meets an edge until tmax, and before which time it does not."""
        return point_edge_ccd(p_t0, e0_t0, e1_t0, p_t1, e0_t1, e1_t1, min_distance, tmax)

    def point_point_ccd(
        self,
        p0_t0: npt.ArrayLike,
        p1_t0: npt.ArrayLike,
        p0_t1: npt.ArrayLike,
        p1_t1: npt.ArrayLike,
        min_distance: float = 0.0,
        tmax: float = 1.0,
    ) -> tuple[bool, float]:
        """Tell whether two points meet until tmax, and before which time they do not."""
        return point_point_ccd(p0_t0, p1_t0, p0_t1, p1_t1, min_distance, tmax)


class TightInclusionCCD(NarrowPhaseCCD):
    """A step keeps 1e-4 of every distance, where ipctk keeps 1e-4 in the unit of the positions, or less.

    Tolerance and iterations have no meaning here.
    """

    def __init__(
        self, tolerance: float = 1e-6, max_iterations: int = 10_000_000, conservative_rescaling: float = 0.8
    ) -> None:
        self.conservative_rescaling = conservative_rescaling

    @property
    def kept_fraction(self) -> float:
        """The part of its distance that every pair keeps during a step."""
        return min(1e-4, super().kept_fraction)


class AdditiveCCD(NarrowPhaseCCD):
    """A step keeps a tenth of every distance unless told otherwise, as in ipctk; iterations have no meaning here."""

    def __init__(self, max_iterations: int = 10_000_000, conservative_rescaling: float = 0.9) -> None:
        self.conservative_rescaling = conservative_rescaling


class CollisionMesh:
    """Topology, and which vertices may collide.

    Parameters
    ----------
    rest_positions : array_like, shape (n, 3)
        Only their number counts here.
    edges : array_like of int, shape (e, 2), optional
        Those of the faces and loose ones.
    faces : array_like of int, shape (f, 3), optional
        Triangles.
    """

    def __init__(
        self,
        rest_positions: npt.ArrayLike,
        edges: npt.ArrayLike | None = None,
        faces: npt.ArrayLike | None = None,
    ) -> None:
        self.rest_positions: Doubles = rows(rest_positions, "rest_positions", InvalidMesh)
        self.edges: Indices = indices(edges, 2, "edges", InvalidMesh)
        self.faces: Indices = indices(faces, 3, "faces", InvalidMesh)
        self._mesh = Mesh(self.faces, len(self.rest_positions), self.edges)
        self._can_collide: Callable[[int, int], bool] | None = None
        self._detector: Detector | None = None

    @property
    def can_collide(self) -> Callable[[int, int], bool] | None:
        """Asked of pairs of vertices; features may collide if any two of their vertices may. Slow, as in ipctk."""
        return self._can_collide

    @can_collide.setter
    def can_collide(self, function: Callable[[int, int], bool] | None) -> None:
        self._can_collide = function
        self._detector = None

    @property
    def num_vertices(self) -> int:
        """Number of vertices."""
        return len(self.rest_positions)

    @property
    def num_edges(self) -> int:
        """Number of edges as given."""
        return len(self.edges)

    @property
    def num_faces(self) -> int:
        """Number of triangles."""
        return len(self.faces)

    @property
    def detector(self) -> Detector:
        """What answers for this mesh; kept from step to step."""
        if self._detector is None:
            between = None if self._can_collide is None else _between(self._can_collide)
            self._detector = Detector(self._mesh, filter=between)
        return self._detector


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


def edges(faces: npt.ArrayLike) -> Indices:
    """Return the edges of triangles, each once, shape (e, 2)."""
    return Mesh(faces).edges


def has_intersections(mesh: CollisionMesh, vertices: npt.ArrayLike, broad_phase: BroadPhase | None = None) -> bool:
    """Tell whether any edge passes through a triangle or touches it: exactly."""
    return mesh.detector.has_intersection(vertices)


def is_step_collision_free(
    mesh: CollisionMesh,
    vertices_t0: npt.ArrayLike,
    vertices_t1: npt.ArrayLike,
    min_distance: float = 0.0,
    broad_phase: BroadPhase | None = None,
    narrow_phase_ccd: NarrowPhaseCCD | None = None,
) -> bool:
    """Tell whether the whole step is free of contacts: exactly; ipctk may say no of a step that comes near one."""
    return mesh.detector.is_free(vertices_t0, vertices_t1, min_separation=min_distance)


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
    return mesh.detector.keep_distance(vertices_t0, vertices_t1, kept, min_separation=min_distance).lower


def point_triangle_ccd(
    p_t0: npt.ArrayLike,
    t0_t0: npt.ArrayLike,
    t1_t0: npt.ArrayLike,
    t2_t0: npt.ArrayLike,
    p_t1: npt.ArrayLike,
    t0_t1: npt.ArrayLike,
    t1_t1: npt.ArrayLike,
    t2_t1: npt.ArrayLike,
    min_distance: float = 0.0,
    tmax: float = 1.0,
) -> tuple[bool, float]:
    """Tell whether a point meets a triangle until tmax, and before which time it does not."""
    start, end = _points(p_t0, t0_t0, t1_t0, t2_t0), _points(p_t1, t0_t1, t1_t1, t2_t1)
    return _until(tmax, _vertex_face(start, end, min_separation=min_distance))


def edge_edge_ccd(
    ea0_t0: npt.ArrayLike,
    ea1_t0: npt.ArrayLike,
    eb0_t0: npt.ArrayLike,
    eb1_t0: npt.ArrayLike,
    ea0_t1: npt.ArrayLike,
    ea1_t1: npt.ArrayLike,
    eb0_t1: npt.ArrayLike,
    eb1_t1: npt.ArrayLike,
    min_distance: float = 0.0,
    tmax: float = 1.0,
) -> tuple[bool, float]:
    """Tell whether two edges meet until tmax, and before which time they do not."""
    start, end = _points(ea0_t0, ea1_t0, eb0_t0, eb1_t0), _points(ea0_t1, ea1_t1, eb0_t1, eb1_t1)
    return _until(tmax, _edge_edge(start, end, min_separation=min_distance))


def point_edge_ccd(
    p_t0: npt.ArrayLike,
    e0_t0: npt.ArrayLike,
    e1_t0: npt.ArrayLike,
    p_t1: npt.ArrayLike,
    e0_t1: npt.ArrayLike,
    e1_t1: npt.ArrayLike,
    min_distance: float = 0.0,
    tmax: float = 1.0,
) -> tuple[bool, float]:
    """Tell whether a point meets an edge until tmax, and before which time it does not."""
    start, end = _points(p_t0, e0_t0, e1_t0), _points(p_t1, e0_t1, e1_t1)
    return _until(tmax, _vertex_edge(start, end, min_separation=min_distance))


def point_point_ccd(
    p0_t0: npt.ArrayLike,
    p1_t0: npt.ArrayLike,
    p0_t1: npt.ArrayLike,
    p1_t1: npt.ArrayLike,
    min_distance: float = 0.0,
    tmax: float = 1.0,
) -> tuple[bool, float]:
    """Tell whether two points meet until tmax, and before which time they do not."""
    start, end = _points(p0_t0, p1_t0), _points(p0_t1, p1_t1)
    return _until(tmax, _vertex_vertex(start, end, min_separation=min_distance))


def _points(*points: npt.ArrayLike) -> Doubles:
    return np.stack([np.asarray(point, dtype=np.float64).ravel() for point in points])


def _until(tmax: float, found: Pairs) -> tuple[bool, float]:
    """What ipctk returns: does it touch until tmax, and when; infinity if not."""
    when = float(found.toi_lower[0])
    touches = bool(found.touches[0]) and when <= tmax
    return touches, when if touches else float("inf")


def _between(can_collide: Callable[[int, int], bool]) -> Callable[[int, tuple[int, int, int, int]], bool]:
    """Make a filter of features from one of vertices."""

    def accepts(kind: int, v: tuple[int, int, int, int]) -> bool:
        used = [i for i in v if i >= 0]
        cut = 2 if kind == 1 else 1  # an edge has two vertices, and else the first is a vertex by itself
        return any(can_collide(a, b) for a in used[:cut] for b in used[cut:])

    return accepts
