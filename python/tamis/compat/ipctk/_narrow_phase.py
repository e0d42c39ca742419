"""Narrow phases by ipctk's names: they decide how much of its distance every pair keeps."""

from __future__ import annotations

from tamis._checks import number, number_from_zero, whole
from tamis._errors import InvalidOptions
from tamis.compat.ipctk._pairs import edge_edge_ccd, point_edge_ccd, point_point_ccd, point_triangle_ccd


class NarrowPhaseCCD:
    """Single pairs, and how far a step may go towards a contact: what both narrow phases have in common."""

    point_triangle_ccd = staticmethod(point_triangle_ccd)
    edge_edge_ccd = staticmethod(edge_edge_ccd)
    point_edge_ccd = staticmethod(point_edge_ccd)
    point_point_ccd = staticmethod(point_point_ccd)

    def __init__(self) -> None:
        raise InvalidOptions("NarrowPhaseCCD decides nothing by itself: give a TightInclusionCCD or an AdditiveCCD")

    @property
    def conservative_rescaling(self) -> float:
        """The part of the distance at the start that a step may use up, in (0, 1]."""
        return self._rescaling

    @conservative_rescaling.setter
    def conservative_rescaling(self, conservative_rescaling: float) -> None:
        self._rescaling = number(conservative_rescaling, "conservative_rescaling")
        if not 0 < self._rescaling <= 1:
            raise InvalidOptions(f"conservative_rescaling is {conservative_rescaling}: give a number > 0 and <= 1")

    @property
    def kept_fraction(self) -> float:
        """The part of its distance that every pair keeps during a step."""
        return 1 - self.conservative_rescaling


class TightInclusionCCD(NarrowPhaseCCD):
    """A step keeps 1e-4 of every distance, where ipctk keeps 1e-4 in the unit of the positions, or less.

    Tolerance and iterations have no meaning here.
    """

    def __init__(
        self, tolerance: float = 1e-6, max_iterations: int = 10_000_000, conservative_rescaling: float = 0.8
    ) -> None:
        number_from_zero(tolerance, "tolerance")
        whole(max_iterations, "max_iterations")
        self.conservative_rescaling = conservative_rescaling

    @property
    def kept_fraction(self) -> float:
        """The part of its distance that every pair keeps during a step."""
        return min(1e-4, super().kept_fraction)


class AdditiveCCD(NarrowPhaseCCD):
    """A step keeps a tenth of every distance unless told otherwise, as in ipctk; iterations have no meaning here."""

    def __init__(self, max_iterations: int = 10_000_000, conservative_rescaling: float = 0.9) -> None:
        whole(max_iterations, "max_iterations")
        self.conservative_rescaling = conservative_rescaling
