"""Answers of a world against those of a detector of one mesh; and its tables."""

from __future__ import annotations

import pathlib
import pickle
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from conftest import CUBE, CUBE_FACES, END, FACES, START, at

import tamis

Array = npt.NDArray[np.float64]


def _one_mesh(starts: Array, ends: Array) -> tuple[tamis.Detector, Array, Array]:
    """Return a detector of all cubes as one mesh, and the positions at both ends; no cube may touch itself."""
    count = len(starts)
    faces = np.concatenate([CUBE_FACES + 8 * i for i in range(count)])
    groups = np.repeat(np.arange(count), 8)
    detector = tamis.Detector(tamis.Mesh(faces), groups=groups, may_touch=~np.eye(count, dtype=bool))
    return detector, *((CUBE + poses[:, :1]).reshape(-1, 3) for poses in (starts, ends))  # type: ignore[return-value]


def _named(contacts: tamis.BodyContacts) -> set[tuple[Any, ...]]:
    """Return a world's contacts with the vertices of the mesh of all cubes."""
    first = np.where(contacts.kind == tamis.PairKind.EDGE_EDGE, 2, 1)[:, np.newaxis] > np.arange(4)
    of_vertex = np.where(first, contacts.bodies[:, :1], contacts.bodies[:, 1:])
    vertices = contacts.vertices + 8 * of_vertex
    return {*zip(contacts.kind.tolist(), map(tuple, vertices.tolist()), contacts.toi_lower.tolist())}


def test_the_contacts_of_a_detector(cube: tamis.Shape) -> None:
    """Would catch another body's vertices, a body left out, and positions that are rounded in another way."""
    random = np.random.default_rng(5)
    starts, ends = (at(*random.uniform(-2, 2, (12, 3))) for _ in range(2))
    world = tamis.World(threads=1)
    bodies = world.add_many(cube, tamis.chain_between(starts, ends))
    assert bodies.tolist() == [*range(12)]
    found = world.contacts()
    detector, start, end = _one_mesh(starts, ends)
    expected = detector.contacts(start, end)
    assert len(expected) > 100
    alone = tamis.narrow_phase(expected.kind, expected.vertices, start, end)  # a world's contacts have these bits
    rows = zip(expected.kind.tolist(), map(tuple, expected.vertices.tolist()), alone.toi_lower.tolist())
    assert _named(found) == {*rows} and len(found) == len(expected)
    assert found.certified.all()
    firsts: dict[tuple[int, ...], float] = {}
    for pair, lower in zip(np.sort(found.bodies).tolist(), found.toi_lower.tolist()):
        firsts[tuple(pair)] = min(lower, firsts.get(tuple(pair), 1))
    of_pairs = world.first_contacts()
    assert [*map(tuple, np.sort(of_pairs.bodies).tolist())] == sorted(firsts)
    assert of_pairs.toi_lower.tolist() == [firsts[pair] for pair in sorted(firsts)]
    first, theirs = world.earliest(), detector.earliest(start, end)
    assert first.toi_lower == pytest.approx(theirs.toi_lower, abs=1e-12)
    assert first.contact is not None and not world.is_free()
    near, near_theirs = world.pairs_within(0.5), detector.pairs_within(start, 0.5)
    assert np.array_equal(np.sort(near.distance), np.sort(near_theirs.distance)) and len(near)
    assert len(world.intersections()) == len(detector.intersections(start)) > 0
    assert world.statistics.threads == 1 and world.statistics.memory_bytes > 0


def test_tables_have_the_bodies(cube: tamis.Shape) -> None:
    world = tamis.World()
    world.add(cube)
    world.add(cube, tamis.chain_between(at((3, 0, 0)), at((0.5, 0, 0)))[0])
    contacts = world.contacts()
    assert contacts.bodies.base is not None and contacts.bodies.shape == (len(contacts), 2)
    one = contacts[0]
    assert isinstance(one, tamis.BodyContact) and {*one.bodies} == {0, 1} and one.toi_lower == contacts.toi_lower[0]
    frame = contacts.to_pandas()
    assert [*frame.columns[:3]] == ["b0", "b1", "kind"] and len(frame) == len(contacts)
    assert (np.abs(contacts.weights.sum(1)) < 1e-12).all() and "first at 0.8" in repr(contacts)
    assert pickle.loads(pickle.dumps(contacts)) == contacts and contacts[contacts.kind == 0][:1][0].kind == 0
    assert not world.has_intersection()
    near = world.pairs_within(2)
    assert near[0].bodies == (0, 1) and near.distance.min() == 2 and [*near.to_pandas().columns[:2]] == ["b0", "b1"]
    world.move(1, at((0.5, 0.5, 0.5))[0])
    world.move(0, tamis.chain_between(at((0, 0, 0)), at((0, 0, 1)))[0])
    assert world.has_intersection()
    assert world.has_overlap()
    crossing = world.intersections()
    assert len(crossing) and crossing[0].bodies in ((0, 1), (1, 0))
    assert crossing.to_pandas()["b0"].tolist() == crossing.bodies[:, 0].tolist()


def test_a_body_inside_another_overlaps(cube: tamis.Shape) -> None:
    """It touches nothing, so all that moves within is free."""
    small = tamis.Shape(cube.mesh, cube.points * 0.25)
    world = tamis.World()
    world.add(cube)
    inner = world.add(small, tamis.chain_between(at((0, 0, 0)), at((0.125, 0, 0)))[0])
    assert world.is_free() and not world.has_intersection() and world.has_overlap()
    assert world.is_closed(0) and world.is_closed(inner)
    world.move(inner, at((5, 0, 0))[0])
    assert not world.has_overlap() and not world.has_overlap(include_static=True)
    world.move(inner, at((0, 0, 0))[0])
    assert not world.has_overlap() and world.has_overlap(include_static=True)
    sheet = world.add(tamis.Shape(tamis.Mesh(cube.mesh.faces[1:]), cube.points))
    assert not world.is_closed(sheet)
    with pytest.raises(tamis.InvalidOptions, match="the world has no body 9"):
        world.is_closed(9)


def test_features_are_those_of_both_meshes() -> None:
    """A rod and a point fall on a plate; each body numbers its vertices from 0."""
    plate = tamis.Shape(
        tamis.Mesh([[4, 3, 2]], vertex_count=5), [[0, 0, 0], [0, 0, 0], [0, 2, 0], [2, 0, 0], [0, 0, 0]]
    )
    loose = tamis.Mesh(np.empty((0, 3), int), 4, edges=[[1, 3]], points=[2])
    rod = tamis.Shape(loose, [[0.0, 0, 0], [-0.5, 0.5, 1], [0.5, 0.25, 1], [3, 0.5, 1]])
    world = tamis.World(min_separation=0.1)
    bodies = [world.add(plate), world.add(rod, tamis.chain_between(at((0, 0, 0)), at((0, 0, -2)))[0])]
    meshes = dict(zip(bodies, (plate.mesh, loose)))
    found: tuple[tamis.BodyContacts | tamis.BodyNearPairs, ...] = (world.contacts(), world.pairs_within(1.5))
    for rows in found:
        kinds, vertices, owners = rows.kind.tolist(), rows.vertices.tolist(), rows.bodies.tolist()
        assert {*kinds} >= {tamis.PairKind.VERTEX_FACE, tamis.PairKind.EDGE_EDGE}
        places = rows.features(meshes)
        assert places.shape == (len(rows), 2) and np.array_equal(rows.features([plate.mesh, loose]), places)
        for kind, corners, (mine, theirs), (first, second) in zip(kinds, vertices, owners, places.tolist()):
            if kind == tamis.PairKind.VERTEX_FACE:
                assert [first, *meshes[theirs].faces[second]] == corners
            elif kind == tamis.PairKind.EDGE_EDGE:
                assert [*meshes[mine].edges[first], *meshes[theirs].edges[second]] == corners
    with pytest.raises(tamis.InvalidMesh, match="meshes has none for body 1"):
        world.contacts().features({0: plate.mesh})
    with pytest.raises(tamis.InvalidMesh, match=r"meshes\[0\] has no feature"):
        world.contacts().features([loose, loose])
    with pytest.raises(tamis.InvalidMesh, match=r"meshes\[0\] is"):
        world.contacts().features([rod, loose])  # type: ignore[list-item]
    assert world.contacts()[:0].features({}).shape == (0, 2)


def test_a_table_is_saved(cube: tamis.Shape, tmp_path: pathlib.Path) -> None:
    world = tamis.World()
    world.add(cube)
    world.add(cube, tamis.chain_between(at((3, 0, 0)), at((0.5, 0, 0)))[0])
    contacts = world.contacts()
    contacts.save(tmp_path / "contacts.csv")
    head, *rows = (line.split(",") for line in (tmp_path / "contacts.csv").read_text().splitlines())
    frame = contacts.to_pandas()
    assert head == [*frame.columns] and len(rows) == len(contacts) > 0
    for name, column in zip(head, zip(*rows)):
        mine = frame[name].tolist()
        assert [type(x)(text) for x, text in zip(mine, column)] == mine
    with pytest.raises(tamis.Error, match="tamis bodies --out"):
        contacts.save(tmp_path / "contacts.html")
    with pytest.raises(tamis.FileError):
        contacts.save(tmp_path / "contacts.txt")
    assert [p.name for p in tmp_path.iterdir()] == ["contacts.csv"]


def test_turning_bodies_and_their_paths(cube: tamis.Shape) -> None:
    """A cube turns in place beside another: only its corners reach the other, as on a RigidPath."""
    chain = tamis.turned_chain(at((0, 0, 0))[0], [0, 0, np.pi / 2], [0, 0, 0])
    world = tamis.World(min_separation=0.01)
    world.add(cube, chain)
    still = world.add(cube, at((1.15, 0, 0))[0])
    faces = np.concatenate([CUBE_FACES, CUBE_FACES + 8])
    path = tamis.RigidPath(
        np.concatenate([CUBE, CUBE + np.array([1.15, 0, 0])]), np.repeat([0, 1], 8), [chain, np.empty((0, 4, 3))]
    )
    detector = tamis.Detector(
        tamis.Mesh(faces), min_separation=0.01, groups=np.repeat([0, 1], 8), may_touch=~np.eye(2, dtype=bool)
    )
    ours, theirs = world.earliest(tolerance=1e-6), detector.earliest(path, tolerance=1e-6)
    assert 0 < ours.toi_lower < 0.5 and abs(ours.toi_lower - theirs.toi_lower) <= 2e-6
    assert ours.toi_upper - ours.toi_lower <= 1e-6
    step = world.safe_step()
    assert step.pair is not None and 0 < step.toi_lower < ours.toi_lower and step.toi_upper - step.toi_lower < 1e-6
    world.move(still, at((5, 0, 0))[0])
    assert world.is_free() and world.safe_step().pair is None


def test_vertices_are_on_their_curves(cube: tamis.Shape) -> None:
    """Would catch points on the chord of a turn, or in the body's frame."""
    chain = tamis.turned_chain(at((0, 0, 0))[0], [0, 0, np.pi / 2], [2, 0, 0])
    world = tamis.World()
    turning, still = world.add(cube, chain), world.add(cube, at((5, 0, 0))[0])
    points, error = world.points_at(turning, 0.5)
    path = tamis.RigidPath(CUBE, np.zeros(8, int), [chain])
    assert np.array_equal(points, path.points_at(0.5)) and 0 < error < 1e-13
    points, error = world.points_at(still, 0.5)
    assert np.array_equal(points, CUBE + np.array([5, 0, 0])) and error == 0
    with pytest.raises(tamis.InvalidOptions, match="time is 2"):
        world.points_at(turning, 2)
    with pytest.raises(tamis.InvalidOptions, match="body 7"):
        world.points_at(7, 0.5)


def test_a_cloth_between_bodies() -> None:
    """A deforming body touches itself as a detector of its mesh says, unless it may not; and it meets a static body."""
    sheet = tamis.Shape(tamis.Mesh(FACES), START)
    world = tamis.World()
    falling = world.add(sheet, tamis.Deforming(START, END))
    assert [c.bodies for c in world.contacts()] == [(falling, falling)]
    step = world.safe_step(0.5)
    assert step == tamis.BodyStep(*tamis.Detector(sheet.mesh).safe_step(START, END, 0.5)[:2], step.pair)
    assert step.pair is not None and step.pair.bodies == (0, 0) and step.pair.kind == tamis.PairKind.VERTEX_FACE
    world.set_may_touch([falling, falling], False)
    assert world.is_free()
    world.add(sheet, at((0, 0, -0.5))[0])
    assert {*world.contacts().bodies.ravel().tolist()} == {0, 1}
    world.move(falling, tamis.Deforming(END, START))
    assert world.is_free(at_start="ignore") is False
    with pytest.raises(tamis.InvalidStep, match="body 0 has 5 points"):
        world.move(falling, tamis.Deforming(START[:5], END))
