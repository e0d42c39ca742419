"""Every Python block of the documents runs, page by page from top to bottom, and prints what the page says."""

from __future__ import annotations

import contextlib
import io
import pathlib
import re

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]
PAGES = [
    "README.md",
    "docs/getting-started.md",
    "docs/python.md",
    "docs/python-tour.md",
    "docs/worlds.md",
    "docs/audit.md",
    "docs/coming-from-ipctk.md",
    "docs/hosts/ipctk.md",
]
BLOCK = re.compile(r"^```python\n(.*?)^```$(?:\s*^(?:prints\n\n)?```text\n(.*?)^```$)?", re.DOTALL | re.MULTILINE)


@pytest.mark.parametrize("page", PAGES)
def test_page(page: str) -> None:
    blocks = BLOCK.findall((ROOT / page).read_text())
    if any("import ipctk\n" in code for code, _ in blocks):
        pytest.importorskip("ipctk", reason="ipctk has no wheel for this Python", exc_type=ImportError)
    assert blocks
    names: dict[str, object] = {"__name__": "__page__"}
    compared = 0
    for code, output in blocks:
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(code, page, "exec"), names)
        if output:
            assert printed.getvalue() == output
            compared += 1
    assert compared
