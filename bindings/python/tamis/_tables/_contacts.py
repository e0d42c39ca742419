"""Contacts, as arrays."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._checks import file_name, instance
from tamis._errors import Error
from tamis._kinds import PairKind
from tamis._pages import Asked, Page, place_for_page, show
from tamis._tables._columns import MovingPairs, TimedPairs
from tamis._tables._table import Row


class Contact(NamedTuple):
    """One pair of features that touches during the step.

    Attributes
    ----------
    kind : PairKind
        The kind of the pair: vertex-face or edge-edge; with loose edges and points also vertex-edge or vertex-vertex.
    vertices : tuple of four int
        Vertex-face: the vertex, then the face's vertices in the mesh's order. Edge-edge: the vertices of each edge
        ascending, the smaller edge first. Vertex-edge: the vertex, then the edge's vertices, ascending. Vertex-vertex:
        ascending. Entries that a kind does not use are -1.
    toi_lower, toi_upper : float
        Fractions of the step, in [0, 1]. The pair is apart on [0, toi_lower); a certified contact touches at some time
        of [toi_lower, toi_upper].
    u, v : float
        Contact weights. Vertex-face: point = (1-u-v) f0 + u f1 + v f2. Edge-edge: u on the first edge, v on the second,
        each in [0, 1]. Vertex-edge: u on the edge, v is 0. Vertex-vertex: both are 0.
    normal : tuple of three float
        Unit vector. To part the features, move the first one (the vertex; the first edge) along it, or the second one
        against it. With a separation or radii, and for vertex-edge and vertex-vertex: from the second feature's closest
        point to the first's at `toi_lower`. Else the normal of the face, or the cross product of both edges, on the
        side where the first feature is just before they touch; where there is no such normal, the direction between the
        closest points.
    certified : bool
        True: proven to touch. False, only on a path: arithmetic could not decide; such a pair is kept, because a
        contact must never be missed.
    """

    kind: PairKind
    vertices: tuple[int, int, int, int]
    toi_lower: float
    toi_upper: float
    u: float
    v: float
    normal: tuple[float, float, float]
    certified: bool


class TouchingPairs(TimedPairs[Row]):
    """Contacts during a step: a base of `Contacts` and `BodyContacts`."""

    __slots__ = ()

    def _fields(self, values: Sequence[Any]) -> tuple[Any, ...]:
        kind, certainty, vertices, *times, normal = values
        return PairKind(kind), tuple(vertices.tolist()), *times, tuple(normal.tolist()), certainty == 0

    def __repr__(self) -> str:
        name = type(self).__name__
        if not len(self):
            return f"{name}(none)"
        counts = zip(PairKind, np.bincount(self.kind, minlength=len(PairKind)))
        kinds = ", ".join(f"{n} {kind.long_name}" for kind, n in counts if n)
        return f"{name}({kinds}; first at {self.toi_lower.min():g})"


class Contacts(MovingPairs[Contact], TouchingPairs[Contact]):
    """Contacts of a step or path, sorted by kind, then vertices.

    They own their memory: later questions do not change them.

    `len()` counts the contacts; an integer index gives a `Contact`, any other index of an array gives `Contacts`. The
    columns of `table` are kind, certainty (0: certified, 1: unresolved), vertices, toi_lower, toi_upper, u, v, normal.
    """

    __slots__ = ("_asked",)
    _dtype = np.dtype(_core.contact_layout())
    _record = Contact

    def __init__(self, table: npt.NDArray[np.void] | npt.NDArray[np.uint8], asked: Asked | None = None) -> None:
        super().__init__(table)
        if asked is not None:
            instance(asked, Asked, "asked", "none: only what a question returns knows what was asked")
        self._asked = asked

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the contacts to a file, as the command's `--out` does. If that fails, no file is left.

        Parameters
        ----------
        path : path_like
            The extension decides. ``.html``, ``.glb``, ``.vtp``, ``.vtu``: files to look at, with the mesh in motion or
            the contacts as points. They need the positions of the step (see `view`); for a path there is only
            ``.html``. ``.csv``, or no extension: a table with the columns kind, v0, v1, v2, v3, toi_lower, toi_upper,
            u, v, status, nx, ny, nz, whose numbers read back to the same doubles.

        Raises
        ------
        FileError
            The file cannot be written, or its name has another extension.
        InvalidStep, InvalidPath
            As in `view`.
        Error
            As in `view`; or a picture, ``.png``, is requested, which only the page saves.
        """
        name, rows = file_name(path, "path"), np.ascontiguousarray(self._table).view(np.uint8)
        if name.lower().endswith(".png"):
            raise Error(f"{name}: pictures are saved from the page: save html, open it and press K")
        if _core.is_file_to_look_at(name):
            self._question().write(name, rows)
        else:
            _core.write_contacts(name, rows)

    def view(self, path: str | os.PathLike[str] | None = None) -> Page:
        """Show the contacts and the motion of the mesh on the page that `tamis view` writes.

        A notebook shows the page below the cell; elsewhere it opens in the browser. The page needs the positions of the
        question: `Contacts` refer to them without a copy, `table` does not. A path is shown as a film of straight
        pieces, at most 64, enough of them to look like the curves. Each contact is in the piece where it happens, at a
        time of that piece.

        Parameters
        ----------
        path : path_like, optional
            The name of the page, which ends in ``.html``; by default in a new folder among the temporary files.

        Returns
        -------
        Page
            Its `path` is the file, which works alone.

        Raises
        ------
        FileError
            The file cannot be written.
        InvalidStep
            The positions were changed in place since the contacts were found, of whatever vertex.
        InvalidPath
            The same for a path.
        Error
            The contacts have no positions: they were pickled, or come from `tamis.distributed`. Or `path` has another
            ending.
        """
        place = place_for_page(path)
        self.save(place)
        return show(place)

    def _question(self) -> Asked:
        if self._asked is None:
            raise Error(
                "these contacts have no step, because they come from many ranks or were pickled: use the contacts "
                "that Detector.contacts(start, end) returned"
            )
        return self._asked

    def _part(self, table: npt.NDArray[np.void], index: Any) -> Contacts:
        return Contacts(table, self._asked)
