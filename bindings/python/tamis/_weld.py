"""`weld`: joins vertices that lie at one place."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import numbers, point_frames, shape_text
from tamis._checks import number_from_zero
from tamis._errors import InvalidMesh
from tamis._mesh import Mesh, known_mesh


def weld(mesh: Mesh, positions: npt.ArrayLike, distance: float = 0.0) -> Mesh:
    """Join vertices that lie at one place in every frame, as copies for normals and textures do.

    Vertices keep their numbers, so all positions serve the new mesh, too. Those joined to an earlier one belong to
    nothing any more.

    Parameters
    ----------
    mesh : Mesh
        The mesh whose features name the vertices.
    positions : array_like, shape (n, 3) or (f, n, 3)
        Positions of one frame or of several: vertices that part in one of them are not joined.
    distance : float
        Finite and >= 0: vertices within this distance of the first of them are joined. 0: exactly at one place.

    Returns
    -------
    Mesh
        With as many vertices, faces, edges and points, which name the first vertex of each place.

    Raises
    ------
    InvalidMesh
        No frame, a vertex in use that is not finite, positions without a row for each vertex, or of another type.
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
    array = numbers(positions, "positions", InvalidMesh)
    frames = point_frames(array[np.newaxis] if array.ndim == 2 else array, "positions", InvalidMesh)
    if not len(frames) or frames.shape[1] != count:
        raise InvalidMesh(
            f"positions has the shape {shape_text(array)}, the mesh {count} vertices: give one frame or more, with a "
            "row for each vertex"
        )
    if not np.isfinite(frames[:, mesh.points]).all():
        raise InvalidMesh("positions has a number that is not finite at a vertex of the mesh: give finite positions")
    first = _core.weld(list(frames), number_from_zero(distance, "distance"))
    return Mesh(first[mesh.faces], count, first[mesh.loose_edges], first[mesh.loose_points])
