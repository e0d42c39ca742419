"""Options of a detector, from Python's keywords to the library's."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import Doubles, Groups, Indices, indices, rows, table, vector
from tamis._contacts import PairKind
from tamis._errors import InvalidOptions

Guarantee = Literal["conservative", "exact"]
Isa = Literal["best", "baseline", "avx2", "avx512"]
Filter = Callable[[PairKind, "tuple[int, int, int, int]"], bool]


class ReducedModel:
    """Vertices that move in a subspace, x = X + U q: what high-level culling may know of a simulation.

    Parameters
    ----------
    rest : array_like, shape (n, 3)
        X: one row a vertex.
    basis : array_like, shape (3 n, modes)
        U: the rows of a vertex's x, y and z lie together.
    """

    __slots__ = ("basis", "rest")

    def __init__(self, rest: npt.ArrayLike, basis: npt.ArrayLike) -> None:
        self.rest: Doubles = np.ascontiguousarray(rows(rest, "rest", InvalidOptions))
        self.basis: Doubles = table(basis, "basis", InvalidOptions)

    def __repr__(self) -> str:
        return f"ReducedModel({len(self.rest)} vertices, {self.basis.shape[1]} modes)"


@dataclass(frozen=True)
class PaperOptions:
    """The laboratory of the method "paper"; the contacts are the same for every choice.

    Attributes
    ----------
    bounding_volume : str
        Of the hierarchy: "sphere", "aabb", "obb", "16-dop", "18-dop" or "26-dop".
    filters : sequence of str, optional
        Names in the order in which they are tried, of `filter_names()`; by default those of the method's name.
    orphan_sets : bool, optional
        False: pairs of triangles that share a vertex are tested like all others.
    representative_triangles : bool, optional
        False: a pair of features is tested in every pair of triangles that contains it.
    high_level : str, optional
        Patches proven free as a whole: "none", "normal-cones", "star-contours", or "subspace", which needs a model.
    reduced_model : ReducedModel, optional
        For "subspace".
    """

    bounding_volume: str = "16-dop"
    filters: Sequence[str] | None = None
    orphan_sets: bool | None = None
    representative_triangles: bool | None = None
    high_level: str | None = None
    reduced_model: ReducedModel | None = None

    def apply(self, options: _core.Options) -> None:
        """Set what is given; the rest stays as the method's name has it."""
        options.set_bounding_volume(self.bounding_volume)
        if self.filters is not None:
            options.set_paper_filters(list(self.filters))
        if self.orphan_sets is not None:
            options.set_orphan_sets(self.orphan_sets)
        if self.representative_triangles is not None:
            options.set_representative_triangles(self.representative_triangles)
        if self.high_level is not None:
            options.set_high_level(self.high_level)
        if self.reduced_model is not None:
            options.set_reduced_model(self.reduced_model.rest, self.reduced_model.basis)


def set_groups(
    options: _core.Options,
    groups: npt.ArrayLike | None,
    may_touch: npt.ArrayLike | None,
    thickness: npt.ArrayLike | None,
    group_count: int = 1,
) -> None:
    """Set which groups of vertices may touch which, and how thick they are; there are `group_count` or more."""
    radii = np.empty(0) if thickness is None else vector(thickness, "thickness", InvalidOptions)
    options.set_thickness(radii.tolist())
    if groups is None and may_touch is None:
        return
    group_of_vertex: Indices = indices(groups, 0, "groups", InvalidOptions)
    count = max(group_count, len(radii), 1 + int(group_of_vertex.max()) if group_of_vertex.size else 1)
    allowed: Groups = np.empty((0, 0), np.uint8)
    if may_touch is not None:
        flags = np.asarray(may_touch)
        if flags.dtype.kind not in "bui" or flags.ndim != 2 or flags.shape[0] != flags.shape[1]:
            raise InvalidOptions("may_touch is no square matrix of truth values: give one row and one column a group")
        allowed = np.ascontiguousarray(flags != 0).view(np.uint8)
        count = max(count, len(flags))
    options.set_groups(group_of_vertex, count, allowed)


def make_options(
    *,
    method: str,
    guarantee: Guarantee,
    threads: int,
    min_separation: float,
    isa: Isa,
    groups: npt.ArrayLike | None,
    may_touch: npt.ArrayLike | None,
    thickness: npt.ArrayLike | None,
    filter: Filter | None,
    is_cancelled: Callable[[], bool] | None,
    group_count: int = 1,
) -> _core.Options:
    """Return what the keywords of a detector say; `group_count` as of `set_groups`."""
    options = _core.Options()
    options.choose_method(method)
    options.set_guarantee(guarantee)
    options.set_isa(isa)
    if not -(2**31) <= threads < 2**31:
        raise InvalidOptions(f"threads is {threads}: give the number of threads, or 0 for all")
    options.set_threads(threads)
    options.set_min_separation(min_separation)
    set_groups(options, groups, may_touch, thickness, group_count)
    if filter is not None:
        accepts = filter
        options.set_filter(lambda kind, vertices: accepts(PairKind(kind), vertices))
    if is_cancelled is not None:
        options.set_is_cancelled(is_cancelled)
    return options
