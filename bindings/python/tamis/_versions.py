"""Other packages that parts of tamis need: a missing package, or another version, is refused with an advice."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from importlib import metadata

SUPPORTED = {"mujoco": "4.0.0", "newton": "1.8.0", "warp-lang": "1.19.0"}


_MISSING = "{package} is not installed: pip install {package}"


@contextlib.contextmanager
def needed(package: str, what: str) -> Iterator[None]:
    """Within this context, imports of a package's modules say what to install if it is missing."""
    try:
        yield
    except ModuleNotFoundError as error:
        advice = _MISSING.format(package=package)
        raise ModuleNotFoundError(f"{what} needs {package}. {advice}", name=error.name) from None


def complaint(packages: list[str], what: str) -> str:
    """Return why a package cannot be used, empty if all can; `what` says what holds for the supported version alone."""
    for package in packages:
        supported = SUPPORTED[package]
        advice = f"pip install {package}=={supported}"
        try:
            found = metadata.version(package)
        except metadata.PackageNotFoundError:
            return f"{package} is not installed: {advice}"
        if found != supported:
            return f"{package} {found} is installed, and {what} {supported} alone: {advice}"
    return ""
