"""The examples run as users run them, and draw a picture."""

from __future__ import annotations

import pathlib
import subprocess
import sys

import matplotlib.image
import pytest

EXAMPLES = pathlib.Path(__file__).resolve().parents[1] / "examples"
ARGUMENTS: dict[str, list[str]] = {
    "barrier_cloth": ["--steps", "4", "--cells", "12"],
    "contacts_by_time": [],
    "cloth": ["--frames", "4", "--vertices", "13"],
    "sequence": [],
}


def test_each_example_has_its_test() -> None:
    assert {path.stem for path in EXAMPLES.glob("*.py")} == set(ARGUMENTS)


@pytest.mark.parametrize("name", ARGUMENTS)
def test_example(name: str, tmp_path: pathlib.Path) -> None:
    if "import ipctk" in (EXAMPLES / f"{name}.py").read_text():
        pytest.importorskip("ipctk", reason="ipctk has no wheel for this Python", exc_type=ImportError)
    picture = tmp_path / "picture.png"
    command = [sys.executable, str(EXAMPLES / f"{name}.py"), *ARGUMENTS[name], "--out", str(picture)]
    printed = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    assert printed
    pixels = matplotlib.image.imread(picture)
    assert pixels.shape[0] > 300 and pixels.std() > 0.01
