"""Questions to a detector about a mesh at rest."""

from __future__ import annotations

import numpy.typing as npt

from tamis import _core
from tamis._arrays import rows
from tamis._checks import number
from tamis._tables._near import Intersections, NearPairs


class AtRest:
    """What is near, and what passes through each other; part of `Detector`."""

    __slots__ = ()
    _detector: _core.Detector

    def pairs_within(self, positions: npt.ArrayLike, distance: float) -> NearPairs:
        """Find every pair of features that is near at rest: what a barrier or penalty method starts from.

        Parameters
        ----------
        positions : array_like, shape (n, 3)
            Where each vertex is.
        distance : float
            >= 0, in the unit of the positions; the radii of both features are added.

        Returns
        -------
        NearPairs
            Each pair once, by kind, then vertices.

        Raises
        ------
        InvalidOptions
            The distance is negative or not finite.
        """
        return NearPairs(self._detector.pairs_within(rows(positions, "positions"), number(distance, "distance")))

    def intersections(self, positions: npt.ArrayLike) -> Intersections:
        """Find every edge that passes through a triangle or touches it: exactly.

        Without triangles there is nothing to find: of curves in the plane that cross each other ask ``contacts(x, x)``,
        which lists every pair that touches at x.

        Parameters
        ----------
        positions : array_like, shape (n, 3)
            Where each vertex is.

        Returns
        -------
        Intersections
            By edge, then face. Groups and `rings` leave out pairs; `filter`, radii and separation play no part.
        """
        return Intersections(self._detector.intersections(rows(positions, "positions")))

    def has_intersection(self, positions: npt.ArrayLike) -> bool:
        """Tell whether any edge passes through a triangle or touches it: whether this is no pose to start from.

        Of curves in the plane ask ``is_free(x, x)``, as `intersections` says.

        Parameters
        ----------
        positions : array_like, shape (n, 3)
            Where each vertex is.

        Returns
        -------
        bool
            Exact. Ends at the first.
        """
        return self._detector.has_intersection(rows(positions, "positions"))
