"""Arrays of users: layouts that are read in place, layouts that are copied, and arrays that are refused."""

from __future__ import annotations

import gc
import weakref
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import tamis
from tamis._arrays import rows


def strided(points: np.ndarray, width: int = 5) -> np.ndarray:
    """Return `points` as the first columns of a wider array, whose other columns are NaN: reading one would show."""
    wide = np.full((len(points), width), np.nan)
    wide[:, :3] = points
    return wide[:, :3]


def read_only(points: np.ndarray) -> np.ndarray:
    copy = points.copy()
    copy.flags.writeable = False
    return copy


IN_PLACE: dict[str, Callable[[np.ndarray], np.ndarray]] = {
    "contiguous": np.ascontiguousarray,
    "rows with a stride": strided,
    "every second row": lambda p: np.repeat(p, 2, axis=0)[::2],
    "read-only": read_only,
}
COPIED: dict[str, Any] = {
    "float32": lambda p: p.astype(np.float32),
    "integers": lambda p: (4 * p).astype(np.int64),
    "another byte order": lambda p: p.astype(p.dtype.newbyteorder()),
    "columns first": np.asfortranarray,
    "negative stride": lambda p: p[::-1].copy()[::-1],
    "columns backwards": lambda p: p[:, ::-1].copy()[:, ::-1],
    "one row for all": lambda p: np.broadcast_to(p[:1], p.shape),
    "not aligned": lambda p: np.frombuffer(b"x" + p.tobytes(), dtype="V1")[1:].view(np.float64).reshape(p.shape),
    "a list": lambda p: p.tolist(),
    "half precision": lambda p: p.astype(np.float16),
}


@pytest.mark.parametrize("name", IN_PLACE)
def test_read_where_it_lies(falling: tamis.Scene, name: str) -> None:
    start, end = IN_PLACE[name](falling.start), IN_PLACE[name](falling.end)
    assert rows(start, "start") is start
    found = tamis.contacts(falling.mesh.faces, start, end)
    assert found.vertices.tolist() == [[3, 0, 1, 2]]


def test_one_row_of_any_stride() -> None:
    """Bug: a single reversed row was refused as no n x 3 array of doubles."""
    detector = tamis.Detector(tamis.Mesh([], 1, points=[0]))
    row = np.array([[1.0, 2.0, 3.0]])
    for one in (row[::-1], np.array([[0.0] * 3, row[0]])[::-2]):
        assert detector.is_free(one, one)


def test_a_mesh_file_has_positions(falling: tamis.Scene) -> None:
    with pytest.raises(tamis.InvalidStep, match=r"start is MeshFile\(.*: give its \.positions$"):
        tamis.Detector(falling.mesh).is_free(tamis.MeshFile(falling.start, falling.mesh, ()), falling.end)  # type: ignore[arg-type]


def test_the_largest_number_is_refused_by_name(falling: tamis.Scene) -> None:
    """Bug: the count did not fit 32 bits; the sentence named an argument that was not given, or none."""
    with pytest.raises(tamis.InvalidMesh, match="faces, edges or points name vertex 2147483647: give indices below"):
        tamis.Mesh([[0, 1, 2**31 - 1]])
    with pytest.raises(tamis.InvalidOptions, match="groups holds 2147483647: give groups below"):
        tamis.Detector(falling.mesh, groups=np.full(falling.mesh.vertex_count, 2**31 - 1))


@pytest.mark.parametrize("name", COPIED)
def test_copied_once(falling: tamis.Scene, name: str) -> None:
    start, end = COPIED[name](falling.start), COPIED[name](falling.end)
    assert rows(start, "start") is not start
    assert np.array_equal(rows(start, "start"), np.asarray(start, np.float64))
    expected = tamis.contacts(falling.mesh.faces, np.array(start, float), np.array(end, float))
    assert tamis.contacts(falling.mesh.faces, start, end) == expected


def test_arrays_that_die_early(soup: tamis.Scene) -> None:
    """Tables do not keep the inputs alive; contacts, which can be shown, do."""
    start, end = soup.start.copy(), soup.end.copy()
    gone = weakref.ref(start)
    found = tamis.Detector(tamis.Mesh(soup.mesh.faces.copy())).contacts(start, end)
    table, expected = found.table, found.table.copy()
    del start, end
    gc.collect()
    assert gone() is not None
    del found
    gc.collect()
    assert gone() is None
    assert np.array_equal(table, expected)


BAD_STEPS: dict[str, Any] = {
    "too few rows": np.zeros((5, 3)),
    "too many rows": np.zeros((7, 3)),
    "two columns": np.zeros((6, 2)),
    "one dimension": np.zeros(18),
    "three dimensions": np.zeros((6, 3, 1)),
    "objects": np.zeros((6, 3), object),
    "complex": np.zeros((6, 3), complex),
    "truth values": np.zeros((6, 3), bool),
    "text": [["a", "b", "c"]] * 6,
    "ragged": [[1, 2], [3]],
    "nothing": None,
    "dates": np.zeros((6, 3), "datetime64[s]"),
    "not a number": np.full((6, 3), np.nan),
    "infinite": np.full((6, 3), np.inf),
    "one row's memory": np.zeros((0, 3)),
}


@pytest.mark.parametrize("name", BAD_STEPS)
@pytest.mark.parametrize("which", [0, 1])
def test_bad_positions_are_refused_by_every_question(falling: tamis.Scene, name: str, which: int) -> None:
    detector = tamis.Detector(falling.mesh)
    step = [falling.start, falling.end]
    step[which] = BAD_STEPS[name]
    for ask in (detector.contacts, detector.earliest, detector.is_free, lambda s, e: detector.safe_step(s, e, 0.5)):
        with pytest.raises(tamis.InvalidStep, match=r": .*\b(give|use)\b"):
            ask(*step)
    assert len(detector.contacts(falling.start, falling.end)) == 1


BAD_FACES: dict[str, Any] = {
    "index too large": [[0, 1, 6]],
    "negative index": [[0, 1, -1]],
    "beyond 32 bits": [[0, 1, 2**33]],
    "floats": [[0.0, 1.0, 2.0]],
    "two columns": [[0, 1]],
    "objects": np.array([[0, 1, None]]),
    "text": [["0", "1", "2"]],
    "ragged": [[0, 1, 2], [3]],
    "nothing": None,
    "empty": [],
}


@pytest.mark.parametrize("name", BAD_FACES)
def test_bad_faces_are_refused(name: str) -> None:
    with pytest.raises(tamis.InvalidMesh):
        tamis.Mesh(BAD_FACES[name], vertex_count=6)


def test_other_bad_topology() -> None:
    for bad in ({"edges": [[0, 9]]}, {"edges": [0, 1]}, {"points": [[1]]}, {"points": [-1]}, {"points": ["a"]}):
        with pytest.raises(tamis.InvalidMesh):
            tamis.Mesh([[0, 1, 2]], vertex_count=6, **bad)
    for count in (-1, 2, 2**31):
        with pytest.raises(tamis.InvalidMesh):
            tamis.Mesh([[0, 1, 2]], vertex_count=count)


def test_the_mesh_cannot_be_changed_from_outside() -> None:
    faces = np.array([[0, 1, 2]])
    mesh = tamis.Mesh(faces)
    faces[0] = 0
    assert mesh.faces.tolist() == [[0, 1, 2]] and mesh.vertex_count == 3
    with pytest.raises(ValueError, match="read-only"):
        mesh.faces[0, 0] = 1


def test_a_mask_is_not_lost(falling: tamis.Scene) -> None:
    masked = np.ma.masked_array(falling.start, mask=True)
    with pytest.raises(tamis.InvalidStep, match="start is a masked array"):
        tamis.Detector(falling.mesh).is_free(masked, falling.end)


INEXACT: dict[str, Callable[[Any], Any]] = {
    "an integer": lambda rows: np.where(rows == 0, 2**53 + 1, 1).astype(np.int64),
    "an unsigned integer": lambda rows: np.where(rows == 0, np.uint64(2**64 - 1), np.uint64(1)),
    "more digits": lambda rows: rows + np.longdouble(1) / 3,
    "an integer of Python": lambda rows: [[2**53 + 1, 0.5, 0]] * len(rows),
    "beyond doubles": lambda rows: rows + np.longdouble(10) ** 400,
}


@pytest.mark.parametrize("name", INEXACT)
def test_what_a_double_would_round_is_refused(falling: tamis.Scene, name: str) -> None:
    """Bug: coordinates beyond 2^53 were rounded in silence, so that answers were about other positions."""
    if np.finfo(np.longdouble).nmant == 52 and name in ("more digits", "beyond doubles"):
        pytest.skip("long doubles are doubles here")
    bad = INEXACT[name](falling.start)
    detector = tamis.Detector(falling.mesh)
    for ask in (lambda: detector.contacts(bad, falling.end), lambda: detector.pairs_within(bad, 0.1)):
        with pytest.raises(tamis.InvalidStep, match="which a double would round"):
            ask()
    with pytest.raises(tamis.InvalidPath, match="which a double would round"):
        tamis.BezierPath([bad, falling.end])


def test_exact_numbers_of_any_type_are_taken(falling: tamis.Scene) -> None:
    whole = np.round(8 * falling.start)
    detector = tamis.Detector(falling.mesh)
    expected = detector.pairs_within(whole, 1.0)
    for dtype in (np.int64, np.float32, np.longdouble, ">f8", np.int16):
        assert detector.pairs_within(whole.astype(dtype), 1.0) == expected
    assert detector.pairs_within((whole.astype(np.int64) * 2**53), 1e16) is not None
    with pytest.raises(tamis.InvalidOptions, match="which a double would round"):
        detector.pairs_within(whole, 2**53 + 1)
