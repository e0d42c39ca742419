"""The mesh as ipctk has it."""

from __future__ import annotations

from collections.abc import Callable

import numpy.typing as npt

from tamis._arrays import Doubles, Indices, indices, rows
from tamis._contacts import PairKind
from tamis._detector import Detector
from tamis._errors import InvalidMesh
from tamis._mesh import Mesh
from tamis._options import Filter


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


def detector_of(mesh: CollisionMesh) -> Detector:
    """Return what answers for a mesh; one of another library is refused."""
    if not isinstance(mesh, CollisionMesh):
        given = type(mesh)
        raise InvalidMesh(
            f"the mesh is of the type {given.__module__}.{given.__qualname__}: give a "
            "tamis.compat.ipctk.CollisionMesh, made from the same positions, edges and faces"
        )
    return mesh.detector


def edges(faces: npt.ArrayLike) -> Indices:
    """Return the edges of triangles, each once, shape (e, 2)."""
    return Mesh(faces).edges


def _between(can_collide: Callable[[int, int], bool]) -> Filter:
    """Make a filter of features from one of vertices."""

    def accepts(kind: PairKind, v: tuple[int, int, int, int]) -> bool:
        used = [i for i in v if i >= 0]
        cut = (
            2 if kind == PairKind.EDGE_EDGE else 1
        )  # an edge has two vertices, and else the first is a vertex by itself
        return any(can_collide(a, b) for a in used[:cut] for b in used[cut:])

    return accepts
