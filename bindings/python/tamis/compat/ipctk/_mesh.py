"""The mesh of ipctk's interface."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles, Indices, finite, indices_or_none, rows
from tamis._checks import function
from tamis._detector._detector import Detector
from tamis._errors import InvalidMesh
from tamis._kinds import FIRST_COUNTS, PairKind
from tamis._mesh import Mesh
from tamis._options import Filter
from tamis.compat.ipctk._threads import get_num_threads


class CollisionMesh:
    """The topology, and which vertices may collide. A vertex of no face and no edge is a loose point and may collide.

    Parameters
    ----------
    rest_positions : array_like, shape (n, 3)
        Only the number of rows matters here.
    edges : array_like of int, shape (e, 2), optional
        Edges of faces, and loose edges. They keep their order, which differs from the order of `tamis.Mesh.edges`.
    faces : array_like of int, shape (f, 3), optional
        Vertex indices of each triangle.

    Raises
    ------
    InvalidMesh
        Arrays of another shape or type, numbers that are not finite, or an index that is not a vertex.
    """

    def __init__(
        self,
        rest_positions: npt.ArrayLike,
        edges: npt.ArrayLike | None = None,
        faces: npt.ArrayLike | None = None,
    ) -> None:
        positions = rows(rest_positions, "rest_positions", InvalidMesh)
        self.rest_positions: Doubles = finite(positions, "rest_positions", InvalidMesh)
        self.edges: Indices = indices_or_none(edges, 2, "edges", InvalidMesh)
        self.faces: Indices = indices_or_none(faces, 3, "faces", InvalidMesh)
        self._mesh = Mesh(self.faces, self.num_vertices, self.edges, self.codim_vertices)
        self._can_collide: Callable[[int, int], bool] | None = None
        self._detector: Detector | None = None
        self._threads = 0  # that the detector was made with

    @property
    def can_collide(self) -> Callable[[int, int], bool] | None:
        """``can_collide(a, b)`` of two vertices: features may collide if any two of their vertices may. Slow."""
        return self._can_collide

    @can_collide.setter
    def can_collide(self, can_collide: Callable[[int, int], bool] | None) -> None:
        if can_collide is not None:
            function(can_collide, "can_collide", "can_collide(a, b)")
        self._can_collide = can_collide
        self._detector = None

    @property
    def num_vertices(self) -> int:
        """The number of vertices."""
        return len(self.rest_positions)

    @property
    def num_edges(self) -> int:
        """The number of edges as given."""
        return len(self.edges)

    @property
    def num_faces(self) -> int:
        """The number of triangles."""
        return len(self.faces)

    @property
    def codim_vertices(self) -> Indices:
        """The vertices of no face and no edge, ascending."""
        used = np.concatenate([self.edges.ravel(), self.faces.ravel()])
        return np.setdiff1d(np.arange(self.num_vertices, dtype=np.int32), used)

    @property
    def num_codim_vertices(self) -> int:
        """The number of vertices of no face and no edge."""
        return len(self.codim_vertices)

    @property
    def detector(self) -> Detector:
        """The detector of this mesh, kept until `can_collide` or the number of threads changes."""
        threads = get_num_threads()
        if self._detector is None or self._threads != threads:
            between = None if self._can_collide is None else _between(self._can_collide)
            self._detector, self._threads = Detector(self._mesh, filter=between, threads=threads), threads
        return self._detector


def detector_of(mesh: CollisionMesh) -> Detector:
    """Return the detector of a mesh; raise for a mesh of another library."""
    if not isinstance(mesh, CollisionMesh):
        given = type(mesh)
        raise InvalidMesh(
            f"the mesh is of the type {given.__module__}.{given.__qualname__}: give a "
            "tamis.compat.ipctk.CollisionMesh, made from the same positions, edges and faces"
        )
    return mesh.detector


def edges(faces: npt.ArrayLike) -> Indices:
    """Return the edges of triangles, each once, shape (e, 2), in ipctk's order: by larger vertex, then smaller vertex.

    `tamis.Mesh.edges` has another order; `tamis.Mesh.find_edges` finds the rows of these edges there.
    """
    found = Mesh(faces).edges
    return found[np.lexsort(found.T)]


def _between(can_collide: Callable[[int, int], bool]) -> Filter:
    """Return a filter of pairs of features, made from one of pairs of vertices."""

    def accepts(kind: PairKind, v: tuple[int, int, int, int]) -> bool:
        used = [i for i in v if i >= 0]
        cut = FIRST_COUNTS[kind]
        return any(can_collide(a, b) for a in used[:cut] for b in used[cut:])

    return accepts
