"""Other packages that parts of tamis need: if one is missing or works in another way, the import says what to do."""

from __future__ import annotations

import ast
import contextlib
import hashlib
import importlib.util
import pathlib
import re
from collections.abc import Iterator
from importlib import metadata

_MISSING = "{package} is not installed: pip install {package}"


@contextlib.contextmanager
def needed(package: str, what: str) -> Iterator[None]:
    """Within this context, imports of a package's modules say what to install if it is missing."""
    try:
        yield
    except ModuleNotFoundError as error:
        advice = _MISSING.format(package=package)
        raise ModuleNotFoundError(f"{what} needs {package}. {advice}", name=error.name) from None


def installed(package: str, tested: str) -> str:
    """Return the installed version of a package; raise ImportError if it is missing. `tested` is for the advice."""
    try:
        return metadata.version(package)
    except metadata.PackageNotFoundError:
        raise ImportError(f"{package} is not installed: pip install {package}=={tested}") from None


def check_range(package: str, first: str, last: str, what: str) -> None:
    """Raise ImportError unless the installed version is of a series a.b from `first` to `last`, two tested versions."""
    found = installed(package, last)
    if not _series(first) <= _series(found) <= _series(last):
        raise ImportError(
            f"{package} {found} is installed, and {what} was tested with {first} to {last}: "
            f"pip install {package}=={last}"
        )


def check_sources(package: str, tested: str, known: dict[str, dict[str, str]], what: str) -> None:
    """Raise ImportError if a package's functions differ from those that `what` knows.

    `known` has, for each file of the package, names and the fingerprints of their sources in the version `tested`.
    """
    version = installed(package, tested)
    spec = importlib.util.find_spec(package)  # imports nothing
    folder = pathlib.Path(spec.origin or "").parent if spec else pathlib.Path()
    for place, names in known.items():
        path = folder / place
        found = fingerprints(path.read_text(encoding="utf-8")) if path.is_file() else {}
        for name, fingerprint in names.items():
            if found.get(name) != fingerprint:
                state = "differs from" if name in found else "is missing, unlike in"
                raise ImportError(
                    f"{package} {version} is installed, whose {name} {state} {tested}, and {what} knows that one: "
                    f"pip install {package}=={tested}"
                )


def fingerprints(source: str) -> dict[str, str]:
    """Return a fingerprint of each class, function and method: of its lines, but for blank lines, comments and ends."""
    lines, found = source.splitlines(), {}

    def take(nodes: list[ast.stmt], prefix: str) -> None:
        for node in nodes:
            if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
                own = [line.rstrip() for line in lines[node.lineno - 1 : node.end_lineno]]
                text = "\n".join(line for line in own if line and not line.lstrip().startswith("#"))
                found[prefix + node.name] = hashlib.sha256(text.encode()).hexdigest()[:16]
                if isinstance(node, ast.ClassDef):
                    take(node.body, f"{prefix}{node.name}.")

    take(ast.parse(source).body, "")
    return found


def _series(version: str) -> tuple[int, int]:
    found = re.match(r"(\d+)\.(\d+)", version)
    return (int(found[1]), int(found[2])) if found else (0, 0)
