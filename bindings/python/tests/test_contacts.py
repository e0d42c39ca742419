"""Contacts as arrays, rows, tables and files."""

from __future__ import annotations

import csv
import pathlib
import pickle

import numpy as np
import pytest

import tamis


@pytest.fixture
def found(soup: tamis.Scene) -> tamis.Contacts:
    return tamis.Detector(soup.mesh).contacts(soup.start, soup.end)


def test_indexing_as_a_list_and_as_an_array(found: tamis.Contacts) -> None:
    n = len(found)
    assert n > 100
    assert found[-1] == found[n - 1]
    assert found[2].vertices == tuple(found.vertices[2].tolist())
    assert found[2].normal == tuple(found.normal[2].tolist())
    assert [c.toi_lower for c in found] == found.toi_lower.tolist()
    assert len(found[10:20]) == 10 and found[10:20][0] == found[10]
    late = found[found.toi_lower > 0.5]
    assert 0 < len(late) < n and late.toi_lower.min() > 0.5
    assert found[[3, 1]][0] == found[3]
    for outside in (n, -n - 1):
        with pytest.raises(IndexError):
            found[outside]


def test_columns_are_views_of_one_table(found: tamis.Contacts) -> None:
    assert found.table.shape == (len(found),)
    for name in ("kind", "vertices", "toi_lower", "toi_upper", "u", "v", "normal"):
        assert np.shares_memory(getattr(found, name), found.table)
    assert found.vertices.dtype == np.int32 and found.normal.shape == (len(found), 3)
    assert np.allclose(np.linalg.norm(found.normal, axis=1), 1)


def test_contacts_are_sorted_by_kind_and_vertices(found: tamis.Contacts) -> None:
    keys = [(c.kind, c.vertices) for c in found]
    assert keys == sorted(keys)


def test_saved_numbers_read_back_to_the_same_doubles(found: tamis.Contacts, tmp_path: pathlib.Path) -> None:
    for part in (found, found[::3]):  # the second has gaps between its rows
        part.save(tmp_path / "contacts.csv")
        with (tmp_path / "contacts.csv").open() as file:
            rows = list(csv.DictReader(file))
        assert [float(row["toi_upper"]) for row in rows] == part.toi_upper.tolist()
        assert [int(row["v2"]) for row in rows] == part.vertices[:, 2].tolist()
        assert {row["status"] for row in rows} == {"certified"}
        frame = part.to_pandas()
        assert list(frame.columns) == list(rows[0])
        assert [[str(row[name]) for row in rows] for name in ("kind", "v0", "v3", "status")] == [
            [str(value) for value in frame[name]] for name in ("kind", "v0", "v3", "status")
        ]
        for name in ("toi_lower", "u", "v", "nx", "ny", "nz"):
            assert [float(row[name]) for row in rows] == frame[name].tolist()
        assert np.array_equal(frame[["nx", "ny", "nz"]], part.normal)


def test_a_folder_that_is_not_there(found: tamis.Contacts, tmp_path: pathlib.Path) -> None:
    with pytest.raises(tamis.FileError, match="nowhere"):
        found.save(tmp_path / "nowhere" / "contacts.csv")


def test_results_stay_as_they_are(soup: tamis.Scene) -> None:
    """Would catch memory that the detector reuses while an array still refers to it."""
    detector = tamis.Detector(soup.mesh)
    first = detector.contacts(soup.start, soup.end)
    copy = first.table.copy()
    times = first.toi_lower
    del first
    for _ in range(3):
        detector.contacts(soup.end, soup.start)
    assert np.array_equal(times, copy["toi_lower"])
    again = detector.contacts(soup.start, soup.end)
    assert again == tamis.Contacts(copy)
    del detector
    assert again == tamis.Contacts(copy)


def test_pickled_and_back(found: tamis.Contacts, soup: tamis.Scene) -> None:
    assert pickle.loads(pickle.dumps(found)) == found
    mesh = pickle.loads(pickle.dumps(tamis.Mesh(soup.mesh.faces, edges=[[0, 1]], points=[2])))
    assert np.array_equal(mesh.faces, soup.mesh.faces) and mesh.vertex_count == soup.mesh.vertex_count
    assert mesh.loose_edges.tolist() == [[0, 1]] and mesh.loose_points.tolist() == [2]
    first = tamis.Detector(soup.mesh).earliest(soup.start, soup.end)
    assert pickle.loads(pickle.dumps(first)) == first
    with pytest.raises(TypeError, match="pickle its Mesh"):
        pickle.dumps(tamis.Detector(soup.mesh))
