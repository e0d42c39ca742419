"""`weld`: joins vertices that lie at one place."""

from __future__ import annotations

import numpy.typing as npt

from tamis import _core
from tamis._arrays import rows
from tamis._checks import number_from_zero
from tamis._errors import InvalidMesh
from tamis._mesh import Mesh, known_mesh


def weld(mesh: Mesh, *frames: npt.ArrayLike, distance: float = 0.0) -> Mesh:
    """Join vertices that lie at one place in every frame, as copies for normals and textures do.

    Vertices keep their numbers, so all positions serve the new mesh, too. Those joined to an earlier one belong to
    nothing any more.

    Parameters
    ----------
    mesh : Mesh
        The mesh whose features name the vertices.
    *frames : array_like, shape (n, 3)
        Positions of one frame or more: vertices that part in one of them are not joined.
    distance : float
        Finite and >= 0: vertices within this distance of the first of them are joined. 0: exactly at one place.

    Returns
    -------
    Mesh
        With as many vertices, faces, edges and points, which name the first vertex of each place.

    Raises
    ------
    InvalidMesh
        No frame, one that has not a row for each vertex, or an array of another type.
    InvalidOptions
        `distance` is out of its range.

    Examples
    --------
    >>> split = Mesh([[0, 1, 2], [3, 4, 5]])
    >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    >>> weld(split, corners).faces.tolist()
    [[0, 1, 2], [1, 4, 2]]
    """
    count = known_mesh(mesh).vertex_count
    given = [rows(frame, f"frames[{i}]", InvalidMesh) for i, frame in enumerate(frames)]
    if not given:
        raise InvalidMesh("no frame is given: give the positions of one frame or more")
    for i, frame in enumerate(given):
        if len(frame) != count:
            raise InvalidMesh(f"frames[{i}] has {len(frame)} rows, the mesh {count} vertices: give a row for each")
    first = _core.weld(given, number_from_zero(distance, "distance"))
    return Mesh(first[mesh.faces], count, first[mesh.loose_edges], first[mesh.loose_points])
