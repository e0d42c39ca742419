"""The supported versions of Newton and Warp: the functions that are replaced are private, and change with versions."""

from __future__ import annotations

from importlib import metadata

from tamis._errors import Error

KNOWN = {"newton": "1.8.0", "warp-lang": "1.19.0"}


def check_versions() -> None:
    """Raise if a package is not installed or has another version."""
    for package, known in KNOWN.items():
        try:
            found = metadata.version(package)
        except metadata.PackageNotFoundError:
            raise Error(f"{package} is not installed: pip install {package}=={known}") from None
        if found != known:
            raise Error(
                f"{package} is {found}, and tamis.newton knows the inside of {known} alone: "
                f"pip install {package}=={known}, or ask a newer Tamis"
            )
