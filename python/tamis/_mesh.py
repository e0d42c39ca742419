"""The topology of the moving objects."""

from __future__ import annotations

import numpy.typing as npt

from tamis import _core
from tamis._arrays import Indices, indices, indices_or_none, pair_list
from tamis._checks import LARGEST_INDEX, whole
from tamis._errors import InvalidMesh


class Mesh:
    """Triangles, plus optional loose edges (rods) and loose points: made once, shared by every step.

    Any winding, open, non-manifold, duplicate and degenerate triangles are legal; so are vertices that nothing uses,
    which take no part in contacts.

    Parameters
    ----------
    faces : array_like of int, shape (f, 3)
        Vertex indices of each triangle; may be empty.
    vertex_count : int, optional
        Rows of the positions of every step. By default as many as the largest index needs.
    edges : array_like of int, shape (e, 2), optional
        Loose edges: rods.
    points : array_like of int, shape (p,), optional
        Loose points: vertices of no face and no edge that still take part in contacts.

    Raises
    ------
    InvalidMesh
        An index outside [0, vertex_count), no feature at all, or an array of another shape or type.
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
        """Rows of the positions of every step."""
        return self._mesh.vertex_count

    @property
    def faces(self) -> Indices:
        """The triangles as given, shape (f, 3); read-only."""
        return self._faces

    @property
    def edges(self) -> Indices:
        """Every edge of a triangle and every loose one, once, shape (e, 2): vertices ascending, sorted.

        Another library lists the same edges in another order, so that its rows are not these: `find_edges`.
        """
        return self._mesh.edges()

    @property
    def points(self) -> Indices:
        """The vertices that take part in contacts, shape (p,), ascending."""
        return self._mesh.points()

    @property
    def loose_edges(self) -> Indices:
        """The loose edges as given, shape (e, 2), which are no rows of `edges`; read-only."""
        return self._edges

    @property
    def loose_points(self) -> Indices:
        """The loose points as given, shape (p,); read-only."""
        return self._points

    def features_of(self, kind: npt.ArrayLike, vertices: npt.ArrayLike) -> Indices:
        """Find the features of pairs among those of this mesh, for data that is kept by feature.

        Parameters
        ----------
        kind : array_like of PairKind, shape (n,)
            As in `Contacts` or `NearPairs`; one may serve for all.
        vertices : array_like of int, shape (n, 4)
            As in `Contacts` or `NearPairs`; one pair may come as (4,).

        Returns
        -------
        array of int, shape (n, 2)
            The two features of each pair: the row of `faces` or of `edges`, or the index of a vertex. Another library's
            list of edges has other rows: `find_edges` leads from one to the other.

        Raises
        ------
        InvalidMesh
            The mesh has no such vertex, no such edge, or no such face in this order of its vertices; a kind that is
            none, or an array of another shape or type. The message names the pair.
        """
        return _core.features_of(self._mesh, *pair_list(kind, vertices, InvalidMesh))

    def find_edges(self, edges: npt.ArrayLike) -> Indices:
        """Find edges by their vertices: what leads from another library's list of edges to the rows of `edges`.

        Parameters
        ----------
        edges : array_like of int, shape (n, 2)
            In any order, each in either direction.

        Returns
        -------
        array of int, shape (n,)
            The row of `edges` that each is; -1 where the mesh has none. Data that has a row for each of `edges` goes
            to another list's order as ``data[mesh.find_edges(theirs)]``, and comes from it as
            ``data[mesh.find_edges(theirs)] = their_data``.

        Raises
        ------
        InvalidMesh
            An array of another shape or type.
        """
        return _core.find_edges(self._mesh, indices(edges, 2, "edges", InvalidMesh))

    def find_faces(self, faces: npt.ArrayLike) -> Indices:
        """Find faces by their vertices.

        Parameters
        ----------
        faces : array_like of int, shape (n, 3)
            Each in the mesh's order of its vertices.

        Returns
        -------
        array of int, shape (n,)
            The row of `faces` that each is, the first of several; -1 where the mesh has none.

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
