"""Single pairs: the latest time of interest, distances, safe steps; and the features of pairs in a mesh."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import tamis
import tamis.compat.ipctk as ipctk

VF, EE, VE, VV = tamis.PairKind
START = np.array([[0.2, 0.2, 1.0], [0, 0, 0], [1, 0, 0], [0, 1, 0]])
END = START - [[0, 0, 4], [0, 0, 0], [0, 0, 0], [0, 0, 0]]  # they meet at 0.25


@pytest.mark.parametrize(("latest", "touches"), [(0.0, False), (0.2, False), (0.3, True), (1.0, True)])
def test_only_until_the_latest_time(latest: float, touches: bool) -> None:
    above, below = np.array([[0, 0, 1.0]]), np.array([[0, 0, -3.0]])
    rest = np.array([[-1, -1, 0], [1, -1, 0], [0, 1, 0.0]])
    along = np.array([[0, -1, 0], [0, 1, 0.0]])
    for kind, moving, still in (
        (VF, [[0, 0, 0]], rest),
        (EE, [[-1, 0, 0], [1, 0, 0]], along),
        (VE, [[0, 0, 0]], along),
        (VV, [[0, 0, 0]], along[:1] * 0),
    ):
        start, end = (np.vstack([moving + height, still]) for height in (above, below))
        corners = [i if i < len(start) else -1 for i in range(4)]
        assert bool(tamis.narrow_phase(kind, corners, start, end, latest=latest).touches[0]) == touches


def test_latest_times_that_are_none() -> None:
    for latest in (-0.1, 1.1, float("nan")):
        with pytest.raises(tamis.InvalidOptions, match="latest"):
            tamis.narrow_phase(VF, [0, 1, 2, 3], START, END, latest=latest)


def test_distances_are_those_of_near_pairs(soup: tamis.Scene) -> None:
    near = tamis.Detector(soup.mesh).pairs_within(soup.start, 0.05)
    assert len(near) > 100
    assert tamis.distance_of(near.kind, near.vertices, soup.start) == near
    one = tamis.distance_of(VF, [0, 1, 2, 3], START)
    assert one.distance.tolist() == [1] and (one.weights != 0).all()
    apart = tamis.distance_of(tamis.PairKind.VERTEX_VERTEX, [[0, 1, -1, -1], [2, 3, -1, -1]], START)
    assert apart.distance == pytest.approx([np.sqrt(1.08), np.sqrt(2)])
    assert len(tamis.distance_of(VF, np.empty((0, 4), int), START)) == 0


def test_a_pair_keeps_its_distance() -> None:
    kept = tamis.safe_step(VF, [0, 1, 2, 3], START, END, 0.2)
    assert 0.199 < kept.toi_lower <= 0.2 <= kept.toi_upper
    assert kept.pair == tamis.distance_of(VF, [0, 1, 2, 3], START)[0]
    assert 0.124 < tamis.safe_step(VF, [0, 1, 2, 3], START, END, 0, min_separation=0.5).toi_lower <= 0.125
    assert tamis.safe_step(VF, [0, 1, 2, 3], START, END, 0.2, latest=0.1) == (0.1, 1.0, None)
    with pytest.raises(tamis.InvalidOptions):
        tamis.safe_step(VF, [0, 1, 2, 3], START, END, 1.0)


def test_features_by_number(soup: tamis.Scene) -> None:
    contacts = tamis.Detector(soup.mesh).contacts(soup.start, soup.end)
    places = soup.mesh.features_of(contacts.kind, contacts.vertices)
    assert places.shape == (len(contacts), 2)
    of_faces = contacts.kind == VF
    assert of_faces.any() and not of_faces.all()
    assert np.array_equal(places[of_faces, 0], contacts.vertices[of_faces, 0])
    assert np.array_equal(soup.mesh.faces[places[of_faces, 1]], contacts.vertices[of_faces, 1:])
    assert np.array_equal(soup.mesh.edges[places[~of_faces]].reshape(-1, 4), contacts.vertices[~of_faces])
    contact = contacts[0]
    assert np.array_equal(soup.mesh.features_of(contact.kind, contact.vertices), places[:1])
    assert np.array_equal(contacts.features(soup.mesh), places)
    near = tamis.Detector(soup.mesh).pairs_within(soup.start, 0.05)
    assert np.array_equal(near.features(soup.mesh), soup.mesh.features_of(near.kind, near.vertices)) and len(near)


# Bug: for a feature that the mesh lacks, -1 was returned, which is a row of every array.
@pytest.mark.parametrize(
    ("kind", "vertices", "says"),
    [
        (VF, [0, 1, 2, 10**6], "pair 1: the mesh has 6 vertices and none with the number 1000000"),
        (VF, [3, 2, 1, 0], "no face of the vertices 2, 1, 0 in this order, but 0, 1, 2"),
        (EE, [0, 1, 2, 3], "no edge between the vertices 2 and 3"),
    ],
)
def test_features_of_another_mesh(falling: tamis.Scene, kind: tamis.PairKind, vertices: list[int], says: str) -> None:
    with pytest.raises(tamis.InvalidMesh, match=says):
        falling.mesh.features_of([VF, kind], [[3, 0, 1, 2], vertices])


def test_edges_of_another_list() -> None:
    """Bug: ipctk's rows of edges could not be found in the mesh, and data was taken from wrong rows."""
    mesh = tamis.scene("folded-cloth", 200).mesh
    theirs = ipctk.edges(mesh.faces)
    places = mesh.find_edges(theirs)
    assert not np.array_equal(theirs, mesh.edges)
    assert np.array_equal(mesh.edges[places], theirs) and len(np.unique(places)) == len(mesh.edges)
    assert np.array_equal(mesh.find_edges(theirs[:, ::-1]), places)
    assert mesh.find_edges([[0, 0], [0, 10**6], [-1, 2]]).tolist() == [-1, -1, -1]
    assert mesh.find_faces(mesh.faces[::-1]).tolist() == list(range(len(mesh.faces)))[::-1]
    assert mesh.find_faces([mesh.faces[0, ::-1].tolist(), [0, 1, 10**6]]).tolist() == [-1, -1]


def test_bad_input_is_named(soup: tamis.Scene) -> None:
    kinds: list[Any] = [4, -1, [0, 0, 0], "vf", 0.5, None]
    two = [[0, 1, 2, 3], [0, 1, 2, 4]]
    with pytest.raises(tamis.InvalidStep, match="pair 1: vertex 4"):
        tamis.distance_of(VF, two, START)
    with pytest.raises(tamis.InvalidStep, match="one pair"):
        tamis.safe_step(VF, two, START, END, 0)
    for ask, error in (
        (lambda kind, vertices: tamis.distance_of(kind, vertices, START), tamis.InvalidStep),
        (lambda kind, vertices: tamis.safe_step(kind, vertices, START, END, 0), tamis.InvalidStep),
        (soup.mesh.features_of, tamis.InvalidMesh),
    ):
        for kind in kinds:
            with pytest.raises(error, match="kind"):
                ask(kind, two)
        for vertices in ([0, 1, 2], [[[0, 1, 2, 3]]], "no", [[0, 1, 2, 0.5]], [0, 1, 2, 2**40]):
            with pytest.raises(error, match="vertices"):
                ask(VF, vertices)
    bad = START.copy()
    bad[2, 1] = np.nan
    with pytest.raises(tamis.InvalidStep, match="pair 0: vertex 2"):
        tamis.distance_of(VF, [0, 1, 2, 3], bad)
