"""The topology of the moving objects."""

from __future__ import annotations

import numpy.typing as npt

from tamis import _core
from tamis._arrays import Indices, indices, indices_or_none, pair_list
from tamis._checks import LARGEST_INDEX, instance, whole
from tamis._errors import InvalidMesh


class Mesh:
    """Triangles, plus optional loose edges (rods) and loose points: made once, shared by every step.

    Legal: any winding; open and non-manifold meshes; duplicate and degenerate triangles; vertices that nothing uses
    (they take no part in contacts).

    Parameters
    ----------
    faces : array_like of int, shape (f, 3)
        Vertex indices of each triangle; may be empty.
    vertex_count : int, optional
        The number of rows of the positions of every step, >= 0. By default the largest index + 1.
    edges : array_like of int, shape (e, 2), optional
        Loose edges: rods.
    points : array_like of int, shape (p,), optional
        Loose points: vertices of no face and no edge that still take part in contacts.

    Raises
    ------
    InvalidMesh
        An index outside [0, vertex_count), no feature at all, or an array of another shape or type.

    Examples
    --------
    >>> Mesh([[0, 1, 2], [2, 1, 3]])
    Mesh(4 vertices, 2 triangles, 5 edges)
    >>> rod_and_point = Mesh([], vertex_count=3, edges=[[0, 1]], points=[2])
    """

    __slots__ = ("_edges", "_faces", "_mesh", "_points")

    def __init__(
        self,
        faces: npt.ArrayLike,
        vertex_count: int | None = None,
        edges: npt.ArrayLike | None = None,
        points: npt.ArrayLike | None = None,
    ) -> None:
        given = (
            indices(faces, 3, "faces", InvalidMesh),
            indices_or_none(edges, 2, "edges", InvalidMesh),
            indices_or_none(points, 0, "points", InvalidMesh),
        )
        if vertex_count is None:
            most = max((int(array.max()) for array in given if array.size), default=-1)
            if most == LARGEST_INDEX:
                raise InvalidMesh(f"faces, edges or points name vertex {most}: give indices below {most}")
            vertex_count = 1 + most
        edges_by_name = "; loose edges go by their name, edges=..." if hasattr(vertex_count, "__len__") else ""
        self._mesh = _core.Mesh(whole(vertex_count, "vertex_count", 0, InvalidMesh, edges_by_name), *given)
        self._faces, self._edges, self._points = self._mesh.faces(), given[1].copy(), given[2].copy()
        for array in (self._faces, self._edges, self._points):
            array.flags.writeable = False

    @property
    def vertex_count(self) -> int:
        """The number of rows of the positions of every step."""
        return self._mesh.vertex_count

    @property
    def faces(self) -> Indices:
        """The triangles as given, shape (f, 3); read-only."""
        return self._faces

    @property
    def edges(self) -> Indices:
        """Every edge of a triangle and every loose edge, once, shape (e, 2): vertices ascending, rows sorted.

        An edge from a vertex to itself is skipped. Another library may list the same edges in another order:
        `find_edges` finds their rows here.
        """
        return self._mesh.edges()

    @property
    def points(self) -> Indices:
        """The vertices that take part in contacts, shape (p,), ascending."""
        return self._mesh.points()

    @property
    def loose_edges(self) -> Indices:
        """The loose edges as given, shape (e, 2); read-only. Their rows differ from the rows of `edges`."""
        return self._edges

    @property
    def loose_points(self) -> Indices:
        """The loose points as given, shape (p,); read-only."""
        return self._points

    def features_of(self, kind: npt.ArrayLike, vertices: npt.ArrayLike) -> Indices:
        """Find both features of each pair in this mesh, for callers who keep data by feature.

        Parameters
        ----------
        kind : array_like of PairKind, shape (n,)
            As in `Contacts` or `NearPairs`; one kind may serve for all pairs.
        vertices : array_like of int, shape (n, 4)
            As in `Contacts` or `NearPairs`; one pair may have the shape (4,).

        Returns
        -------
        array of int32, shape (n, 2)
            For each pair its first and its second feature: for a face its row in `faces`, for an edge its row in
            `edges`, for a vertex its index. Another library's list of edges has other rows (see `find_edges`).

        Raises
        ------
        InvalidMesh
            The mesh has no such vertex, no such edge, or no such face with its vertices in this order; no such kind;
            or an array of another shape or type. The message names the pair.
        """
        return _core.features_of(self._mesh, *pair_list(kind, vertices, InvalidMesh))

    def find_edges(self, edges: npt.ArrayLike) -> Indices:
        """Find the rows of edges in `edges`, for callers whose list of edges has another order.

        If the mesh has all edges of the list ``theirs``, then with ``rows = mesh.find_edges(theirs)`` the data of this
        mesh's edges in their order is ``data[rows]``, and ``data[rows] = their_data`` takes over theirs.

        Parameters
        ----------
        edges : array_like of int, shape (n, 2)
            Edges in any order, each with its vertices in either order.

        Returns
        -------
        array of int32, shape (n,)
            The row of each edge in `Mesh.edges`; -1 where the mesh has no such edge.

        Raises
        ------
        InvalidMesh
            An array of another shape or type.
        """
        return _core.find_edges(self._mesh, indices(edges, 2, "edges", InvalidMesh))

    def find_faces(self, faces: npt.ArrayLike) -> Indices:
        """Find the rows of faces in `faces`.

        Parameters
        ----------
        faces : array_like of int, shape (n, 3)
            Faces in any order, each with its vertices in the mesh's order.

        Returns
        -------
        array of int32, shape (n,)
            The row of each face in `Mesh.faces`, the first one of duplicates; -1 where the mesh has no such face.

        Raises
        ------
        InvalidMesh
            An array of another shape or type.
        """
        return _core.find_faces(self._mesh, indices(faces, 3, "faces", InvalidMesh))

    def __repr__(self) -> str:
        return f"Mesh({self.vertex_count} vertices, {len(self._faces)} triangles, {len(self.edges)} edges)"

    def __reduce__(self) -> tuple[type[Mesh], tuple[Indices, int, Indices, Indices]]:
        return Mesh, (self._faces, self.vertex_count, self._edges, self._points)


def known_mesh(given: Mesh) -> Mesh:
    """Return the argument if it is a `Mesh`, else raise `InvalidMesh`."""
    return instance(given, Mesh, "mesh", "a tamis.Mesh, such as tamis.Mesh(faces)", InvalidMesh)
