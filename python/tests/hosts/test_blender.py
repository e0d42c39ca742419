"""The add-on inside Blender: the module `bpy` from PyPI, and the program where it is installed (Debian's)."""

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

ROOT = pathlib.Path(__file__).resolve().parents[3]
SESSION = ROOT / "hosts" / "blender" / "session.py"
# The wheel that the tests are run with: scripts/nightly.sh says which.
WHEEL = os.environ.get("TAMIS_WHEEL", "")

BLENDERS = {
    "bpy": [sys.executable] if importlib.util.find_spec("bpy") else [],
    "blender": ["blender", "-b", "--factory-startup", "--python-exit-code", "1", "--python"],
}

pytestmark = pytest.mark.skipif(not WHEEL, reason="no wheel to put into the add-on: TAMIS_WHEEL")


@pytest.fixture(scope="module")
def zip_file(tmp_path_factory: pytest.TempPathFactory) -> pathlib.Path:
    folder = tmp_path_factory.mktemp("zip")
    script = ROOT / "hosts" / "blender" / "build_zip.py"
    printed = subprocess.run([sys.executable, script, WHEEL, folder], check=True, capture_output=True, text=True)
    return pathlib.Path(printed.stdout.strip())


def test_the_zip_holds_what_it_takes(zip_file: pathlib.Path) -> None:
    names = zipfile.ZipFile(zip_file).namelist()
    for wanted in ("__init__.py", "LICENSE", "blender_manifest.toml", "wheel/tamis/__init__.py"):
        assert f"tamis_check/{wanted}" in names
    assert any("dist-info/licenses/LICENSE" in name for name in names)
    assert all(name.startswith("tamis_check/") for name in names)


def test_the_module_knows_nothing_of_blender() -> None:
    found = [p for p in (ROOT / "python" / "tamis").rglob("*.py") if "bpy" in p.read_text()]
    assert not found


@pytest.fixture(scope="module", params=BLENDERS)
def seen(request: pytest.FixtureRequest, zip_file: pathlib.Path, tmp_path_factory: pytest.TempPathFactory) -> Any:
    command = BLENDERS[request.param]
    if not command or not shutil.which(command[0]):
        pytest.skip(f"{request.param} is not installed: python/requirements-hosts.txt, or apt-get install blender")
    folder = tmp_path_factory.mktemp(request.param)
    (folder / "scripts" / "addons").mkdir(parents=True)
    answer = folder / "answer.json"
    # No network, and nothing of the user's: neither packages nor add-ons.
    environment = {**os.environ, "BLENDER_USER_SCRIPTS": str(folder / "scripts"), "BLENDER_USER_CONFIG": str(folder)}
    done = subprocess.run(
        [*command, SESSION, "--", zip_file, answer], capture_output=True, text=True, env=environment, timeout=300
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
    """The bug: all that is no mesh object was left out without a word, and the sheet was proven free."""
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
