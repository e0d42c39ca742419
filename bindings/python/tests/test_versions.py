"""tamis.mujoco and tamis.newton refuse other versions of the programs they work in, both when they are imported."""

from __future__ import annotations

import importlib
import pathlib
import sys
from collections.abc import Callable
from importlib import metadata

import pytest

import tamis
from tamis._versions import SUPPORTED

ROOT = pathlib.Path(__file__).resolve().parents[3]


def _forget(monkeypatch: pytest.MonkeyPatch, module: str) -> None:
    for name in [name for name in sys.modules if name == module or name.startswith(f"{module}.")]:
        monkeypatch.delitem(sys.modules, name)


@pytest.mark.parametrize(
    ("module", "sentence"),
    [
        ("tamis.mujoco", "mujoco 2.0.0 is installed, and tamis.mujoco proves the motion of 4.0.0 alone: pip install"),
        ("tamis.newton", "newton 2.0.0 is installed, and tamis.newton knows the inside of 1.8.0 alone: pip install"),
    ],
)
def test_other_versions_cannot_be_imported(monkeypatch: pytest.MonkeyPatch, module: str, sentence: str) -> None:
    """Bug: Newton's was refused by `attach` only, and not as ImportError, when the scene had been built."""
    _forget(monkeypatch, module)
    monkeypatch.setattr(metadata, "version", lambda package: "2.0.0")
    with pytest.raises(ImportError, match=sentence):
        importlib.import_module(module)


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
    for package, version in SUPPORTED.items():
        assert f"\n{package}=={version}\n" in pins
        assert f'"{package}=={version}"' in extras


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
