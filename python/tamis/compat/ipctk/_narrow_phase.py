"""Narrow phases by ipctk's names: they decide how much of its distance every pair keeps."""

from tamis.compat.ipctk._pairs import edge_edge_ccd, point_edge_ccd, point_point_ccd, point_triangle_ccd


class NarrowPhaseCCD:
    """Single pairs, and how far a step may go towards a contact.

    Attributes
    ----------
    conservative_rescaling : float
        The part of the distance at the start that a step may use up, in (0, 1].
    """

    conservative_rescaling: float

    point_triangle_ccd = staticmethod(point_triangle_ccd)
    edge_edge_ccd = staticmethod(edge_edge_ccd)
    point_edge_ccd = staticmethod(point_edge_ccd)
    point_point_ccd = staticmethod(point_point_ccd)

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
        self.conservative_rescaling = conservative_rescaling

    @property
    def kept_fraction(self) -> float:
        """The part of its distance that every pair keeps during a step."""
        return min(1e-4, super().kept_fraction)


class AdditiveCCD(NarrowPhaseCCD):
    """A step keeps a tenth of every distance unless told otherwise, as in ipctk; iterations have no meaning here."""

    def __init__(self, max_iterations: int = 10_000_000, conservative_rescaling: float = 0.9) -> None:
        self.conservative_rescaling = conservative_rescaling
