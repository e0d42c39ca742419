"""Options of a detector, from Python's keywords to the library's."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import Doubles, Groups, Indices, finite, flags, indices, rows, table, vector
from tamis._checks import function, instance, number, number_or_none, shown, truth, whole, word
from tamis._errors import InvalidOptions
from tamis._kinds import PairKind

Isa = Literal["best", "baseline", "avx2", "avx512"]
AtStart = Literal["report", "ignore", "fail"]
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
        self.rest: Doubles = finite(np.ascontiguousarray(rows(rest, "rest", InvalidOptions)), "rest", InvalidOptions)
        self.basis: Doubles = finite(table(basis, "basis", InvalidOptions), "basis", InvalidOptions)

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

    def __post_init__(self) -> None:
        self._apply(_core.Options())

    def _apply(self, options: _core.Options) -> None:
        """Set what is given; the rest stays as the method's name has it."""
        options.set_bounding_volume(word(self.bounding_volume, "bounding_volume"))
        if self.filters is not None:
            options.set_paper_filters(_words(self.filters))
        if self.orphan_sets is not None:
            options.set_orphan_sets(truth(self.orphan_sets, "orphan_sets"))
        if self.representative_triangles is not None:
            options.set_representative_triangles(truth(self.representative_triangles, "representative_triangles"))
        if self.high_level is not None:
            options.set_high_level(word(self.high_level, "high_level"))
        if self.reduced_model is not None:
            model = instance(self.reduced_model, ReducedModel, "reduced_model", "a tamis.ReducedModel")
            options.set_reduced_model(model.rest, model.basis)


def _words(given: Sequence[str]) -> list[str]:
    if isinstance(given, str) or not isinstance(given, Sequence):
        raise InvalidOptions(f"filters is {shown(given)}: give a list of names, of filter_names()")
    return [word(name, "a name in filters") for name in given]


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
    if groups is None:
        raise InvalidOptions("may_touch is given without groups: give the group of each vertex")
    group_of_vertex: Indices = indices(groups, 0, "groups", InvalidOptions)
    count = max(group_count, len(radii), 1 + int(group_of_vertex.max()) if group_of_vertex.size else 1)
    allowed: Groups = np.empty((0, 0), np.uint8)
    if may_touch is not None:
        allowed = flags(may_touch, "may_touch", InvalidOptions)
        count = max(count, len(allowed))
    options.set_groups(group_of_vertex, count, allowed)


def query_options(min_separation: float | None, at_start: AtStart) -> _core.QueryOptions:
    """Return what a question brings of its own."""
    return _core.QueryOptions(number_or_none(min_separation, "min_separation"), word(at_start, "at_start"))


def make_options(
    *,
    method: str,
    threads: int,
    min_separation: float,
    isa: Isa,
    groups: npt.ArrayLike | None,
    may_touch: npt.ArrayLike | None,
    thickness: npt.ArrayLike | None,
    filter: Filter | None,
    is_cancelled: Callable[[], bool] | None,
    rings: int = 1,
    group_count: int = 1,
) -> _core.Options:
    """Return what the keywords of a detector say; `group_count` as of `set_groups`."""
    options = _core.Options()
    options.choose_method(word(method, "method"))
    options.set_isa(word(isa, "isa"))
    options.set_threads(whole(threads, "threads", advice=", 0 being all"))
    options.set_min_separation(number(min_separation, "min_separation"))
    set_groups(options, groups, may_touch, thickness, group_count)
    options.set_rings(whole(rings, "rings", least=1))
    if filter is not None:
        accepts = function(filter, "filter", "filter(kind, vertices)")
        options.set_filter(lambda kind, vertices: accepts(PairKind(kind), vertices))
    if is_cancelled is not None:
        options.set_is_cancelled(function(is_cancelled, "is_cancelled", "is_cancelled()"))
    return options
