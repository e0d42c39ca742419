"""Which versions of the host are known: what is replaced there is private to it, and changes from one to the next."""

from __future__ import annotations

from importlib import metadata

from tamis._errors import Error

KNOWN = {"newton": "1.8.0", "warp-lang": "1.19.0"}


def check_versions() -> None:
    """Refuse packages that are not there, or of another version."""
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
