"""Narrow phases with ipctk's names: they decide how much of its distance every pair keeps."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles, finite, numbers
from tamis._checks import number, number_from_zero, whole
from tamis._errors import InvalidOptions, InvalidStep
from tamis._kinds import PairKind
from tamis._pair_distance import safe_step


class NarrowPhaseCCD:
    """The base of both narrow phases: calls for single pairs, and the fraction of its distance that a pair keeps.

    The calls for single pairs return (False, inf) if the pair keeps its fraction until `tmax`, else (True, t): it keeps
    the fraction until t.
    """

    def __init__(self) -> None:
        raise InvalidOptions("NarrowPhaseCCD decides nothing by itself: give a TightInclusionCCD or an AdditiveCCD")

    @property
    def conservative_rescaling(self) -> float:
        """The fraction of its distance at the start that a pair may lose in a step, in (0, 1]."""
        return self._rescaling

    @conservative_rescaling.setter
    def conservative_rescaling(self, conservative_rescaling: float) -> None:
        self._rescaling = number(conservative_rescaling, "conservative_rescaling")
        if not 0 < self._rescaling <= 1:
            raise InvalidOptions(f"conservative_rescaling is {conservative_rescaling}: give a number > 0 and <= 1")

    @property
    def kept_fraction(self) -> float:
        """The fraction that every pair keeps of its distance, as far as it exceeds the minimum distance."""
        return 1 - self.conservative_rescaling

    def point_triangle_ccd(
        self,
        p_t0: npt.ArrayLike,
        t0_t0: npt.ArrayLike,
        t1_t0: npt.ArrayLike,
        t2_t0: npt.ArrayLike,
        p_t1: npt.ArrayLike,
        t0_t1: npt.ArrayLike,
        t1_t1: npt.ArrayLike,
        t2_t1: npt.ArrayLike,
        min_distance: float = 0.0,
        tmax: float = 1.0,
    ) -> tuple[bool, float]:
        """Decide a point and a triangle."""
        start = _stacked(p_t0=p_t0, t0_t0=t0_t0, t1_t0=t1_t0, t2_t0=t2_t0)
        end = _stacked(p_t1=p_t1, t0_t1=t0_t1, t1_t1=t1_t1, t2_t1=t2_t1)
        return self._found(PairKind.VERTEX_FACE, start, end, min_distance, tmax)

    def edge_edge_ccd(
        self,
        ea0_t0: npt.ArrayLike,
        ea1_t0: npt.ArrayLike,
        eb0_t0: npt.ArrayLike,
        eb1_t0: npt.ArrayLike,
        ea0_t1: npt.ArrayLike,
        ea1_t1: npt.ArrayLike,
        eb0_t1: npt.ArrayLike,
        eb1_t1: npt.ArrayLike,
        min_distance: float = 0.0,
        tmax: float = 1.0,
    ) -> tuple[bool, float]:
        """Decide two edges."""
        start = _stacked(ea0_t0=ea0_t0, ea1_t0=ea1_t0, eb0_t0=eb0_t0, eb1_t0=eb1_t0)
        end = _stacked(ea0_t1=ea0_t1, ea1_t1=ea1_t1, eb0_t1=eb0_t1, eb1_t1=eb1_t1)
        return self._found(PairKind.EDGE_EDGE, start, end, min_distance, tmax)

    def point_edge_ccd(
        self,
        p_t0: npt.ArrayLike,
        e0_t0: npt.ArrayLike,
        e1_t0: npt.ArrayLike,
        p_t1: npt.ArrayLike,
        e0_t1: npt.ArrayLike,
        e1_t1: npt.ArrayLike,
        min_distance: float = 0.0,
        tmax: float = 1.0,
    ) -> tuple[bool, float]:
        """Decide a point and an edge."""
        start = _stacked(p_t0=p_t0, e0_t0=e0_t0, e1_t0=e1_t0)
        end = _stacked(p_t1=p_t1, e0_t1=e0_t1, e1_t1=e1_t1)
        return self._found(PairKind.VERTEX_EDGE, start, end, min_distance, tmax)

    def point_point_ccd(
        self,
        p0_t0: npt.ArrayLike,
        p1_t0: npt.ArrayLike,
        p0_t1: npt.ArrayLike,
        p1_t1: npt.ArrayLike,
        min_distance: float = 0.0,
        tmax: float = 1.0,
    ) -> tuple[bool, float]:
        """Decide two points."""
        start = _stacked(p0_t0=p0_t0, p1_t0=p1_t0)
        end = _stacked(p0_t1=p0_t1, p1_t1=p1_t1)
        return self._found(PairKind.VERTEX_VERTEX, start, end, min_distance, tmax)

    def _found(
        self, kind: PairKind, start: Doubles, end: Doubles, min_distance: float, tmax: float
    ) -> tuple[bool, float]:
        vertices = [i if i < len(start) else -1 for i in range(4)]
        distance, latest = number(min_distance, "min_distance"), number(tmax, "tmax")
        safe = safe_step(kind, vertices, start, end, self.kept_fraction, min_separation=distance, latest=latest)
        return (False, float("inf")) if safe.pair is None else (True, safe.toi_lower)


class TightInclusionCCD(NarrowPhaseCCD):
    """Every pair keeps 1e-4 of its distance; with ipctk's, 1e-4 in the unit of the positions, or less.

    `tolerance` and `max_iterations` have no effect.
    """

    def __init__(
        self, tolerance: float = 1e-6, max_iterations: int = 10_000_000, conservative_rescaling: float = 0.8
    ) -> None:
        number_from_zero(tolerance, "tolerance")
        whole(max_iterations, "max_iterations")
        self.conservative_rescaling = conservative_rescaling

    @property
    def kept_fraction(self) -> float:
        """The fraction that every pair keeps of its distance, as far as it exceeds the minimum distance."""
        return min(1e-4, super().kept_fraction)


class AdditiveCCD(NarrowPhaseCCD):
    """Every pair keeps 1 - `conservative_rescaling` of its distance, by default a tenth, as in ipctk.

    `max_iterations` has no effect.
    """

    def __init__(self, max_iterations: int = 10_000_000, conservative_rescaling: float = 0.9) -> None:
        whole(max_iterations, "max_iterations")
        self.conservative_rescaling = conservative_rescaling


def _stacked(**points: npt.ArrayLike) -> Doubles:
    """Return points as rows, shape (n, 3); errors call them by the caller's names."""
    return np.stack([_point(point, name) for name, point in points.items()])


def _point(given: npt.ArrayLike, name: str) -> Doubles:
    """Return one point, shape (3,), that was given with the shape (3,), (1, 3) or (3, 1)."""
    array = numbers(given, name, InvalidStep)
    if array.shape not in ((3,), (1, 3), (3, 1)):
        advice = "give three numbers in a row; points in the plane have a z of 0"
        raise InvalidStep(f"{name} has {array.size} numbers in {array.ndim} dimensions: {advice}")
    return finite(array.ravel().astype(np.float64), name, InvalidStep)
