"""The tables of an audit's report: one of frames, one of pairs."""

from __future__ import annotations

import enum
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import Doubles, Indices
from tamis._checks import instance
from tamis._kinds import SHORT_NAMES, PairKind
from tamis._tables._columns import Columns, numbered
from tamis._tables._table import Column, Table

Counts = npt.NDArray[np.uint64]


class AuditKind(enum.IntEnum):
    """Kinds of pairs in a report: the kinds of `PairKind` for contacts, and EDGE_FACE for intersections."""

    VERTEX_FACE = PairKind.VERTEX_FACE.value
    EDGE_EDGE = PairKind.EDGE_EDGE.value
    VERTEX_EDGE = PairKind.VERTEX_EDGE.value
    VERTEX_VERTEX = PairKind.VERTEX_VERTEX.value
    EDGE_FACE = len(PairKind)

    @property
    def short_name(self) -> str:
        """The name in files and on the command line: vf, ee, ve, vv; ef for an intersection."""
        return _SHORT_NAMES[self]


_SHORT_NAMES = (*SHORT_NAMES, "ef")


class AuditPair(NamedTuple):
    """A contact in a step, or an intersection in a frame.

    Attributes
    ----------
    frame : int
        The number of the frame, from 0; for a contact, the frame at which the step ends.
    kind : AuditKind
        EDGE_FACE: an intersection. The other kinds: a contact.
    vertices : tuple of int
        The vertices of the first feature, then of the second, as in `Contact` and `Intersection`, without -1.
    toi_lower, toi_upper : float
        Fractions of the step, as in `Contact`; for an intersection both are 1.
    objects : tuple of two str
        The object that each feature belongs to: its name, or its number as text if it has none.
    rings : int
        The number of edges on the shortest path from one feature to the other; 1 for topological neighbours. -1 if no
        path leads there. The report's `ring_limit` + 1 if the path is longer than that limit.
    is_new : bool
        Whether the frame before, with the step to it, has no pair of this kind and these vertices.
    """

    frame: int
    kind: AuditKind
    vertices: tuple[int, ...]
    toi_lower: float
    toi_upper: float
    objects: tuple[str, str]
    rings: int
    is_new: bool


class ObjectNames:
    """The names of objects: lists of names, each valid from its first frame until the next list begins."""

    __slots__ = ("_first_frames", "_names")

    def __init__(self, segments: Sequence[tuple[int, Sequence[str]]]) -> None:
        self._first_frames = [first for first, _ in segments]
        self._names = [list(names) for _, names in segments]

    def of(self, frame: int, number: int) -> str:
        """Return the name of an object in a frame, or its number as text if it has no name."""
        segment = int(np.searchsorted(self._first_frames, frame, side="right")) - 1
        names = self._names[segment] if segment >= 0 else []
        return names[number] if 0 <= number < len(names) else str(number)


class FrameNames:
    """The names of frames."""

    __slots__ = ("_names",)

    def __init__(self, names: Sequence[str]) -> None:
        self._names = list(names)

    def of(self, frame: int) -> str:
        """Return the name of a frame, or its number as text if it has no name."""
        return self._names[frame] if frame < len(self._names) else str(frame)


_NO_NAMES = "none: only a report knows what things are called"


class AuditPairs(Table[AuditPair]):
    """Intersections and contacts, sorted by frame; in each frame the intersections come first.

    `len()` counts the pairs; an integer index gives an `AuditPair`, any other index of an array gives `AuditPairs`. The
    columns of `table` are frame, kind, vertices, toi_lower, toi_upper, objects, rings, is_new.
    """

    __slots__ = ("_names",)
    _dtype = np.dtype(_core.finding_layout())

    frame = Column[npt.NDArray[np.int64]](
        "The number of each pair's frame, shape (n,); for a contact, the frame at which the step ends."
    )
    kind = Column[npt.NDArray[np.uint8]]("The `AuditKind` of each pair, shape (n,).")
    vertices = Column[Indices](
        "Vertex indices of the first feature, then of the second, shape (n, 5); unused entries are -1."
    )
    toi_lower = Column[Doubles](
        "Fraction of the step, shape (n,): before it the pair is proven apart; 1 for an intersection."
    )
    toi_upper = Column[Doubles](
        "Fraction of the step, shape (n,): until then the pair has touched; 1 for an intersection."
    )
    objects = Column[Indices]("The numbers of both features' objects, shape (n, 2).")
    rings = Column[Indices]("The number of edges from one feature to the other, as in `AuditPair`, shape (n,).")
    is_new = Column[npt.NDArray[np.bool_]]("Whether the frame before does not have the pair, shape (n,).")

    def __init__(self, table: npt.NDArray[np.void] | npt.NDArray[np.uint8], names: ObjectNames | None = None) -> None:
        super().__init__(table)
        self._names = ObjectNames([]) if names is None else instance(names, ObjectNames, "names", _NO_NAMES)

    def _named_objects(self) -> list[tuple[str, str]]:
        of = self._names.of
        return [(of(f, a), of(f, b)) for f, (a, b) in zip(self.frame.tolist(), self.objects.tolist())]

    def _columns(self) -> Columns:
        names = np.array(self._named_objects(), dtype=object).reshape(-1, 2)
        return {
            "frame": self.frame,
            "kind": np.asarray(_SHORT_NAMES)[self.kind],
            **numbered("v", self.vertices, "01234"),
            "toi_lower": self.toi_lower,
            "toi_upper": self.toi_upper,
            "object_a": names[:, 0],
            "object_b": names[:, 1],
            "rings": self.rings,
            "new": self.is_new,
        }

    def _row(self, values: Any, index: int) -> AuditPair:
        frame, kind, vertices, toi_lower, toi_upper, (a, b), rings, is_new = values
        used = tuple(v for v in vertices.tolist() if v >= 0)
        names = (self._names.of(frame, int(a)), self._names.of(frame, int(b)))
        return AuditPair(frame, AuditKind(kind), used, toi_lower, toi_upper, names, rings, bool(is_new))

    def _part(self, table: npt.NDArray[np.void], index: Any) -> AuditPairs:
        return AuditPairs(table, self._names)

    def __reduce__(self) -> tuple[type[AuditPairs], tuple[Any, ...]]:
        return AuditPairs, (self._table, self._names)

    def __repr__(self) -> str:
        kinds, counts = np.unique(self.kind, return_counts=True)
        found = ", ".join(f"{n} {_SHORT_NAMES[kind]}" for kind, n in zip(kinds.tolist(), counts.tolist()))
        return f"AuditPairs({found or 'none'})"


class AuditFrame(NamedTuple):
    """One frame, and the step that ends there.

    Attributes
    ----------
    frame : int
        The number of the frame, from 0.
    name : str
        The source's name for the frame.
    is_usable : bool
        Whether the frame could be tested; if not, the report's `problems` say why.
    has_step : bool
        Whether the step from the frame before was tested.
    intersections : int
        The number of intersections in the frame.
    contacts : int
        The number of contacts in the step.
    neighbours : int
        The number of intersections and contacts whose features are one edge apart.
    new : int
        The number of intersections and contacts that the frame before does not have; 0 for the first frame.
    toi_lower, toi_upper : float
        Bracket of the first contact, fractions of the step: it is free before `toi_lower`, proven. 1 if it is free.
    has_collapsed : bool
        Whether all vertices of an object lie at one point or on one line; the report's `notes` name the object.
    """

    frame: int
    name: str
    is_usable: bool
    has_step: bool
    intersections: int
    contacts: int
    neighbours: int
    new: int
    toi_lower: float
    toi_upper: float
    has_collapsed: bool


class AuditFrames(Table[AuditFrame]):
    """Frames in their order, each with the step that ends there.

    `len()` counts the frames; an integer index gives an `AuditFrame`, any other index of an array gives `AuditFrames`.
    The columns of `table` are frame, is_usable, has_step, counts, neighbours, new, toi_lower, toi_upper,
    has_collapsed.
    """

    __slots__ = ("_names",)
    _dtype = np.dtype(_core.frame_row_layout())

    frame = Column[npt.NDArray[np.int64]]("The number of each frame, from 0, shape (n,).")
    is_usable = Column[npt.NDArray[np.bool_]]("Whether each frame could be asked about, shape (n,).")
    has_step = Column[npt.NDArray[np.bool_]]("Whether a step that ends at this frame was asked about, shape (n,).")
    counts = Column[Counts]("The number of pairs of each `AuditKind`, shape (n, 5).")
    neighbours = Column[Counts]("The number of pairs whose features are one edge apart, shape (n,).")
    new = Column[Counts]("The number of pairs that the frame before does not have, shape (n,).")
    toi_lower = Column[Doubles]("Fraction of each step, shape (n,): it is free before, proven; 1 if it is free.")
    toi_upper = Column[Doubles]("Fraction of each step, shape (n,): until then some pair has touched; 1 if it is free.")
    has_collapsed = Column[npt.NDArray[np.bool_]]("Whether an object has collapsed in each frame, shape (n,).")

    def __init__(self, table: npt.NDArray[np.void] | npt.NDArray[np.uint8], names: FrameNames | None = None) -> None:
        super().__init__(table)
        self._names = FrameNames([]) if names is None else instance(names, FrameNames, "names", _NO_NAMES)

    @property
    def names(self) -> list[str]:
        """The source's name for each frame."""
        return [self._names.of(frame) for frame in self.frame.tolist()]

    @property
    def intersections(self) -> Counts:
        """The number of intersections in each frame, shape (n,)."""
        return self.counts[:, AuditKind.EDGE_FACE]

    @property
    def contacts(self) -> Counts:
        """The number of contacts in each step, shape (n,)."""
        total: Counts = self.counts[:, : AuditKind.EDGE_FACE].sum(axis=1, dtype=np.uint64)
        return total

    @property
    def is_bad(self) -> npt.NDArray[np.bool_]:
        """Whether each frame has an intersection or a collapsed object, or its step a contact, shape (n,)."""
        bad: npt.NDArray[np.bool_] = np.asarray(self.counts.any(axis=1)) | self.has_collapsed
        return bad

    def _columns(self) -> Columns:
        kinds = {name: self.counts[:, kind] for kind, name in enumerate(_SHORT_NAMES)}
        columns = {name: self._table[name] for name in ("is_usable", "has_step")}
        rest = {name: self._table[name] for name in ("neighbours", "new", "toi_lower", "toi_upper", "has_collapsed")}
        return {"frame": self.frame, "name": np.array(self.names, dtype=object), **columns, **kinds, **rest}

    def _row(self, values: Any, index: int) -> AuditFrame:
        frame, is_usable, has_step, counts, *rest = values
        *contacts, intersections = counts.tolist()
        return AuditFrame(frame, self._names.of(frame), is_usable, has_step, intersections, sum(contacts), *rest)

    def _part(self, table: npt.NDArray[np.void], index: Any) -> AuditFrames:
        return AuditFrames(table, self._names)

    def __reduce__(self) -> tuple[type[AuditFrames], tuple[Any, ...]]:
        return AuditFrames, (self._table, self._names)

    def __repr__(self) -> str:
        return f"AuditFrames({len(self)} frames, {int(self.is_bad.sum())} of them bad)"
