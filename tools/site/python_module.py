"""Imports the Python module with stand-ins for its compiled parts and for other packages: its docstrings need neither."""
from __future__ import annotations

import importlib
import pathlib
import sys
from types import ModuleType
from unittest.mock import MagicMock

PYTHON = pathlib.Path(__file__).resolve().parent.parent.parent / "bindings/python"


class Compiled(MagicMock):
    """Stands for `_core`: each layout of a table has no columns."""

    def __getattr__(self, name: str) -> object:
        return (lambda: []) if name.endswith("_layout") else super().__getattr__(name)


def public_module(name: str) -> ModuleType:
    """Return a public module: `tamis`, or one that is imported by itself."""
    if "tamis" not in sys.modules:
        sys.path.insert(0, str(PYTHON))
        sys.modules["tamis._core"] = Compiled()
        sys.modules["tamis._version"] = MagicMock()
        sys.modules["tamis._core"].__version__ = sys.modules["tamis._version"].VERSION = ""
        for other in ("ipctk", "mpi4py", "mujoco", "newton", "newton.solvers", "ompl", "warp", "tamis._distributed"):
            sys.modules[other] = MagicMock()
        sys.modules["ompl"].base.MotionValidator = object
        sys.modules["mpi4py"].MPI.Get_library_version.return_value = ""
        sys.modules["tamis._distributed"].library_version.return_value = ""
        versions = importlib.import_module("tamis._versions")
        versions.check_range = versions.check_sources = lambda *_: None
    return importlib.import_module(name)
