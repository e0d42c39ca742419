"""The surfaces of a model as one mesh: its flexes, and triangles for each geom that can touch anything."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles, Indices
from tamis._errors import InvalidMesh
from tamis._mesh import Mesh
from tamis._primitives import Shape, around_square, box, capsule, cylinder, ellipsoid

_NO_EDGES = np.empty((0, 2), np.int32)
_NO_FACES = np.empty((0, 3), np.int32)


@dataclass(frozen=True)
class Surface:
    """One flex, or one geom. Vertex i is at `points[i]` in the frame of the body `bodies[i]`.

    The vertices of some flexes are moved by nodes (`is_by_nodes`); MuJoCo computes their positions.
    """

    name: str
    points: Doubles
    bodies: Indices
    faces: Indices
    edges: Indices
    flex: int = -1
    geom: int = -1
    is_plane: bool = False
    is_by_nodes: bool = False


@dataclass(frozen=True)
class Surfaces:
    """All surfaces as one mesh, their vertices in the order of `parts`; each surface is a group."""

    parts: list[Surface]
    mesh: Mesh
    groups: Indices


def surfaces_of(model: Any, tolerance: float, plane_reach: float) -> Surfaces:
    """Triangulate all surfaces that can collide; `tolerance`: how far triangles may be outside a curved surface."""
    parts = [_flex(model, i) for i in range(model.nflex)]
    for geom in _geoms_that_touch(model):
        shape = _shape(model, geom, tolerance, plane_reach)
        parts.append(
            Surface(
                name=name_of(model, mujoco.mjtObj.mjOBJ_GEOM, geom),
                points=_in_body(model, geom, shape.points),
                bodies=np.full(len(shape.points), model.geom_bodyid[geom], np.int32),
                faces=shape.faces,
                edges=_NO_EDGES,
                geom=geom,
                is_plane=model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_PLANE,
            )
        )
    if not parts:
        raise InvalidMesh("the model has no flex, and no geom that collides: there is nothing to watch")
    counts = [len(part.points) for part in parts]
    first = np.concatenate([[0], np.cumsum(counts)])
    faces = np.vstack([part.faces + n for part, n in zip(parts, first)])
    edges = np.vstack([part.edges + n for part, n in zip(parts, first)])
    mesh = Mesh(faces, vertex_count=int(first[-1]), edges=edges)
    return Surfaces(parts, mesh, np.repeat(np.arange(len(parts), dtype=np.int32), counts))


def _geoms_that_touch(model: Any) -> list[int]:
    """Return the geoms that can collide: with a bit in contype or conaffinity, or in the model's list of pairs."""
    touches = (model.geom_contype | model.geom_conaffinity) != 0
    touches[model.pair_geom1] = touches[model.pair_geom2] = True
    return [int(geom) for geom in np.flatnonzero(touches)]


def name_of(model: Any, kind: Any, number: int) -> str:
    """Return the model's name of an object, or its kind and number if it has no name."""
    given = mujoco.mj_id2name(model, kind, number)
    return given or f"{kind.name.removeprefix('mjOBJ_').lower()} {number}"


def _flex(model: Any, flex: int) -> Surface:
    dim, first, count = (int(a[flex]) for a in (model.flex_dim, model.flex_vertadr, model.flex_vertnum))
    element, elements = int(model.flex_elemdataadr[flex]), int(model.flex_elemnum[flex])
    faces, edges = _NO_FACES, _NO_EDGES
    if dim == 3:
        shell, pieces = int(model.flex_shelldataadr[flex]), int(model.flex_shellnum[flex])
        faces = model.flex_shell[shell : shell + 3 * pieces].reshape(-1, 3)
    else:
        corners = model.flex_elem[element : element + (dim + 1) * elements].reshape(-1, dim + 1)
        faces, edges = (corners, edges) if dim == 2 else (faces, corners)
    return Surface(
        name=name_of(model, mujoco.mjtObj.mjOBJ_FLEX, flex),
        points=np.zeros((count, 3)) if model.flex_centered[flex] else model.flex_vert[first : first + count],
        bodies=_bodies_of_flex(model, flex, first, count),
        faces=faces.astype(np.int32),
        edges=edges.astype(np.int32),
        flex=flex,
        is_by_nodes=bool(model.flex_interp[flex]),
    )


def _bodies_of_flex(model: Any, flex: int, first: int, count: int) -> Indices:
    """Return the body that carries each vertex; for a flex that nodes move, the body of its first node for all."""
    if not model.flex_interp[flex]:
        return np.array(model.flex_vertbodyid[first : first + count], np.int32)
    node = int(model.flex_nodeadr[flex])
    return np.full(count, model.flex_nodebodyid[node], np.int32)


def _shape(model: Any, geom: int, tolerance: float, plane_reach: float) -> Shape:
    kind, size = int(model.geom_type[geom]), model.geom_size[geom]
    types = mujoco.mjtGeom
    if kind == types.mjGEOM_MESH:
        return _mesh(model, int(model.geom_dataid[geom]))
    if kind == types.mjGEOM_BOX:
        return box(size)
    if kind == types.mjGEOM_PLANE:
        return around_square(plane_reach)
    if kind == types.mjGEOM_SPHERE:
        return capsule(size[0], 0.0, tolerance)
    if kind == types.mjGEOM_CAPSULE:
        return capsule(size[0], size[1], tolerance)
    if kind == types.mjGEOM_ELLIPSOID:
        return ellipsoid(size, tolerance)
    if kind == types.mjGEOM_CYLINDER:
        return cylinder(size[0], size[1], tolerance)
    name = name_of(model, mujoco.mjtObj.mjOBJ_GEOM, geom)
    word = types(kind).name.removeprefix("mjGEOM_").lower()
    raise InvalidMesh(
        f"{name} is a geom of the type {word}, which has no triangles here: replace it by a mesh, or remove it "
        "from all contacts (contype and conaffinity 0)"
    )


def _mesh(model: Any, number: int) -> Shape:
    face, vertex = int(model.mesh_faceadr[number]), int(model.mesh_vertadr[number])
    faces = model.mesh_face[face : face + int(model.mesh_facenum[number])]
    points = model.mesh_vert[vertex : vertex + int(model.mesh_vertnum[number])]
    return Shape(points.astype(float), faces.astype(np.int32))


def _in_body(model: Any, geom: int, points: Doubles) -> Doubles:
    turn = np.empty(9)
    mujoco.mju_quat2Mat(turn, model.geom_quat[geom])
    placed: Doubles = points @ turn.reshape(3, 3).T + model.geom_pos[geom]
    return placed


def may_touch(model: Any, parts: list[Surface]) -> npt.NDArray[np.bool_]:
    """Return which surfaces MuJoCo would collide, shape (parts, parts): by bits, bodies, and the model's lists."""
    allowed = np.zeros((len(parts), len(parts)), bool)
    excluded = {int(signature) for signature in model.exclude_signature}
    listed = {frozenset(pair) for pair in zip(model.pair_geom1.tolist(), model.pair_geom2.tolist())}
    for i, a in enumerate(parts):
        for j, b in enumerate(parts[: i + 1]):
            allowed[i, j] = allowed[j, i] = _may_touch(model, a, b, excluded, listed)
    return allowed


def _may_touch(model: Any, a: Surface, b: Surface, excluded: set[int], listed: set[frozenset[int]]) -> bool:
    if a is b:
        return a.flex >= 0 and bool(model.flex_selfcollide[a.flex]) and bool(_bits(model, a)[0] & _bits(model, a)[1])
    if a.geom >= 0 and b.geom >= 0:
        if frozenset((a.geom, b.geom)) in listed:
            return True
        if not _bodies_may_touch(model, int(a.bodies[0]), int(b.bodies[0]), excluded):
            return False
    (type_a, affinity_a), (type_b, affinity_b) = _bits(model, a), _bits(model, b)
    return bool((type_a & affinity_b) | (type_b & affinity_a))


def _bodies_may_touch(model: Any, a: int, b: int, excluded: set[int]) -> bool:
    """Whether geoms of two bodies may touch, as in MuJoCo.

    Joints must carry one of them. Bodies that are welded together may not touch, excluded pairs may not, and a body may
    not touch its parent unless that is the world (or the flag for that is off).
    """
    if not (_is_carried_by_joints(model, a) or _is_carried_by_joints(model, b)):
        return False
    weld_a, weld_b = int(model.body_weldid[a]), int(model.body_weldid[b])
    if weld_a == weld_b or (a << 16) + b in excluded or (b << 16) + a in excluded:
        return False
    if model.opt.disableflags & mujoco.mjtDisableBit.mjDSBL_FILTERPARENT:
        return True
    parent_a, parent_b = (int(model.body_weldid[model.body_parentid[weld]]) for weld in (weld_a, weld_b))
    return not ((weld_a == parent_b and weld_a != 0) or (weld_b == parent_a and weld_b != 0))


def _is_carried_by_joints(model: Any, body: int) -> bool:
    """Whether the body or one above it has a joint: false for static bodies and mocap bodies."""
    while body and not model.body_dofnum[body]:
        body = int(model.body_parentid[body])
    return body != 0


def _bits(model: Any, part: Surface) -> tuple[int, int]:
    if part.flex >= 0:
        return int(model.flex_contype[part.flex]), int(model.flex_conaffinity[part.flex])
    return int(model.geom_contype[part.geom]), int(model.geom_conaffinity[part.geom])


def vertices_by_nodes(model: Any, parts: list[Surface]) -> Iterator[tuple[slice, slice]]:
    """Yield, for each flex that nodes move, its vertices in the mesh and in MuJoCo's arrays of all flex vertices."""
    first = 0
    for part in parts:
        count = len(part.points)
        if part.is_by_nodes:
            start = int(model.flex_vertadr[part.flex])
            yield slice(first, first + count), slice(start, start + count)
        first += count
