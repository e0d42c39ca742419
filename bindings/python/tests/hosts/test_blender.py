"""The add-on inside Blender: in the module `bpy` from PyPI, and in the program if it is installed (Debian's)."""

from __future__ import annotations

import importlib.util
import json
import os
import pathlib
import shutil
import subprocess
import sys
import zipfile
from typing import Any

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[4]
SESSIONS = ROOT / "integrations" / "blender" / "sessions"
# The wheels that the tests are run with: scripts/nightly.sh says which.
WHEEL, BACKEND = os.environ.get("TAMIS_WHEEL", ""), os.environ.get("TAMIS_BACKEND", "")

BLENDERS = {
    "bpy": [sys.executable] if importlib.util.find_spec("bpy") else [],
    "blender": ["blender", "-b", "--factory-startup", "--python-exit-code", "1", "--python"],
}

pytestmark = pytest.mark.skipif(not WHEEL, reason="no wheel to put into the add-on: TAMIS_WHEEL")


@pytest.fixture(scope="module")
def zip_file(tmp_path_factory: pytest.TempPathFactory) -> pathlib.Path:
    folder = tmp_path_factory.mktemp("zip")
    script = ROOT / "integrations" / "blender" / "build_zip.py"
    printed = subprocess.run(
        [sys.executable, script, WHEEL, BACKEND, folder], check=True, capture_output=True, text=True
    )
    return pathlib.Path(printed.stdout.strip())


def test_the_zip_holds_what_it_takes(zip_file: pathlib.Path) -> None:
    names = zipfile.ZipFile(zip_file).namelist()
    for wanted in ("__init__.py", "LICENSE", "blender_manifest.toml", "wheel/tamis/__init__.py"):
        assert f"tamis_check/{wanted}" in names
    assert any("dist-info/licenses/LICENSE" in name for name in names)
    assert all(name.startswith("tamis_check/") for name in names)


def test_the_module_knows_nothing_of_blender() -> None:
    found = [p for p in (ROOT / "bindings" / "python" / "tamis").rglob("*.py") if "bpy" in p.read_text()]
    assert not found


@pytest.fixture(scope="module", params=BLENDERS)
def seen(request: pytest.FixtureRequest, zip_file: pathlib.Path, tmp_path_factory: pytest.TempPathFactory) -> Any:
    return seen_in(request.param, "caches.py", zip_file, tmp_path_factory.mktemp(request.param))


@pytest.fixture(scope="module", params=BLENDERS)
def changes(request: pytest.FixtureRequest, zip_file: pathlib.Path, tmp_path_factory: pytest.TempPathFactory) -> Any:
    return seen_in(request.param, "changes.py", zip_file, tmp_path_factory.mktemp(request.param))


def seen_in(blender: str, session: str, zip_file: pathlib.Path, folder: pathlib.Path) -> Any:
    command = BLENDERS[blender]
    if not command or not shutil.which(command[0]):
        pytest.skip(f"{blender} is not installed: bindings/python/requirements-hosts.txt, or apt-get install blender")
    (folder / "scripts" / "addons").mkdir(parents=True)
    answer = folder / "answer.json"
    # Without the network, and without the user's packages and add-ons.
    environment = {**os.environ, "BLENDER_USER_SCRIPTS": str(folder / "scripts"), "BLENDER_USER_CONFIG": str(folder)}
    done = subprocess.run(
        [*command, SESSIONS / session, "--", zip_file, answer],
        capture_output=True,
        text=True,
        env=environment,
        timeout=300,
    )
    assert answer.exists(), done.stdout[-2000:] + done.stderr[-3000:]
    return json.loads(answer.read_text())


def test_bad_frames_are_on_the_timeline_and_in_the_list(seen: Any) -> None:
    both = seen["both"]
    assert seen["check"] == ["FINISHED"] and both["frame"] == 2
    assert both["summary"] == "2 of 12 frames are bad, the first is 6"
    assert [row[0] for row in both["rows"]] == [6, 7]
    assert "intersections" in both["rows"][0][1] and both["rows"][1][1].endswith("contacts: ground and sheet")
    assert [frame for frame, name in both["markers"]] == [3, 6, 7] and both["markers"][0][1] == "mine"


def test_a_row_shows_its_frame_and_selects_faces(seen: Any) -> None:
    assert seen["shown"]["frame"] == 7 and seen["shown"]["ground"] == [0]
    assert 0 < len(seen["shown"]["sheet"]) < 9
    intersections, contacts, points = seen["drawn"]
    assert intersections > 0 and contacts > 0 and points > 0


def test_one_mesh_alone_is_free(seen: Any) -> None:
    assert seen["alone"]["summary"] == "12 frames and 11 steps, all free: proven"
    assert seen["alone"]["rows"] == [] and len(seen["alone"]["markers"]) == 1


def test_a_curve_with_a_thickness_is_in_the_way(seen: Any) -> None:
    """Bug: objects other than meshes were left out silently, and the sheet was proven free."""
    assert seen["wire"]["summary"].startswith("2 of 12 frames are bad, the first is 6")
    assert seen["wire"]["rows"][0][1].endswith("sheet and wire")
    assert seen["wire shown"] == ["FINISHED"]


def test_the_summary_names_what_was_not_looked_at(seen: Any) -> None:
    free = "12 frames and 11 steps, all free: proven"
    assert seen["unread"]["summary"] == f"{free}; not looked at: whole, instances of many"


def test_nothing_selected_is_a_sentence(seen: Any) -> None:
    assert "no mesh is selected: select the cloth" in seen["nothing"]


def test_a_separation_makes_more_frames_bad(seen: Any) -> None:
    assert len(seen["separated"]["rows"]) > len(seen["both"]["rows"])


def test_an_alembic_file_is_asked_as_any_scene(seen: Any) -> None:
    assert seen["alembic"]["summary"] == seen["both"]["summary"]
    assert [row[0] for row in seen["alembic"]["rows"]] == [6, 7]


def test_other_faces_from_a_frame_on_are_said(seen: Any) -> None:
    assert any("the meshes have other faces from here on" in note for note in seen["notes"])


def test_clear_leaves_the_users_markers(seen: Any) -> None:
    assert seen["cleared"]["markers"] == [[3, "mine"]] and seen["cleared"]["summary"] == "" and seen["gone"]


def test_a_hidden_object_is_said_to_be_so(changes: Any) -> None:
    """The bug: it was asked about where it stood when it was hidden, and proven free there."""
    hidden = changes["hidden"]
    assert hidden["summary"] == "12 frames and 10 steps, all free: proven; not looked at: sheet where it is hidden"
    assert hidden["notes"] == ["frame 5: the meshes have other faces from here on; no step leads there"]


@pytest.mark.parametrize(
    ("scene", "left_out"),
    [("instances", "instances of maker"), ("curve", "curve of maker"), ("born", "instances of emitter")],
)
def test_what_appears_besides_meshes_is_named(changes: Any, scene: str, left_out: str) -> None:
    """The bug: what geometry nodes make, and what is not there in the first frame, was left out without a word."""
    assert changes[scene]["summary"] == f"12 frames and 11 steps, all free: proven; not looked at: {left_out}"


def test_an_object_that_is_removed_ends_the_check(changes: Any) -> None:
    """The bug: a traceback, nothing of what was found until then, and another frame than before."""
    assert "ground was removed or renamed while it was checked" in changes["removed"]["said"]
    assert changes["removed"]["summary"] == "4 frames and 3 steps, all free: proven"
    assert changes["removed"]["frame"] == 2


def test_undoing_something_does_not_end_a_check(changes: Any) -> None:
    assert changes["undone in a frame"] == "2 of 12 frames are bad, the first is 6"


def test_meshes_may_be_without_faces_at_first(changes: Any) -> None:
    """The bug: the check ended there, and said that 0 frames were proven free."""
    assert [row[0] for row in changes["built"]["rows"]] == [6, 7]
    assert "no faces and no edges in any frame" in changes["without faces"]["said"]
    assert changes["without faces"]["summary"] == "no frame was checked"


def test_another_file_shows_nothing_of_this_one(changes: Any) -> None:
    assert not changes["another file"]


def test_undoing_what_follows_leaves_what_was_found(changes: Any) -> None:
    assert [frame for frame, _ in changes["undone afterwards"]["markers"]] == [6, 7]


def test_faces_of_all_objects_of_a_mesh_are_selected_and_no_others(changes: Any) -> None:
    """The bugs: the last of them alone had its faces selected, and what has no pair kept those of another row."""
    assert changes["one mesh"]["left"] == [0, 1] and changes["one mesh"]["apart"] == []


def test_objects_of_one_name_are_told_apart(changes: Any) -> None:
    assert changes["one name"]["rows"][0][1].endswith("contacts: other and other [answer.blend]")
