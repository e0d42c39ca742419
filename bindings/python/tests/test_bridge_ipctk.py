"""Pairs of Tamis, given to ipctk, make the same collisions as ipctk's own broad phase."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

import tamis

ipctk: Any = pytest.importorskip("ipctk", reason="ipctk has no wheel for this Python", exc_type=ImportError)
bridge = pytest.importorskip("tamis.bridge.ipctk")

Numbers = npt.NDArray[np.float64]
REACH = 0.03
SETS = ipctk.NormalCollisions.CollisionSetType


@pytest.fixture(scope="module")
def pose() -> tuple[Any, Numbers]:
    """Return triangles, rods and points close together; edges in random order, in either direction."""
    random = np.random.default_rng(8)
    faces = np.arange(90, dtype=np.int32).reshape(-1, 3)
    rods = np.arange(90, 130, dtype=np.int32).reshape(-1, 2)
    edges = random.permutation(np.concatenate([ipctk.edges(faces), rods]))
    edges[::3] = edges[::3, ::-1]
    centres = random.random((160, 3))
    positions = 0.4 * centres + np.concatenate([0.08 * random.standard_normal((130, 3)), np.zeros((30, 3))])
    positions[150:] = positions[130:140] + 0.01 * random.standard_normal((10, 3))
    return ipctk.CollisionMesh(positions, edges, faces), positions


def _candidates(candidates: Any) -> set[tuple[str, int, int]]:
    """Return the candidates as tuples of kind and both numbers."""
    return {
        *(("fv", c.face_id, c.vertex_id) for c in candidates.fv_candidates),
        *(("ee", *sorted((c.edge0_id, c.edge1_id))) for c in candidates.ee_candidates),
        *(("ev", c.edge_id, c.vertex_id) for c in candidates.ev_candidates),
        *(("vv", *sorted((c.vertex0_id, c.vertex1_id))) for c in candidates.vv_candidates),
    }


def _collisions(
    mesh: Any, positions: Numbers, built_from: tuple[Any, ...], kind: Any
) -> dict[Any, tuple[float, float]]:
    """Return distance and weight of each collision, by its vertices."""
    collisions = ipctk.NormalCollisions()
    collisions.collision_set_type = kind
    collisions.build(*built_from, mesh, positions, REACH)
    found: dict[Any, tuple[float, float]] = {}
    for i in range(len(collisions)):
        c = collisions[i]
        name = (type(c).__name__, *sorted(c.vertex_ids(mesh.edges, mesh.faces)))
        assert name not in found
        found[name] = c.compute_distance(c.dof(positions, mesh.edges, mesh.faces)), c.weight
    return found


def test_candidates_have_the_numbers_of_ipctk(pose: tuple[Any, Numbers]) -> None:
    """Would catch Tamis's number of an edge given to ipctk, where it is another edge."""
    mesh, positions = pose
    near = tamis.Detector(bridge.mesh(mesh)).pairs_within(positions, REACH)
    assert set(near.kind) == {0, 1, 2, 3}
    candidates = bridge.candidates(near, mesh)
    assert len(candidates) == len(near) == len(_candidates(candidates))
    theirs = ipctk.Candidates()
    theirs.build(mesh, positions, REACH / 2)
    assert _candidates(candidates) < _candidates(theirs)
    for c in candidates.ee_candidates + candidates.fv_candidates + candidates.ev_candidates + candidates.vv_candidates:
        assert c.compute_distance(c.dof(positions, mesh.edges, mesh.faces)) <= REACH**2 * (1 + 1e-12)


@pytest.mark.parametrize("kind", [SETS.IPC, SETS.IMPROVED_MAX_APPROX, SETS.OGC], ids=lambda kind: str(kind))
def test_the_same_collisions(pose: tuple[Any, Numbers], kind: Any) -> None:
    """The distances that ipctk measures agree to 1e-15: the order of edges differs."""
    mesh, positions = pose
    near = tamis.Detector(bridge.mesh(mesh)).pairs_within(positions, REACH)
    ours = _collisions(mesh, positions, (bridge.candidates(near, mesh),), kind)
    theirs = _collisions(mesh, positions, (), kind)
    assert len(theirs) > 50 and ours.keys() == theirs.keys()
    both = np.array([[*ours[name], *theirs[name]] for name in theirs])
    assert np.allclose(both[:, :2], both[:, 2:], rtol=0, atol=1e-15)


def test_one_list_for_a_whole_line_search(pose: tuple[Any, Numbers]) -> None:
    """Against brute force in many poses: no pair that comes within reach on the way may be missing."""
    mesh, start = pose
    end = start + 0.05 * np.random.default_rng(3).standard_normal(start.shape)
    detector = tamis.Detector(bridge.mesh(mesh))
    way = detector.contacts(start, end, min_separation=REACH)
    listed = _candidates(bridge.candidates(way, mesh))
    seen: set[tuple[str, int, int]] = set()
    for time in np.linspace(0, 1, 21):
        x = (1 - time) * start + time * end
        everything = ipctk.Candidates()
        everything.build(mesh, x, REACH, ipctk.BruteForce())
        for name in ("fv_candidates", "ee_candidates", "ev_candidates", "vv_candidates"):
            within = [
                c
                for c in getattr(everything, name)
                if c.compute_distance(c.dof(x, mesh.edges, mesh.faces)) <= REACH**2 * (1 - 1e-12)
            ]
            chosen = ipctk.Candidates()
            setattr(chosen, name, within)
            seen |= _candidates(chosen)
        pose_alone = _candidates(bridge.candidates(detector.pairs_within(x, REACH), mesh))
        assert pose_alone <= listed
    assert seen <= listed and len(seen) > len(pose_alone) > 20
    assert len(listed) < 1.2 * len(seen)


def test_mixed_with_a_potential(pose: tuple[Any, Numbers]) -> None:
    """Barrier, gradient and friction of ipctk are the same on collisions from Tamis's pairs."""
    mesh, positions = pose
    ours, theirs = ipctk.NormalCollisions(), ipctk.NormalCollisions()
    near = tamis.Detector(bridge.mesh(mesh)).pairs_within(positions, REACH)
    ours.build(bridge.candidates(near, mesh), mesh, positions, REACH)
    theirs.build(mesh, positions, REACH)
    barrier = ipctk.BarrierPotential(REACH, 1e3)
    assert barrier(ours, mesh, positions) == pytest.approx(barrier(theirs, mesh, positions), rel=1e-12)
    pushed, expected = (barrier.gradient(collisions, mesh, positions) for collisions in (ours, theirs))
    assert np.allclose(pushed, expected, rtol=0, atol=1e-12 * np.abs(expected).max())
    friction = ipctk.FrictionPotential(1e-3)
    velocity = np.random.default_rng(1).standard_normal(positions.shape)
    dissipated = []
    for collisions in (ours, theirs):
        tangential = ipctk.TangentialCollisions()
        tangential.build(mesh, positions, collisions, barrier, 0.3)
        assert len(tangential) == len(collisions)
        dissipated.append(friction(tangential, mesh, velocity))
    assert dissipated[0] == pytest.approx(dissipated[1], rel=1e-12) and dissipated[0] > 0


def test_asked_again(pose: tuple[Any, Numbers]) -> None:
    """Would catch cached candidates of another call, or of another mesh."""
    mesh, positions = pose
    assert bridge.mesh(mesh) is bridge.mesh(mesh)
    near = tamis.Detector(bridge.mesh(mesh)).pairs_within(positions, REACH)
    first = _candidates(bridge.candidates(near, mesh))
    half = bridge.candidates(near[::2], mesh)
    half.ee_candidates = []
    assert len(half) < len(near[::2])
    assert _candidates(bridge.candidates(near, mesh)) == first
    other = ipctk.CollisionMesh(positions, mesh.edges[::-1].copy(), mesh.faces)
    assert _candidates(bridge.candidates(near, other)) != first
    assert len(bridge.candidates(near[:0], mesh)) == 0


def test_an_edge_from_a_vertex_to_itself() -> None:
    """Would catch that it takes the number of another edge, whose pairs are then lost to the barrier."""
    faces = np.array([[0, 1, 2], [3, 4, 5]])
    positions = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.25, 0.25, 0.2], [1, 0.5, 1], [0.5, 1, 1]])
    mesh = ipctk.CollisionMesh(positions, np.concatenate([ipctk.edges(faces), [[3, 3]]]), faces)
    near = tamis.Detector(bridge.mesh(mesh)).pairs_within(positions, 3.0)
    found = [
        sorted([sorted(mesh.edges[c.edge0_id]), sorted(mesh.edges[c.edge1_id])])
        for c in bridge.candidates(near, mesh).ee_candidates
    ]
    vertices = near.vertices[near.kind == tamis.PairKind.EDGE_EDGE]
    assert len(found) == 9 and found == [sorted([sorted(v[:2]), sorted(v[2:])]) for v in vertices]


def test_what_is_refused(pose: tuple[Any, Numbers]) -> None:
    mesh, positions = pose
    near = tamis.Detector(bridge.mesh(mesh)).pairs_within(positions, REACH)
    flat = ipctk.CollisionMesh(positions[:, :2], mesh.edges)
    floored = ipctk.CollisionMesh(positions, mesh.edges, mesh.faces)
    bridge.mesh(floored)
    floored.planes = [ipctk.Hyperplane(np.array([0.0, 0, 1]), np.zeros(3))]
    for wrong, sentence in ((flat, "2 dimensions: give"), (floored, "1 planes: give"), (near, "give an ipctk.Coll")):
        with pytest.raises(tamis.InvalidMesh, match=sentence):
            bridge.mesh(wrong)
        with pytest.raises(tamis.InvalidMesh, match=sentence):
            bridge.candidates(near, wrong)
    with pytest.raises(tamis.InvalidOptions, match=r"pairs is .*: give the NearPairs"):
        bridge.candidates(near.table, mesh)
    with pytest.raises(tamis.InvalidMesh, match="pair 0"):
        bridge.candidates(near, ipctk.CollisionMesh(positions, mesh.edges[:4]))
