"""All tables of answers work alike: rows, parts, weights, points, features, data frames."""

from __future__ import annotations

import csv
import os
import pathlib
import pickle
import subprocess
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

import tamis

D = 0.05


@pytest.fixture(scope="module")
def mixed() -> tamis.Scene:
    """Return random triangles, rods and points, with all four kinds of pairs."""
    random = np.random.default_rng(4)
    mesh = tamis.Mesh(np.arange(36).reshape(-1, 3), 90, np.arange(36, 60).reshape(-1, 2), np.arange(60, 90))
    start = random.random((90, 3))
    return tamis.Scene(mesh, start, start + 0.3 * random.standard_normal((90, 3)), np.zeros(90, np.int32))


@pytest.fixture(scope="module")
def answers(mixed: tamis.Scene) -> dict[str, Any]:
    detector = tamis.Detector(mixed.mesh)
    contacts = detector.contacts(mixed.start, mixed.end, min_separation=D)
    assert set(contacts.kind) == {0, 1, 2, 3}
    return {
        "contacts": contacts,
        "near": detector.pairs_within(mixed.start, 0.2),
        "intersections": detector.intersections(mixed.start),
        "pairs": tamis.narrow_phase(contacts.kind, contacts.vertices, mixed.start, mixed.end, min_separation=D),
    }


NAMES = pytest.mark.parametrize("name", ["contacts", "near", "intersections", "pairs"])


@NAMES
def test_rows_and_parts(answers: dict[str, Any], name: str) -> None:
    """Bug: near pairs, intersections and single pairs could not be indexed, nor iterated over."""
    answer = answers[name]
    n = len(answer)
    assert n > 4 and answer[-1] == answer[n - 1] == list(answer)[-1]
    assert answer[np.int64(2)] == answer[2]
    for part in (answer[1:3], answer[[1, 2]], answer[(np.arange(n) > 0) & (np.arange(n) < 3)]):
        assert type(part) is type(answer) and list(part) == list(answer)[1:3] and part == answer[1:3]
    assert len(answer[:0]) == 0 and list(answer[:0]) == []
    row = answer[1]._asdict()
    for field in ("u", "v"):
        assert row[field] == getattr(answer, field)[1]
    assert all(isinstance(value, (bool, int, float, tuple)) for value in row.values())
    with pytest.raises(IndexError):
        answer[n]
    for wrong in ("u", ["u"], (slice(None), None)):
        with pytest.raises(IndexError):
            answer[wrong]
    copy = pickle.loads(pickle.dumps(answer))
    assert copy == answer and type(copy) is type(answer) and repr(copy) == repr(answer)


@NAMES
def test_to_pandas(answers: dict[str, Any], name: str) -> None:
    answer = answers[name]
    frame = answer.to_pandas()
    assert len(frame) == len(answer) and frame["u"].tolist() == answer.u.tolist()
    assert len(answer[:0].to_pandas()) == 0


def _columns(path: pathlib.Path) -> dict[str, list[str]]:
    with path.open() as file:
        rows = list(csv.DictReader(file))
    return {name: [row[name] for row in rows] for name in rows[0]}


@pytest.mark.parametrize(("verb", "more"), [("within", ["--distance", "0.2"]), ("intersections", [])])
def test_tables_of_the_command_have_these_columns(
    mixed: tamis.Scene, tmp_path: pathlib.Path, verb: str, more: list[str]
) -> None:
    command = os.environ.get("TAMIS_COMMAND")
    if not command:
        pytest.skip("TAMIS_COMMAND does not say where the command is")
    pose = tamis.read_mesh(_written(mixed, tmp_path / "pose.ply"))
    detector = tamis.Detector(pose.mesh)
    answer = detector.pairs_within(pose.positions, 0.2) if verb == "within" else detector.intersections(pose.positions)
    subprocess.run([command, verb, tmp_path / "pose.ply", *more, "--out", tmp_path / "t.csv"], capture_output=True)
    columns, frame = _columns(tmp_path / "t.csv"), answer.to_pandas()
    assert list(columns) == list(frame.columns)
    for name, values in columns.items():
        assert [type(mine)(theirs) for mine, theirs in zip(frame[name].tolist(), values)] == frame[name].tolist()


def _written(scene: tamis.Scene, path: pathlib.Path) -> pathlib.Path:
    mesh = scene.mesh
    tamis.write_mesh(path, scene.start, mesh.faces, mesh.loose_edges, mesh.loose_points)
    return path


def _between(points: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    lengths: npt.NDArray[np.float64] = np.linalg.norm(points[:, 0] - points[:, 1], axis=1)
    return lengths


def test_points_of_contacts(mixed: tamis.Scene, answers: dict[str, Any]) -> None:
    """Would catch a weight of another vertex, or of another sign."""
    contacts = answers["contacts"]
    points = contacts.points(mixed.start, mixed.end)
    late = contacts.toi_lower > 0  # pairs that touch at the start may be nearer
    assert points.shape == (len(contacts), 2, 3) and late.sum() > 20
    assert np.allclose(_between(points)[late], D, atol=1e-9)
    t = contacts.toi_upper[:, None, None]
    x = (1 - t) * mixed.start[contacts.vertices] + t * mixed.end[contacts.vertices]
    vector = np.einsum("ni,nij->nj", contacts.weights, x)
    assert np.allclose(vector, points[:, 0] - points[:, 1])
    assert np.allclose(contacts.weights.sum(1), 0) and contacts.weights.shape == (len(contacts), 4)


def test_points_of_contacts_on_a_path(mixed: tamis.Scene) -> None:
    path = tamis.BezierPath([mixed.start, mixed.end, mixed.start])
    contacts = tamis.Detector(mixed.mesh).contacts(path, min_separation=D)
    certified = contacts.certified & (contacts.toi_lower > 0)
    assert certified.sum() > 10
    assert np.allclose(_between(contacts.points(path))[certified], D, atol=1e-6)
    first = contacts[int(np.argmax(certified))]
    at = path.points_at(first.toi_upper)
    alone = contacts[[int(np.argmax(certified))]]
    corners = np.where(np.less(first.vertices, 0)[:, None], 0, at[list(first.vertices)])
    assert np.allclose(alone.points(path)[0, 0] - alone.points(path)[0, 1], alone.weights[0] @ corners)


def test_points_of_near_pairs(mixed: tamis.Scene, answers: dict[str, Any]) -> None:
    near = answers["near"]
    assert set(near.kind) == {0, 1, 2, 3}
    points = near.points(mixed.start)
    assert np.allclose(points[:, 0] - points[:, 1], near.distance[:, None] * near.direction, atol=1e-12)
    assert near[0].distance == near.distance[0] and near[0].direction == tuple(near.direction[0])


def test_points_of_intersections(mixed: tamis.Scene, answers: dict[str, Any]) -> None:
    found = answers["intersections"]
    points = found.points(mixed.start)
    assert np.allclose(points[:, 0], points[:, 1], atol=1e-9)
    assert np.allclose(found.weights.sum(1), 0) and np.array_equal(found.vertices[:, 2:], found.face)
    places = found.features(mixed.mesh)
    assert np.array_equal(mixed.mesh.edges[places[:, 0]], found.edge)
    assert np.array_equal(mixed.mesh.faces[places[:, 1]], found.face)
    with pytest.raises(tamis.InvalidMesh, match="the mesh has no edge"):
        found.features(tamis.Mesh([[0, 1, 2]], 90))


def test_points_of_single_pairs(mixed: tamis.Scene, answers: dict[str, Any]) -> None:
    """Bug: the answers about single pairs had neither kinds nor vertices."""
    pairs, contacts = answers["pairs"], answers["contacts"]
    assert np.array_equal(pairs.kind, contacts.kind) and np.array_equal(pairs.vertices, contacts.vertices)
    assert pairs[7].vertices == contacts[7].vertices and pairs[7].kind == contacts[7].kind
    points = pairs.points(mixed.start, mixed.end)
    assert np.allclose(points, contacts.points(mixed.start, mixed.end), atol=1e-9)
    assert np.allclose(pairs.weights, contacts.weights, atol=1e-9)


@pytest.mark.parametrize("name", ["contacts", "near", "pairs"])
def test_features(mixed: tamis.Scene, answers: dict[str, Any], name: str) -> None:
    answer = answers[name]
    places = answer.features(mixed.mesh)
    assert np.array_equal(places, mixed.mesh.features_of(answer.kind, answer.vertices))
    of_edges = answer.kind == tamis.PairKind.EDGE_EDGE
    assert np.array_equal(mixed.mesh.edges[places[of_edges]].reshape(-1, 4), answer.vertices[of_edges])
    of_faces = answer.kind == tamis.PairKind.VERTEX_FACE
    assert np.array_equal(mixed.mesh.faces[places[of_faces, 1]], answer.vertices[of_faces, 1:])
    with pytest.raises(tamis.InvalidMesh, match=r"pair \d+"):
        answer.features(tamis.Mesh([[0, 1, 2]], 90))


def test_positions_that_do_not_fit(mixed: tamis.Scene, answers: dict[str, Any]) -> None:
    asks: list[Callable[[], object]] = [
        lambda: answers["contacts"].points(mixed.start[:5], mixed.end[:5]),
        lambda: answers["near"].points(mixed.start[:5]),
        lambda: answers["intersections"].points(mixed.start[:2]),
        lambda: answers["pairs"].points(mixed.start[:4], mixed.end[:4]),
    ]
    for ask in asks:
        with pytest.raises(tamis.InvalidStep, match=": give"):
            ask()
