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
from tamis._looking import Asked, Page, place_for_page, show
from tamis._tables._columns import MovingPairs, TimedPairs
from tamis._tables._table import Row


class Contact(NamedTuple):
    """One pair of features that touches during the step.

    Attributes
    ----------
    kind : PairKind
        What touches: vertex-face or edge-edge, of loose edges and points also vertex-edge or vertex-vertex.
    vertices : tuple of four int
        Vertex-face: the vertex, then the face's vertices in the mesh's order. Edge-edge: each edge ascending, the
        smaller edge first. Vertex-edge: the vertex, then the edge's. Vertex-vertex: ascending. -1 where a kind has less
        than four.
    toi_lower, toi_upper : float
        Fractions of the step: the pair is apart on [0, toi_lower); if certified it touches at some time of [toi_lower,
        toi_upper].
    u, v : float
        Contact weights. Vertex-face: point = (1-u-v) f0 + u f1 + v f2. Edge-edge: u on the first edge, v on the second.
        Vertex-edge: u on the edge, v is 0. Vertex-vertex: both are 0.
    normal : tuple of three float
        Of unit length: the direction in which the first feature (the vertex; the first edge) must go, or the second be
        pushed back, so that they part. With a separation or radii along the closest points at `toi_lower`; else of
        the face, or of both edges, on the side where the first feature is just before they touch.
    certified : bool
        True: proven to touch. False, on a path alone: floating point could not decide, and a contact must never be
        missed.
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
    """Pairs of features that touch during a step: of one mesh, or of bodies."""

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
    """Contacts of a step, by kind, then vertices. They own their memory: later questions change nothing in them.

    `len()` counts them; an integer index gives a `Contact`, anything else that indexes an array gives `Contacts`.
    The columns of `table` are kind, certainty (0: certified, 1: unresolved), vertices, toi_lower, toi_upper, u, v,
    normal.
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
        """Write a file, as the command's `--out` does: complete or not at all.

        Parameters
        ----------
        path : path_like
            The extension decides. ``.html``, ``.glb``, ``.vtp``, ``.vtu``: files to look at, with the mesh in motion or
            the contacts as points; they need the step, see `view`, and of a path only ``.html`` can be made. ``.csv``,
            or no extension: a table with the columns kind, v0, v1, v2, v3, toi_lower, toi_upper, u, v, status,
            nx, ny, nz; numbers read back to the same doubles.

        Raises
        ------
        FileError
            The file cannot be written, or its name has another extension.
        Error
            As of `view`; and for a picture, ``.png``, which the command draws.
        """
        name, rows = file_name(path, "path"), np.ascontiguousarray(self._table).view(np.uint8)
        if name.lower().endswith(".png"):
            raise Error(f"{name}: pictures are drawn by the command, tamis contacts --out; save html or glb instead")
        if _core.is_file_to_look_at(name):
            self._question().write(name, rows)
        else:
            _core.write_contacts(name, rows)

    def view(self, path: str | os.PathLike[str] | None = None) -> Page:
        """Show the contacts and the motion of the mesh: the page that `tamis view` writes.

        A notebook shows it below the cell; elsewhere it opens in the browser. For this, contacts keep the positions
        that were asked about, without a copy; `table` alone does not. Contacts of a path are shown as a film of
        straight pieces, so many (64 at the most) that they look like the curves; each in the piece where it happens, at
        a time of that piece.

        Parameters
        ----------
        path : path_like, optional
            Of the page, ending in ``.html``; by default among the temporary files.

        Returns
        -------
        Page
            Its `path` is the file: send it along.

        Raises
        ------
        FileError
            The file cannot be written.
        InvalidStep
            The positions were changed in place since the contacts were found.
        InvalidPath
            The same of a path.
        Error
            Contacts that come out of `pickle` know no step.
        """
        place = place_for_page(path)
        self.save(place)
        return show(place)

    def _question(self) -> Asked:
        if self._asked is None:
            raise Error(
                "these contacts know no step, as they are of many ranks or were pickled: look at what "
                "Detector.contacts(start, end) has returned"
            )
        return self._asked

    def _part(self, table: npt.NDArray[np.void], index: Any) -> Contacts:
        return Contacts(table, self._asked)
