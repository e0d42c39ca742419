"""Contacts, as arrays."""

from __future__ import annotations

import enum
import os
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, NamedTuple, overload

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._columns import NamedPairs, TimedPairs
from tamis._errors import Error
from tamis._looking import Asked, Page, place_for_page, show

if TYPE_CHECKING:
    import pandas


class PairKind(enum.IntEnum):
    """Kinds of pairs of features; the last two are of points and edges that belong to no face."""

    VERTEX_FACE = 0
    EDGE_EDGE = 1
    VERTEX_EDGE = 2
    VERTEX_VERTEX = 3

    @property
    def short_name(self) -> str:
        """As in files and on the command line: vf, ee, ve, vv."""
        return _SHORT_NAMES[self]


_SHORT_NAMES = ("vf", "ee", "ve", "vv")


class Contact(NamedTuple):
    """One pair of features that touches during the step.

    Attributes
    ----------
    kind : PairKind
        Vertex-face or edge-edge.
    vertices : tuple of four int
        Vertex-face: the vertex, then the face's vertices in the mesh's order. Edge-edge: each edge ascending, the
        smaller edge first. Vertex-edge: the vertex, then the edge's. Vertex-vertex: ascending. -1 where a kind has less
        than four.
    toi_lower, toi_upper : float
        Fractions of the step: the pair is apart on [0, toi_lower); if certified it touches at some time of [toi_lower,
        toi_upper].
    u, v : float
        Contact weights. Vertex-face: point = (1-u-v) f0 + u f1 + v f2. Edge-edge: u on the first edge, v on the second.
    normal : tuple of three float
        Of unit length: of the face, or the cross product of the edges.
    certified : bool
        True: proven to touch. False: floating point could not decide, and a contact must never be missed.
    """

    kind: PairKind
    vertices: tuple[int, int, int, int]
    toi_lower: float
    toi_upper: float
    u: float
    v: float
    normal: tuple[float, float, float]
    certified: bool


class Contacts(NamedPairs, TimedPairs):
    """Contacts of a step, by kind, then vertices. They own their memory: later questions change nothing in them.

    `len()` counts them; an integer index gives a `Contact`, anything else that indexes an array gives `Contacts`.
    The columns of `table` are kind, certainty, vertices, toi_lower, toi_upper, u, v, normal.
    """

    __slots__ = ("_asked",)
    _dtype = np.dtype(_core.contact_layout())

    def __init__(self, table: npt.NDArray[np.void] | npt.NDArray[np.uint8], asked: Asked | None = None) -> None:
        super().__init__(table)
        self._asked = asked

    @property
    def certified(self) -> npt.NDArray[np.bool_]:
        """True where the contact is proven, False where it is unresolved, shape (n,)."""
        return np.equal(self._table["certainty"], 0)

    def to_pandas(self) -> pandas.DataFrame:
        """Make a DataFrame, one row a contact, with the columns of `save`. pandas must be installed."""
        import pandas as pd

        columns: dict[str, Any] = {"kind": np.asarray(_SHORT_NAMES)[self.kind]}
        columns.update({f"v{i}": self.vertices[:, i] for i in range(4)})
        columns.update({name: self._table[name] for name in ("toi_lower", "toi_upper", "u", "v")})
        columns["status"] = np.where(self.certified, "certified", "unresolved")
        return pd.DataFrame(columns)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a file, as the command's `--out` does: complete or not at all.

        Parameters
        ----------
        path : path_like
            The extension decides. ``.html``, ``.glb``, ``.vtp``, ``.vtu``: files to look at, with the mesh in motion or
            the contacts as points; they need the step, see `view`, and of a path only ``.html`` can be made. Else CSV,
            whose columns are kind, v0, v1, v2, v3, toi_lower, toi_upper, u, v, status; numbers read back to the same
            doubles.

        Raises
        ------
        FileError
            The file cannot be written.
        Error
            As of `view`; and for a picture, ``.png``, which the command draws.
        """
        name, rows = os.fspath(path), np.ascontiguousarray(self._table).view(np.uint8)
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

    def __iter__(self) -> Iterator[Contact]:
        return (self[i] for i in range(len(self)))

    @overload
    def __getitem__(self, index: int) -> Contact: ...
    @overload
    def __getitem__(self, index: slice | npt.NDArray[Any] | list[int] | list[bool]) -> Contacts: ...
    def __getitem__(self, index: Any) -> Contact | Contacts:
        chosen = self._table[index]
        if isinstance(chosen, np.ndarray):
            return Contacts(np.atleast_1d(chosen), self._asked)
        kind, certainty, vertices, toi_lower, toi_upper, u, v, normal = chosen.item()
        return Contact(
            PairKind(kind), tuple(vertices.tolist()), toi_lower, toi_upper, u, v, tuple(normal.tolist()), certainty == 0
        )

    def __repr__(self) -> str:
        if not len(self):
            return "Contacts(none)"
        counts = zip(PairKind, np.bincount(self.kind, minlength=len(PairKind)))
        kinds = ", ".join(f"{n} {kind.name.lower().replace('_', '-')}" for kind, n in counts if n)
        return f"Contacts({kinds}; first at {self.toi_lower.min():g})"
