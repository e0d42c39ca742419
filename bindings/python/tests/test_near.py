"""Meshes in one pose: near pairs and intersections."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

import tamis
import tamis.compat.ipctk as ipctk


def test_near_pairs_of_the_example(falling: tamis.Scene) -> None:
    near = tamis.Detector(falling.mesh).pairs_within(falling.start, 1.0)
    first = near.distance.argmin()
    assert near.vertices[first].tolist() == [3, 0, 1, 2] and near.distance[first] == 1
    assert near.kind[first] == tamis.PairKind.VERTEX_FACE and (near.weights[first] != 0).all()
    assert near.u[first] == pytest.approx(0.25) and near.direction[first].tolist() == [0, 0, 1]
    assert near.distance.max() <= 1
    assert repr(near) == f"NearPairs({len(near)} pairs, nearest 1)"
    assert len(tamis.Detector(falling.mesh).pairs_within(falling.start, 0.5)) == 0


def test_near_pairs_are_all_and_no_others() -> None:
    """Against brute force over sampled points: no pair with points nearer than the distance may be missing."""
    scene = tamis.scene("soup", 30, seed=4)
    near = tamis.Detector(scene.mesh).pairs_within(scene.start, 0.2)
    found = {tuple(v) for v, kind in zip(near.vertices.tolist(), near.kind) if kind == tamis.PairKind.VERTEX_FACE}
    weights = np.array([(1 - (i + j) / 8, i / 8, j / 8) for i in range(9) for j in range(9 - i)])
    for point in scene.mesh.points:
        for face in scene.mesh.faces:
            if point in face:
                continue
            gap = np.linalg.norm(weights @ scene.start[face] - scene.start[point], axis=1).min()
            if gap <= 0.2:
                assert (int(point), *face.tolist()) in found
    assert len(found) > 10


def test_intersections(falling: tamis.Scene) -> None:
    detector = tamis.Detector(falling.mesh)
    assert not detector.has_intersection(falling.start) and len(detector.intersections(falling.start)) == 0
    found = detector.intersections(falling.end)
    assert detector.has_intersection(falling.end) and len(found) > 0
    assert (3 in found.edge) and (found.face == [0, 1, 2]).all(axis=1).any()
    for s, edge, face, u, v in zip(found.s_lower, found.edge, found.face, found.u, found.v):
        a, b, c = falling.end[face]
        on_edge = falling.end[edge[0]] + s * (falling.end[edge[1]] - falling.end[edge[0]])
        assert np.allclose(on_edge, (1 - u - v) * a + u * b + v * c, atol=1e-9)
    assert (found.s_lower <= found.s_upper).all()
    mesh = ipctk.CollisionMesh(falling.start, None, falling.mesh.faces)
    assert ipctk.has_intersections(mesh, falling.end) and not ipctk.has_intersections(mesh, falling.start)


def test_thickness_comes_on_top(falling: tamis.Scene) -> None:
    thick = tamis.Detector(falling.mesh, groups=falling.groups, radii=[0.25, 0.25])
    assert (
        len(thick.pairs_within(falling.start, 0.5))
        == len(tamis.Detector(falling.mesh).pairs_within(falling.start, 1.0))
        > 0
    )


def test_pickled_and_bad_input(falling: tamis.Scene) -> None:
    detector = tamis.Detector(falling.mesh)
    near = detector.pairs_within(falling.start, 1.0)
    assert pickle.loads(pickle.dumps(near)) == near
    for bad in (-1.0, float("nan"), float("inf")):
        with pytest.raises(tamis.InvalidOptions):
            detector.pairs_within(falling.start, bad)
    for ask in (lambda p: detector.pairs_within(p, 1.0), detector.intersections, detector.has_intersection):
        with pytest.raises(tamis.InvalidStep):
            ask(falling.start[:5])
        with pytest.raises(tamis.InvalidStep):
            ask(np.zeros((6, 3), object))
