"""Pages that show contacts, and how they are opened."""

from __future__ import annotations

import html
import os
import pathlib
import sys
import tempfile
import webbrowser
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._checks import file_name
from tamis._errors import Error, InvalidStep

if TYPE_CHECKING:
    from tamis._motion import AskedMotion, Own


@dataclass(frozen=True)
class Asked:
    """The question that some contacts answer: files to look at show its mesh and motion, too."""

    mesh: _core.Mesh
    options: _core.Options
    motion: AskedMotion
    own: Own
    _bits: tuple[int, ...] = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "_bits", self.motion.bits())

    def write(self, path: str, contacts: npt.NDArray[np.uint8]) -> None:
        """Write a file to look at with these contacts, all of the answer or some; the extension names the format."""
        if self.motion.bits() != self._bits:
            raise InvalidStep(
                "the positions have changed since these contacts were found: look at contacts before the next step, or "
                "give the detector arrays that stay as they are"
            )
        _core.Detector(self.mesh, self.options).write(path, contacts, self.own, *self.motion.native())


class Page:
    """A page that shows contacts: one HTML file that works without a server. Notebooks show it below the cell."""

    __slots__ = {"path": "The file, a `pathlib.Path`."}

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = pathlib.Path(file_name(path, "path"))

    def _repr_html_(self) -> str:
        text = html.escape(self.path.read_text(encoding="utf-8"), quote=True)
        return f'<iframe srcdoc="{text}" style="width: 100%; height: 720px; border: 0"></iframe>'

    def __fspath__(self) -> str:
        return str(self.path)

    def __repr__(self) -> str:
        return f"Page({str(self.path)!r})"


def place_for_page(path: str | os.PathLike[str] | None) -> pathlib.Path:
    """Return the absolute path of a page; by default in a new folder among the temporary files."""
    if path is None:
        return pathlib.Path(tempfile.mkdtemp(prefix="tamis-")) / "contacts.html"
    place = pathlib.Path(file_name(path, "path")).resolve()
    if place.suffix.lower() != ".html":
        raise Error(f"{place} is not a name for a page: let it end in .html, or use save() for other formats")
    return place


def show(path: pathlib.Path) -> Page:
    """Open a page in the browser, unless this runs in a notebook, which shows the page that is returned."""
    shell = sys.modules["IPython"].get_ipython() if "IPython" in sys.modules else None
    if not hasattr(shell, "kernel"):
        webbrowser.open(path.as_uri())
    return Page(path)
