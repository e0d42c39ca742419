"""The versions of other programs that tamis.mujoco and tamis.newton support: others are refused at import."""

from __future__ import annotations

from importlib import metadata

SUPPORTED = {"mujoco": "4.0.0", "newton": "1.8.0", "warp-lang": "1.19.0"}


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
