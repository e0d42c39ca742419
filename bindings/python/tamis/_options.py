"""The compiled part's options of a detector and of a question, made from Python's keywords."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import Groups, Indices, flags, indices, indices_or_none, vector
from tamis._checks import LARGEST_INDEX, function, number, number_or_none, whole, word
from tamis._errors import InvalidOptions
from tamis._kinds import PairKind

Isa = Literal["best", "baseline", "avx2", "avx512"]
AtStart = Literal["report", "ignore", "fail"]
Filter = Callable[[PairKind, "tuple[int, int, int, int]"], bool]


def group_count_of(groups: npt.ArrayLike | None) -> int:
    """Return how many groups these vertices need; 0 without any."""
    most = int(indices_or_none(groups, 0, "groups", InvalidOptions).max(initial=-1))
    if most == LARGEST_INDEX:
        raise InvalidOptions(f"groups holds {most}: give groups below {most}")
    return 1 + most


def _set_groups(
    options: _core.Options,
    groups: npt.ArrayLike | None,
    may_touch: npt.ArrayLike | None,
    radii: npt.ArrayLike | None,
    group_count: int = 1,
) -> None:
    """Set the groups of vertices, which of them may touch, and their radii. There are at least `group_count` groups."""
    radii = np.empty(0) if radii is None else vector(radii, "radii", InvalidOptions)
    options.set_radii(radii.tolist())
    if groups is None and may_touch is None:
        return
    if groups is None:
        raise InvalidOptions("may_touch is given without groups: give the group of each vertex")
    group_of_vertex: Indices = indices(groups, 0, "groups", InvalidOptions)
    count = max(group_count, len(radii), group_count_of(group_of_vertex))
    allowed: Groups = np.empty((0, 0), np.uint8)
    if may_touch is not None:
        allowed = flags(may_touch, "may_touch", InvalidOptions)
        count = max(count, len(allowed))
    options.set_groups(group_of_vertex, count, allowed)


def query_options(min_separation: float | None, at_start: AtStart) -> _core.QueryOptions:
    """Return the options of one question about a step."""
    return _core.QueryOptions(number_or_none(min_separation, "min_separation"), word(at_start, "at_start"))


def path_options(min_separation: float | None, at_start: AtStart, tolerance: float | None) -> _core.PathOptions:
    """Return the options of one question about a path or a world."""
    d, widest = number_or_none(min_separation, "min_separation"), number_or_none(tolerance, "tolerance")
    return _core.PathOptions(d, word(at_start, "at_start"), widest)


def make_options(
    *,
    threads: int,
    min_separation: float,
    isa: Isa,
    is_cancelled: Callable[[], bool] | None,
    groups: npt.ArrayLike | None = None,
    may_touch: npt.ArrayLike | None = None,
    radii: npt.ArrayLike | None = None,
    filter: Filter | None = None,
    rings: int = 1,
    group_count: int = 1,
) -> _core.Options:
    """Return the options of a detector or world; `group_count` as in `_set_groups`."""
    options = _core.Options()
    options.set_isa(word(isa, "isa"))
    options.set_threads(whole(threads, "threads", advice=", 0 being all"))
    options.set_min_separation(number(min_separation, "min_separation"))
    _set_groups(options, groups, may_touch, radii, group_count)
    options.set_rings(whole(rings, "rings", least=1))
    if filter is not None:
        accepts = function(filter, "filter", "filter(kind, vertices)")
        options.set_filter(lambda kind, vertices: accepts(PairKind(kind), vertices))
    if is_cancelled is not None:
        options.set_is_cancelled(function(is_cancelled, "is_cancelled", "is_cancelled()"))
    return options
