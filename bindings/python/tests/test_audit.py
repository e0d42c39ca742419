"""Audits of whole motions."""

from __future__ import annotations

import base64
import json
import pathlib
import pickle
import re
import signal
import struct
import threading
import zlib
from collections.abc import Iterator

import numpy as np
import numpy.typing as npt
import pytest
from conftest import END, FACES, START

import tamis

FRAMES = np.stack([START, START, END, START])


def _found(report: tamis.AuditReport) -> list[tuple[int, str, tuple[int, ...], int]]:
    return [(pair.frame, pair.kind.short_name, pair.vertices, pair.rings) for pair in report.pairs]


EXPECTED = [
    (2, "ef", (3, 4, 0, 1, 2), -1),
    (2, "ef", (3, 5, 0, 1, 2), -1),
    (2, "vf", (3, 0, 1, 2), -1),
    (3, "vf", (3, 0, 1, 2), -1),
]


def _check(report: tamis.AuditReport) -> None:
    assert _found(report) == EXPECTED
    assert not report.is_free and report.first_bad is not None and report.first_bad.frame == 2
    assert len(report.frames) == 4 and len(report.steps) == 3 and report.problems == {}


def test_arrays() -> None:
    _check(tamis.audit(FRAMES, faces=FACES))
    _check(tamis.audit(FRAMES, mesh=tamis.Mesh(FACES), threads=1))
    _check(tamis.audit(FRAMES.astype(np.float32)[:, ::1], faces=FACES))
    _check(tamis.audit(FRAMES.tolist(), faces=FACES))
    assert tamis.audit(FRAMES[:2], faces=FACES).is_free


def test_a_frame_that_was_never_written_is_one_fact(tmp_path: pathlib.Path) -> None:
    """Bug: all pairs of a frame of zeros are listed, or the frame is called free because none is."""
    x, y = (axis.ravel().astype(float) for axis in np.meshgrid(range(30), range(30)))
    corners = np.array([i for i in range(29 * 30) if i % 30 < 29])[:, None]
    faces = np.concatenate([corners + np.array(square) for square in ([0, 1, 31], [0, 31, 30])])
    sheet = np.stack([x, y, 0 * x], axis=1)
    report = tamis.audit([sheet, 0 * sheet, sheet], faces=faces)
    assert report.frames.has_collapsed.tolist() == [False, True, False]
    assert report.frames.is_bad.tolist() == [False, True, False]
    assert not report.is_free and report.first_bad is not None and report.first_bad.has_collapsed
    assert len(report.pairs) == 0 and "lie at one point" in report.notes[1]
    assert report.frames.to_pandas()["has_collapsed"].tolist() == [False, True, False]
    report.save(tmp_path / "page.html")
    auditor = tamis.Auditor(tamis.Mesh(faces))
    assert auditor.add(sheet).is_free
    collapsed = auditor.add(0 * sheet)
    assert collapsed.frame.has_collapsed and not collapsed.is_free


def test_iterables() -> None:
    _check(tamis.audit((frame for frame in FRAMES), faces=FACES))
    _check(tamis.audit(list(FRAMES), faces=FACES))


def test_files(tmp_path: pathlib.Path) -> None:
    for i, frame in enumerate(FRAMES):
        tamis.write_mesh(tmp_path / f"f{i}.ply", frame, FACES)
    _check(tamis.audit(tmp_path))
    _check(tamis.audit(str(tmp_path / "f*.ply")))
    _check(tamis.audit([tmp_path / f"f{i}.ply" for i in range(4)]))
    _check(tamis.audit(tamis.read_frames(tmp_path)))
    named = tamis.audit(tmp_path, objects={"floor": range(3), "spike": slice(3, 6)})
    assert [pair.objects for pair in named.pairs] == [("spike", "floor")] * 4
    with pytest.raises(tamis.InvalidMesh, match="brings its own mesh"):
        tamis.audit(tmp_path, faces=FACES)


def test_a_point_cache(tmp_path: pathlib.Path) -> None:
    head = struct.pack("<12siiffi", b"POINTCACHE2\0", 1, 6, 0.0, 1.0, 4)
    (tmp_path / "a.pc2").write_bytes(head + FRAMES.astype("<f4").tobytes())
    tamis.write_mesh(tmp_path / "a.ply", START, FACES)
    _check(tamis.audit([tmp_path / "a.ply", tmp_path / "a.pc2"]))
    _check(tamis.audit(tmp_path / "a.pc2", mesh=tamis.Mesh(FACES)))
    with pytest.raises(tamis.FileError, match="together with one mesh file"):
        tamis.audit(tmp_path / "a.pc2")


def test_an_archive(tmp_path: pathlib.Path) -> None:
    np.savez(tmp_path / "a.npz", P=FRAMES, F=FACES)
    np.savez_compressed(tmp_path / "b.npz", positions=FRAMES.astype(np.float32), faces=FACES.astype(np.int64))
    _check(tamis.audit(tmp_path / "a.npz"))
    _check(tamis.audit(tmp_path / "b.npz"))
    np.savez(tmp_path / "c.npz", P=FRAMES)
    _check(tamis.audit(tmp_path / "c.npz", faces=FACES))
    with pytest.raises(tamis.FileError, match="the faces"):
        tamis.audit(tmp_path / "c.npz")
    (tmp_path / "d.npz").write_bytes(b"PK nothing")
    with pytest.raises(tamis.FileError, match=r"d\.npz"):
        tamis.audit(tmp_path / "d.npz")


def test_tables() -> None:
    report = tamis.audit(FRAMES, faces=FACES, objects=[0, 0, 0, 1, 1, 1])
    frames = report.frames.to_pandas()
    assert frames["ef"].tolist() == [0, 0, 2, 0] and frames["vf"].tolist() == [0, 0, 1, 1]
    assert frames["name"].tolist() == ["0", "1", "2", "3"] and frames["has_step"].tolist() == [False, True, True, True]
    pairs = report.pairs.to_pandas()
    assert pairs["frame"].tolist() == [2, 2, 2, 3] and pairs["object_a"].tolist() == ["1"] * 4
    assert report.rings == {-1: 4} and report.pairs_left_out == 0
    assert report.frames.is_bad.tolist() == [False, False, True, True]
    assert report.pairs[report.pairs.kind == tamis.AuditKind.EDGE_FACE].frame.tolist() == [2, 2]
    assert report.frames[2].contacts == 1 and report.steps[0].name == "1"
    assert abs(report.frames[2].toi_lower - 0.5) < 1e-9
    assert pickle.loads(pickle.dumps(report.pairs)) == report.pairs
    few = tamis.audit(FRAMES, faces=FACES, listed_pairs=1)
    assert len(few.pairs) == 1 and few.pairs_left_out == 3 and few.rings == {-1: 4}


def test_rings() -> None:
    # Four triangles in a row, folded so that the last passes through the first.
    faces = np.array([[0, 1, 2], [1, 3, 2], [2, 3, 4], [3, 5, 4]])
    flat = np.array([[0, 0, 0], [1, 0, 0], [0.5, 1, 0], [1.5, 1, 0], [1, 2, 0], [2, 2, 0]], float)
    folded = flat.copy()
    folded[4], folded[5] = [0.5, 0.2, -0.5], [0.5, 0.3, 0.5]
    report = tamis.audit(np.stack([flat, folded]), faces=faces)
    assert set(report.pairs.rings.tolist()) == {1}
    assert report.frames[1].neighbours == len(report.pairs) > 0
    assert report.rings == {1: len(report.pairs)}


def test_frames_that_cannot_be_used() -> None:
    frames = FRAMES.copy()
    frames[1, 0, 0] = np.nan
    report = tamis.audit(frames, faces=FACES)
    assert list(report.problems) == [1] and "vertex 0 is not finite" in report.problems[1]
    assert "frames that could not be tested: 1" in repr(report)
    assert len(report.steps) == 1 and report.frames.intersections.tolist() == [0, 0, 2, 0]
    assert not tamis.audit(frames[:2], faces=FACES).is_free


def _broken() -> Iterator[npt.NDArray[np.float64]]:
    yield from FRAMES
    raise RuntimeError("the host is gone")


def test_what_was_done_is_not_lost() -> None:
    with pytest.raises(RuntimeError, match="the host is gone") as caught:
        tamis.audit(_broken(), faces=FACES)
    report: tamis.AuditReport = caught.value.report  # type: ignore[attr-defined]
    assert _found(report) == EXPECTED and not report.is_free


def test_control_c_ends_it() -> None:
    signal.signal(signal.SIGINT, signal.default_int_handler)  # also where the parent ignores it

    def endless() -> Iterator[npt.NDArray[np.float64]]:
        while True:
            yield START

    timer = threading.Timer(0.5, signal.raise_signal, [signal.SIGINT])
    timer.start()
    with pytest.raises(KeyboardInterrupt) as caught:
        tamis.audit(endless(), faces=FACES)
    assert len(caught.value.report.frames) > 0  # type: ignore[attr-defined]


def test_progress() -> None:
    told: list[int] = []
    tamis.audit(np.repeat(START[np.newaxis], 100, axis=0), faces=FACES, threads=1, progress=told.append)
    assert told == sorted(told) and told[-1] == 100


def test_a_frame_after_another() -> None:
    auditor = tamis.Auditor(tamis.Mesh(FACES), objects={"floor": slice(0, 3), "spike": [3, 4, 5]}, threads=1)
    buffer = np.empty((6, 3), np.float32)
    steps = []
    for frame in FRAMES:
        buffer[:] = frame  # as hosts do: the same memory for all frames
        steps.append(auditor.add(buffer))
    assert [step.is_free for step in steps] == [True, True, False, False]
    assert steps[2].pairs[2].objects == ("spike", "floor") and steps[2].frame.contacts == 1
    assert auditor.add(START * np.nan, "lost").problem != ""
    report = auditor.report()
    assert _found(report) == EXPECTED and report.frames.names == ["0", "1", "2", "3", "lost"]
    with pytest.raises(tamis.InvalidStep):
        auditor.add([[0, 0]])


def test_the_page(tmp_path: pathlib.Path) -> None:
    report = tamis.audit(FRAMES, faces=FACES)
    report.save(tmp_path / "a.html")
    report.save(tmp_path / "a.csv")
    assert (tmp_path / "a.html").read_text().startswith("<!doctype html>")
    assert len((tmp_path / "a.csv").read_text().splitlines()) == 5
    with pytest.raises(tamis.Error, match=r"\.html"):
        report.save(tmp_path / "a.png")


def test_misuse() -> None:
    with pytest.raises(tamis.InvalidMesh, match="give mesh"):
        tamis.audit(FRAMES)
    with pytest.raises(tamis.InvalidMesh, match="both"):
        tamis.audit(FRAMES, mesh=tamis.Mesh(FACES), faces=FACES)
    with pytest.raises(tamis.InvalidStep, match="no frame"):
        tamis.audit([], faces=FACES)
    with pytest.raises(tamis.InvalidStep, match="no frame"):
        tamis.audit(np.zeros((0, 6, 3)), faces=FACES)
    with pytest.raises(tamis.InvalidMesh, match="numbers for 6 vertices"):
        tamis.audit(FRAMES, faces=FACES, objects=[0, 1])
    with pytest.raises(tamis.InvalidMesh, match="spike"):
        tamis.audit(FRAMES, faces=FACES, objects={"spike": [99]})


def test_arrays_whose_first_dimension_is_the_vertex_are_refused() -> None:
    faces = [[0, 1, 2], [2, 1, 3]]
    for given in ({"faces": faces}, {"mesh": tamis.Mesh(faces)}):
        with pytest.raises(tamis.InvalidStep, match=r"give \(frames, vertices, 3\), as numpy.swapaxes"):
            tamis.audit(np.zeros((4, 9, 3)), **given)
    assert len(tamis.audit(np.random.default_rng(1).random((4, 4, 3)), faces=faces).frames) == 4


def test_vertices_at_one_place_are_noted() -> None:
    corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    report = tamis.audit([corners, corners], faces=[[0, 1, 2], [3, 4, 5]])
    assert list(report.notes) == [0] and "2 of 6 vertices lie exactly on another one" in report.notes[0]
    assert (
        "the mesh is 100 times as large"
        in tamis.audit(np.array([corners, np.array(corners) * 100]), faces=[[0, 1, 2]]).notes[1]
    )


def test_new_pairs_are_told_from_those_of_the_frame_before() -> None:
    """Bug: pairs that last from the first frame on bury those of an accident."""
    report = tamis.audit(FRAMES, faces=FACES)
    assert report.pairs.is_new.tolist() == [True, True, True, False]
    assert report.frames.new.tolist() == [0, 0, 3, 0]
    assert report.first_new is not None and report.first_new.frame == 2 and report.first_new.new == 3
    permanent = tamis.audit(FRAMES[[2, 2, 2]], faces=FACES)
    assert not permanent.is_free and permanent.first_new is None
    auditor = tamis.Auditor(tamis.Mesh(FACES))
    assert [auditor.add(frame).pairs.is_new.tolist() for frame in FRAMES] == [[], [], [True, True, True], [False]]


def test_the_page_has_the_names_of_objects(tmp_path: pathlib.Path) -> None:
    """Bug: names that `objects` gives do not reach the page, which numbers the connected parts."""
    names = {"/World/Floor": range(3), "/World/Spike": slice(3, 6)}
    tamis.audit(FRAMES, faces=FACES, objects=names).save(tmp_path / "named.html")
    text = (tmp_path / "named.html").read_text()
    data = re.search(r'id="scene">\s*([A-Za-z0-9+/=\s]+?)\s*</script', text)
    assert data is not None
    bytes_ = zlib.decompress(base64.b64decode(data.group(1)))
    header = json.loads(bytes_[4 : 4 + int.from_bytes(bytes_[:4], "little")])
    assert header["mesh"]["names"] == list(names)


def test_frames_for_the_page_are_bounded(tmp_path: pathlib.Path) -> None:
    """Bug: an audit that nobody looks at keeps 256 MB of frames, whereas the documents speak of rows alone."""
    n = 100_000
    flat = np.zeros((n, 3))
    flat[:, 0] = np.arange(n)
    frames = (flat + np.array([0, 0, i]) for i in range(40))  # 96 MB
    before = _resident()
    report = tamis.audit(frames, mesh=tamis.Mesh([[0, 1, 2]], n), page_bytes=1 << 20)
    assert _resident() - before < 100 << 20  # what a detector of them needs, and not the frames
    with pytest.raises(tamis.FileError, match="too large to keep"):
        report.save(tmp_path / "page.html")


def _resident() -> int:
    resource = pytest.importorskip("resource")  # Windows does not have it
    return int(pathlib.Path("/proc/self/statm").read_text().split()[1]) * int(resource.getpagesize())
