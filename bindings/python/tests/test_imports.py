"""The modules of the package are layers: they do not import each other in a circle, not even for types."""

from __future__ import annotations

import ast
import pathlib
from graphlib import TopologicalSorter

import pytest

import tamis

PACKAGE = pathlib.Path(tamis.__file__).parent


def _imports(path: pathlib.Path) -> set[str]:
    """Return every module of tamis that a file imports, anywhere in it."""
    found: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.ImportFrom) and node.module and node.module.partition(".")[0] == "tamis":
            found |= {node.module, *(f"{node.module}.{alias.name}" for alias in node.names)}
        elif isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
    return found


def test_no_circle() -> None:
    """Bug: the modules of kinds, answers and pages imported each other."""
    files = {
        ".".join(["tamis", *path.relative_to(PACKAGE).with_suffix("").parts]).removesuffix(".__init__"): path
        for path in PACKAGE.rglob("*.py")
        if "examples" not in path.parts
    }
    graph = {name: _imports(path) & files.keys() - {"tamis"} for name, path in files.items()}
    order = [*TopologicalSorter(graph).static_order()]
    assert len(order) == len(files) > 20 and order.index("tamis._kinds") < order.index("tamis._detector._detector")


@pytest.mark.parametrize("name", ["between", "interpolated", "turned"])
def test_an_old_name_is_refused_with_the_new_one(name: str) -> None:
    """Bug: code of before the first release failed with a sentence that did not help."""
    with pytest.raises(AttributeError, match=r"use '(.*)', its name since") as refused:
        getattr(tamis, name)
    assert f"{name!r}: use" in str(refused.value)
    assert callable(getattr(tamis, str(refused.value).split("'")[-2]))
    with pytest.raises(AttributeError, match=r"'nothing'$"):
        _ = tamis.nothing  # type: ignore[attr-defined]


@pytest.mark.parametrize("answer", [tamis.SafeStep(0.25, 0.5, None), tamis.BodyStep(0.25, 0.5, None)])
def test_an_old_attribute_is_refused_with_the_new_one(answer: tamis.SafeStep) -> None:
    with pytest.raises(AttributeError, match="no attribute 'lower': use 'toi_lower'"):
        _ = answer.lower  # type: ignore[attr-defined]
    with pytest.raises(AttributeError, match="no attribute 'upper': use 'toi_upper'"):
        _ = answer.upper  # type: ignore[attr-defined]
