"""Pages of contacts, and other files to look at."""

from __future__ import annotations

import base64
import gc
import json
import os
import pathlib
import pickle
import re
import subprocess
import sys
import types
import weakref
import zlib
from typing import Any

import numpy as np
import pytest

import tamis


@pytest.fixture
def opened(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Collect the addresses that a browser would be asked to open."""
    addresses: list[str] = []
    monkeypatch.setattr("webbrowser.open", addresses.append)
    return addresses


def scene_in(page: pathlib.Path) -> tuple[dict[str, Any], bytes]:
    """Return the header and the columns of a page, as the page's script reads them."""
    text = re.search(r'<script[^>]*id="scene"[^>]*>([^<]*)<', page.read_text())
    assert text
    data = zlib.decompress(base64.b64decode(text[1]))
    size = int.from_bytes(data[:4], "little")
    return json.loads(data[4 : 4 + size]), data[4 + size :]


def test_view_opens_the_page_in_the_browser(soup: tamis.Scene, opened: list[str]) -> None:
    contacts = tamis.Detector(soup.mesh).contacts(soup.start, soup.end)
    page = contacts.view()
    assert opened == [page.path.as_uri()] and repr(page) == f"Page({str(page.path)!r})"
    assert os.fspath(page) == str(page.path) and page.path.suffix == ".html"
    header, _ = scene_in(page.path)
    assert header["steps"][0]["contacts"]["ee"] == int((contacts.kind == tamis.PairKind.EDGE_EDGE).sum())
    assert header["mesh"]["faces"] == len(soup.mesh.faces) and header["names"] == ["start", "end"]
    assert header["steps"][0]["stages"][0]["name"] == "boxes"


@pytest.mark.skipif("TAMIS_COMMAND" not in os.environ, reason="TAMIS_COMMAND names no command")
def test_it_is_the_page_of_the_command(soup: tamis.Scene, opened: list[str], tmp_path: pathlib.Path) -> None:
    for name, positions in (("start.ply", soup.start), ("end.ply", soup.end)):
        tamis.write_mesh(tmp_path / name, positions, soup.mesh.faces)
    command = [os.environ["TAMIS_COMMAND"], "view", "start.ply", "end.ply", "--min-separation", "0.01"]
    subprocess.run(command, cwd=tmp_path, check=True, stdout=subprocess.PIPE)
    detector = tamis.Detector(soup.mesh)
    ours = scene_in(detector.contacts(soup.start, soup.end, min_separation=0.01).view(tmp_path / "ours.html").path)
    theirs = scene_in(tmp_path / "view.html")
    assert theirs[0].pop("names") == ["start.ply", "end.ply"] and ours[0].pop("names")
    assert ours == theirs


def test_a_part_of_the_contacts(soup: tamis.Scene, opened: list[str], tmp_path: pathlib.Path) -> None:
    contacts = tamis.Detector(soup.mesh).contacts(soup.start, soup.end)
    early = contacts[contacts.toi_lower < np.median(contacts.toi_lower)]
    header, _ = scene_in(early.view(tmp_path / "early.html").path)
    counts = header["steps"][0]["contacts"]
    assert sum(counts[kind] for kind in ("vf", "ee", "ve", "vv")) == len(early) < len(contacts)
    header, _ = scene_in(contacts[contacts.toi_lower > 0.9].view(tmp_path / "late.html").path)
    assert header["steps"][0]["toi_lower"] == contacts.toi_lower.min(), "what is not shown is no less a contact"


def test_a_notebook_shows_the_page_itself(
    falling: tamis.Scene, opened: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    shell = types.SimpleNamespace(kernel=object())
    monkeypatch.setitem(sys.modules, "IPython", types.SimpleNamespace(get_ipython=lambda: shell))
    page = tamis.Detector(falling.mesh).contacts(falling.start, falling.end).view()
    assert not opened
    frame = page._repr_html_()
    assert frame.startswith('<iframe srcdoc="&lt;!doctype html&gt;') and frame.count('"') == 4
    monkeypatch.setitem(sys.modules, "IPython", types.SimpleNamespace(get_ipython=lambda: None))
    tamis.Detector(falling.mesh).contacts(falling.start, falling.end).view()
    assert len(opened) == 1


@pytest.mark.parametrize(
    ("name", "begins"),
    [("s.glb", b"glTF"), ("s.vtp", b"<?xml"), ("s.VTU", b"<?xml"), ("s.csv", b"kind,"), ("s", b"kind,")],
)
def test_other_files(falling: tamis.Scene, tmp_path: pathlib.Path, name: str, begins: bytes) -> None:
    tamis.Detector(falling.mesh).contacts(falling.start, falling.end).save(tmp_path / name)
    assert (tmp_path / name).read_bytes().startswith(begins)


@pytest.mark.parametrize("name", ["c.json", "c.npz", "c.csv.gz"])
def test_nothing_is_written_under_the_name_of_another_format(
    falling: tamis.Scene, tmp_path: pathlib.Path, name: str
) -> None:
    """Would catch a table that is written as JSON or as an archive of NumPy's."""
    contacts = tamis.Detector(falling.mesh).contacts(falling.start, falling.end)
    with pytest.raises(tamis.FileError, match=r"let the name end in \.csv, \.html, \.glb, \.vtp or \.vtu"):
        contacts.save(tmp_path / name)
    assert not (tmp_path / name).exists()


def test_what_a_double_cannot_span_is_no_page(falling: tamis.Scene, tmp_path: pathlib.Path) -> None:
    """Would catch a page that cannot be shown."""
    far = 1.7e308 * (falling.start / np.abs(falling.start).max())
    far[0, 0], far[1, 0] = 1.7e308, -1.7e308
    with pytest.raises(tamis.FileError, match="too large for a page"):
        tamis.Detector(falling.mesh).contacts(far, far).save(tmp_path / "page.html")


def test_options_of_the_question_hold_for_the_page(falling: tamis.Scene, opened: list[str]) -> None:
    """Would catch a page made without the filter, the separation or the groups of the question."""
    asked = []

    def accepts(kind: tamis.PairKind, vertices: tuple[int, int, int, int]) -> bool:
        asked.append(vertices)
        return kind == tamis.PairKind.VERTEX_FACE

    detector = tamis.Detector(falling.mesh, filter=accepts, groups=falling.groups, radii=[0.1, 0.2])
    contacts = detector.contacts(falling.start, falling.end)
    asked.clear()
    header, _ = scene_in(contacts.view().path)
    assert asked and header["steps"][0]["contacts"]["vf"] == len(contacts)
    wide = detector.contacts(falling.start, falling.end, min_separation=0.25)
    assert scene_in(wide.view().path)[0]["min_separation"] == 0.25


@pytest.mark.parametrize("vertex", [3, -1])  # the last one is in no contact
def test_positions_that_have_changed_are_refused(falling: tamis.Scene, tmp_path: pathlib.Path, vertex: int) -> None:
    contacts = tamis.Detector(falling.mesh).contacts(falling.start, falling.end)
    falling.start[vertex, 2] += 0.5
    with pytest.raises(tamis.InvalidStep, match="changed since"):
        contacts.view(tmp_path / "late.html")
    assert not (tmp_path / "late.html").exists()
    contacts.save(tmp_path / "late.csv")


def test_a_path_is_a_film_of_its_pieces(opened: list[str], tmp_path: pathlib.Path) -> None:
    """Return the path of a rod that makes a full turn and meets two posts, at 0.25 and at 0.7 of it."""
    angle = 2 * np.pi * 0.7
    posts: list[list[float]] = [
        [x, y, z] for x, y in ((0, 1.5), (1.5 * np.cos(angle), 1.5 * np.sin(angle))) for z in (-1, 1)
    ]
    turn = tamis.turned_chain(np.zeros((2, 3)), [0, 0, 2 * np.pi], [0, 0, 0])
    path = tamis.RigidPath([[1.0, 0, 0], [2.0, 0, 0], *posts], [0, 0, 1, 1, 1, 1], [turn, np.empty((0, 4, 3))])
    contacts = tamis.Detector(tamis.Mesh([], edges=[[0, 1], [2, 3], [4, 5]])).contacts(path)
    assert len(contacts) == 2
    header, _ = scene_in(contacts.view(tmp_path / "film.html").path)
    assert len(opened) == 1
    pieces = len(header["steps"])
    assert 16 <= pieces <= 64 and header["names"][:2] == ["t = 0", f"t = {1 / pieces:g}"]
    met = {i: step for i, step in enumerate(header["steps"]) if step["contacts"]["ee"]}
    for i, time in zip(met, (0.25, 0.7)):
        assert (i + met[i]["toi_upper"]) / pieces == pytest.approx(time, abs=1e-6)
    assert len(met) == 2
    free = [step["toi_lower"] for step in header["steps"]]
    first = min(met)
    assert free[:first] == [None] * first and free[first + 1 :] == [0] * (pieces - first - 1), "it may touch still"
    header, _ = scene_in(contacts[1:].view(tmp_path / "part.html").path)
    assert sum(step["contacts"]["ee"] for step in header["steps"]) == 1
    assert [step["toi_lower"] for step in header["steps"]] == free


def test_straight_paths_are_one_piece_and_other_files_are_refused(
    falling: tamis.Scene, opened: list[str], tmp_path: pathlib.Path
) -> None:
    detector = tamis.Detector(falling.mesh)
    contacts = detector.contacts(tamis.BezierPath([falling.start, falling.end]))
    header, _ = scene_in(contacts.view(tmp_path / "straight.html").path)
    assert header["names"] == ["t = 0", "t = 1"] and header["steps"][0]["contacts"]["vf"] == 1
    with pytest.raises(tamis.Error, match="save html or csv"):
        contacts.save(tmp_path / "straight.glb")
    contacts.save(tmp_path / "straight.csv")

    moved = [falling.start, falling.end]
    path = tamis.FunctionPath(6, lambda t, v: ((1 - t) * moved[0][v] + t * moved[1][v], 1e-15), lambda s, t, v: 1e-15)
    contacts = detector.contacts(path)
    assert len(contacts) == 1
    assert scene_in(contacts.view(tmp_path / "function.html").path)[0]["steps"][0]["contacts"]["vf"] == 1
    moved[1] = falling.start
    with pytest.raises(tamis.InvalidPath, match="changed since"):
        contacts.view(tmp_path / "late.html")
    assert not (tmp_path / "late.html").exists()


def test_what_knows_no_step_says_so(falling: tamis.Scene, tmp_path: pathlib.Path) -> None:
    detector = tamis.Detector(falling.mesh)
    contacts = detector.contacts(falling.start, falling.end)
    with pytest.raises(tamis.Error, match="have no step"):
        pickle.loads(pickle.dumps(contacts)).view(tmp_path / "lost.html")
    for name, said in (("page.txt", "end in .html"), ("picture.png", "end in .html")):
        with pytest.raises(tamis.Error, match=said):
            contacts.view(tmp_path / name)
    with pytest.raises(tamis.Error, match="saved from the page"):
        contacts.save(tmp_path / "picture.png")
    with pytest.raises(tamis.FileError):
        contacts.view(tmp_path / "absent" / "page.html")
    assert not list(tmp_path.iterdir())


def test_contacts_and_their_question_are_collected(falling: tamis.Scene) -> None:
    """Would catch a cycle of a detector and its filter that Python's garbage collector does not see."""

    class Filter:
        detector: tamis.Detector
        contacts: tamis.Contacts

        def __call__(self, kind: tamis.PairKind, vertices: tuple[int, int, int, int]) -> bool:
            return True

    accepts = Filter()
    accepts.detector = tamis.Detector(falling.mesh, filter=accepts)
    accepts.contacts = accepts.detector.contacts(falling.start, falling.end)
    gone = weakref.ref(accepts)
    del accepts
    gc.collect()
    assert gone() is None
