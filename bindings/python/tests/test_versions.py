"""tamis.mujoco and tamis.newton refuse hosts that work in another way than the tested ones, when they are imported."""

from __future__ import annotations

import importlib
import pathlib
import re
import sys
from collections.abc import Callable
from importlib import metadata

import pytest

import tamis
from tamis._versions import check_range, check_sources, fingerprints

ROOT = pathlib.Path(__file__).resolve().parents[3]


def _forget(monkeypatch: pytest.MonkeyPatch, module: str) -> None:
    for name in [name for name in sys.modules if name == module or name.startswith(f"{module}.")]:
        monkeypatch.delitem(sys.modules, name)


@pytest.mark.parametrize(
    ("module", "sentence"),
    [
        ("tamis.mujoco", "mujoco 2.0.0 is installed, and tamis.mujoco was tested with .*: pip install mujoco=="),
        (
            "tamis.newton",
            "newton 2.0.0 is installed, whose SolverVBD.step is missing, unlike in .*: pip install newton==",
        ),
    ],
)
def test_other_versions_cannot_be_imported(monkeypatch: pytest.MonkeyPatch, module: str, sentence: str) -> None:
    """Bug: Newton's was refused by `attach` only, and not as ImportError, when the scene had been built."""
    _forget(monkeypatch, module)
    monkeypatch.setattr(metadata, "version", lambda package: "2.0.0")
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    with pytest.raises(ImportError, match=sentence):
        importlib.import_module(module)


@pytest.mark.parametrize(
    ("version", "works"),
    [
        ("3.16.9", False),
        ("3.17.0", True),
        ("3.17.4", True),
        ("4.0.0", True),
        ("4.0.12", True),
        ("4.1.0", False),
        ("x", False),
    ],
)
def test_a_range_has_the_patch_releases_of_its_ends(monkeypatch: pytest.MonkeyPatch, version: str, works: bool) -> None:
    """Bug: exactly one version was accepted, and its patch releases were refused."""
    monkeypatch.setattr(metadata, "version", lambda package: version)
    if works:
        check_range("host", "3.17.0", "4.0.0", "tamis.host")
    else:
        with pytest.raises(
            ImportError, match=f"host {version} is installed, and tamis.host was tested with 3.17.0 to 4.0.0"
        ):
            check_range("host", "3.17.0", "4.0.0", "tamis.host")


INSIDE = "class Solver:\n    def move(self):\n        # Moves.\n        return 1\n"


@pytest.mark.parametrize(
    ("source", "state"),
    [
        (INSIDE, ""),
        (INSIDE.replace("# Moves.", "# Moves it.") + "\n\ndef other():\n    pass\n", ""),
        (INSIDE.replace("return 1", "return 2"), "whose Solver.move differs from 1.0"),
        (INSIDE.replace("self", "self, far"), "whose Solver.move differs from 1.0"),
        (INSIDE.replace("move", "turn"), "whose Solver.move is missing, unlike in 1.0"),
        (None, "whose Solver.move is missing, unlike in 1.0"),
    ],
)
def test_a_host_is_known_by_its_functions(
    monkeypatch: pytest.MonkeyPatch, tmp_path: pathlib.Path, source: str | None, state: str
) -> None:
    """Bug: a patch release with the same functions was refused; would catch one with others that is taken."""
    known = {"solver.py": {"Solver.move": fingerprints(INSIDE)["Solver.move"]}}
    (tmp_path / "host").mkdir()
    (tmp_path / "host/__init__.py").touch()
    if source is not None:
        (tmp_path / "host/solver.py").write_text(source)
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(metadata, "version", lambda package: "1.0.7")
    if not state:
        check_sources("host", "1.0", known, "tamis.host")
    else:
        with pytest.raises(ImportError, match=f"host 1.0.7 is installed, {state}, and .*: pip install host==1.0$"):
            check_sources("host", "1.0", known, "tamis.host")


@pytest.mark.parametrize("module", ["tamis.mujoco", "tamis.newton"])
def test_missing_programs_are_named(monkeypatch: pytest.MonkeyPatch, module: str) -> None:
    def missing(package: str) -> str:
        raise metadata.PackageNotFoundError(package)

    _forget(monkeypatch, module)
    monkeypatch.setattr(metadata, "version", missing)
    with pytest.raises(ImportError, match="is not installed: pip install"):
        importlib.import_module(module)


def test_versions_are_those_that_are_pinned() -> None:
    """Would catch other versions than those that pip installs."""
    pins = (ROOT / "bindings/python/requirements-hosts.txt").read_text()
    extras = (ROOT / "pyproject.toml").read_text()
    texts = {
        name: (ROOT / f"bindings/python/tamis/{name}").read_text()
        for name in ("mujoco/__init__.py", "newton/_inside.py")
    }
    first, last = re.findall(r'"(\d+\.\d+)\.\d+"', texts["mujoco/__init__.py"])
    tested = re.search(r'^TESTED = "(.*)"', texts["newton/_inside.py"], re.MULTILINE)[1]  # type: ignore[index]
    assert re.search(rf"\nmujoco=={re.escape(last)}\.\d+\n", pins) and f"\nnewton=={tested}\n" in pins
    major, minor = last.split(".")
    assert f'"mujoco>={first},<{major}.{int(minor) + 1}"' in extras and f'"newton>={tested},<' in extras


@pytest.mark.parametrize(
    ("module", "use", "package"),
    [
        ("pxr", lambda: tamis.read_usd("scene.usda"), "usd-core"),
        ("pygltflib", lambda: tamis.read_gltf("scene.glb"), "pygltflib"),
        ("ipctk", lambda: importlib.import_module("tamis.bridge.ipctk"), "ipctk"),
    ],
)
def test_a_missing_package_is_named_with_an_advice(
    monkeypatch: pytest.MonkeyPatch, module: str, use: Callable[[], object], package: str
) -> None:
    """Bug: "No module named 'pxr'", which is the name of no package."""
    _forget(monkeypatch, "tamis.bridge.ipctk")
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(ModuleNotFoundError, match=f"needs {package}. {package} is not installed: pip install"):
        use()
