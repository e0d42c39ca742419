"""Lists of pairs, for callers who have a broad phase of their own."""

from __future__ import annotations

from typing import Any, NamedTuple, overload

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import Indices, pair_list
from tamis._checks import number, number_or_none
from tamis._errors import Error, InvalidOptions, InvalidPath, InvalidStep
from tamis._kinds import PairKind
from tamis._motion import StraightMotion, motion
from tamis._paths._path import Path
from tamis._tables._columns import MovingPairs
from tamis._tables._table import Column


class PairResult(NamedTuple):
    """Whether and when one pair touches during the step. If it does not, times, weights and normal have no meaning.

    Attributes
    ----------
    kind, vertices
        The pair, as it was given.
    touches : bool
        False: proven free.
    certified : bool
        True: proven to touch. False: free or, only on a path, unresolved.
    toi_lower, toi_upper, u, v, normal
        As in `Contact`.
    """

    kind: PairKind
    vertices: tuple[int, int, int, int]
    touches: bool
    certified: bool
    toi_lower: float
    toi_upper: float
    u: float
    v: float
    normal: tuple[float, float, float]


class Pairs(MovingPairs[PairResult]):
    """Whether and when each pair of a list touches during the step, as arrays of length n.

    Times, weights and normals have a meaning only where `touches` is True.

    `len()` counts the pairs; an integer index gives a `PairResult`, any other index of an array gives `Pairs`. The
    columns of `table` are touches, certainty (0: certified, 1: unresolved), toi_lower, toi_upper, u, v, normal; `kind`
    and `vertices` are those that were given.
    """

    __slots__ = ("_kind", "_vertices")
    _dtype = np.dtype(_core.pair_layout())

    touches = Column[npt.NDArray[np.bool_]](
        "True where the pair touches, or is unresolved; False where it is proven free, shape (n,)."
    )

    def __init__(
        self, table: npt.NDArray[np.void] | npt.NDArray[np.uint8], kind: npt.ArrayLike, vertices: npt.ArrayLike
    ) -> None:
        super().__init__(table)
        self._kind, self._vertices = pair_list(kind, vertices, InvalidStep)
        if len(self._kind) != len(self):
            raise InvalidStep(f"vertices has {len(self._kind)} rows, the table {len(self)}: give as many")

    @property
    def kind(self) -> npt.NDArray[np.uint8]:  # type: ignore[override]
        """The `PairKind` of each pair, shape (n,)."""
        return self._kind

    @property
    def vertices(self) -> Indices:  # type: ignore[override]
        """Vertex indices as given, shape (n, 4)."""
        return self._vertices

    @property
    def certified(self) -> npt.NDArray[np.bool_]:
        """True: proven to touch. False: free or, only on a path, unresolved. Shape (n,)."""
        return super().certified & self.touches

    def _status(self) -> npt.NDArray[np.str_]:
        return np.where(self.touches, super()._status(), "free")

    def _row(self, values: Any, index: int) -> PairResult:
        touches, certainty, lower, upper, u, v, normal = values
        kind, vertices = PairKind(self._kind[index]), tuple(self._vertices[index].tolist())
        is_certified = touches and certainty == 0
        return PairResult(kind, vertices, touches, is_certified, lower, upper, u, v, tuple(normal.tolist()))

    def _part(self, table: npt.NDArray[np.void], index: Any) -> Pairs:
        return Pairs(table, self._kind[index], self._vertices[index])

    def __eq__(self, other: object) -> bool:
        if not super().__eq__(other) or not isinstance(other, Pairs):
            return False
        return np.array_equal(self._kind, other._kind) and np.array_equal(self._vertices, other._vertices)

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[type[Pairs], tuple[Any, ...]]:
        return Pairs, (self._table, self._kind, self._vertices)

    def __repr__(self) -> str:
        return f"Pairs({len(self)} pairs, {int(self.touches.sum())} touch)"


@overload
def narrow_phase(
    kind: npt.ArrayLike,
    vertices: npt.ArrayLike,
    start: npt.ArrayLike,
    end: npt.ArrayLike,
    *,
    min_separation: float = 0.0,
    latest: float | None = None,
) -> Pairs: ...
@overload
def narrow_phase(
    kind: npt.ArrayLike,
    vertices: npt.ArrayLike,
    start: Path,
    *,
    min_separation: float = 0.0,
    tolerance: float | None = None,
) -> Pairs: ...
def narrow_phase(
    kind: npt.ArrayLike,
    vertices: npt.ArrayLike,
    start: npt.ArrayLike | Path,
    end: npt.ArrayLike | None = None,
    *,
    min_separation: float = 0.0,
    latest: float | None = None,
    tolerance: float | None = None,
) -> Pairs:
    """Decide each pair of a list by itself.

    Parameters
    ----------
    kind : array_like of PairKind, shape (n,)
        The kind of each pair; one kind may serve for all pairs.
    vertices : array_like of int, shape (n, 4)
        Rows of the positions, ordered as in `Contact`. Entries that a kind does not use are not read. One pair may have
        the shape (4,).
    start, end : array_like, shape (m, 3)
        Where each vertex is at the start and at the end of the step; no mesh is needed. Or a `Path` alone, for motion
        on curves.
    min_separation : float
        d >= 0, in the unit of the positions: contact means Euclidean distance <= d.
    latest : float, optional
        Only for a step: the latest time of interest, in [0, 1]; by default 1. A pair that is proven apart until then
        counts as free. The answers about other pairs do not depend on it.
    tolerance : float, optional
        Only for a path: the widest bracket of a contact, a fraction of the step in (0, 1]; by default 1e-9.

    Returns
    -------
    Pairs
        In the order of the input. A pair on a path that cannot be decided is a contact that is not certified.

    Raises
    ------
    InvalidStep
        An array of another shape or type, no such kind, an index that is not a row of the positions, or a
        coordinate that is not finite. The message names the pair.
    InvalidPath
        The same for a path, or a path that breaks its promises.
    InvalidOptions
        An option outside its range; `latest` for a path, or `tolerance` for a step.

    Examples
    --------
    >>> start = [[0, 0, 1], [0, 0, 0], [1, 0, 0], [0, 1, 0]]
    >>> end = [[0, 0, -1], [0, 0, 0], [1, 0, 0], [0, 1, 0]]
    >>> narrow_phase(PairKind.VERTEX_FACE, [0, 1, 2, 3], start, end)[0].toi_lower
    0.5
    """
    moving = motion(start, end, tolerance)
    error: type[Error] = InvalidStep if isinstance(moving, StraightMotion) else InvalidPath
    kinds, rows = pair_list(kind, vertices, error)
    kinds, rows = kinds.copy(), rows.copy()  # the answer names them
    d = number(min_separation, "min_separation")
    if isinstance(moving, StraightMotion):
        until = 1.0 if latest is None else number(latest, "latest")
        return Pairs(_core.narrow_phase(kinds, rows, moving.start, moving.end, d, until), kinds, rows)
    if latest is not None:
        raise InvalidOptions("latest is an option of steps: leave it out for a path")
    widest = number_or_none(tolerance, "tolerance")
    return Pairs(_core.narrow_phase_on(kinds, rows, moving.path._native(), d, widest), kinds, rows)
