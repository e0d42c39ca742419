"""Questions to a detector about a mesh at rest."""

from __future__ import annotations

import numpy.typing as npt

from tamis import _core
from tamis._arrays import rows
from tamis._checks import number
from tamis._tables._near import Intersections, NearPairs


class AtRest:
    """Questions about one pose: which features are near each other, which intersect; a base of `Detector`."""

    __slots__ = ()
    _detector: _core.Detector

    def pairs_within(self, positions: npt.ArrayLike, distance: float) -> NearPairs:
        """Find every pair of features that are near each other in one pose: the input of a barrier or penalty method.

        Parameters
        ----------
        positions : array_like, shape (n, 3)
            Where each vertex is.
        distance : float
            >= 0, in the unit of the positions: pairs at most this far apart count. The radii of both features are
            added to it.

        Returns
        -------
        NearPairs
            Each pair once, sorted by kind, then vertices. It may hold some pairs that are farther apart, by less than
            the error of `NearPair.distance`.

        Raises
        ------
        InvalidOptions
            The distance is negative or not finite.
        InvalidStep
            Positions that do not fit the mesh, or are not finite.
        """
        return NearPairs(self._detector.pairs_within(rows(positions, "positions"), number(distance, "distance")))

    def intersections(self, positions: npt.ArrayLike) -> Intersections:
        """Find every edge that passes through a triangle or touches it, and shares no vertex with it. Decided exactly.

        A mesh without triangles has no intersections. For curves in the plane that cross each other use ``contacts(x,
        x)``, which lists every pair that touches at x.

        Parameters
        ----------
        positions : array_like, shape (n, 3)
            Where each vertex is.

        Returns
        -------
        Intersections
            Sorted by edge, then face. `groups` with `may_touch`, and `rings`, skip pairs; `filter`, `radii` and
            `min_separation` do not count.

        Raises
        ------
        InvalidStep
            Positions that do not fit the mesh, or are not finite.
        """
        return Intersections(self._detector.intersections(rows(positions, "positions")))

    def has_intersection(self, positions: npt.ArrayLike) -> bool:
        """Tell whether any edge passes through a triangle or touches it.

        No simulation should start from such a pose. Decided exactly; ends at the first intersection. For curves in the
        plane use ``is_free(x, x)``.

        Parameters
        ----------
        positions : array_like, shape (n, 3)
            Where each vertex is.

        Returns
        -------
        bool
            Whether `intersections` has a row.

        Raises
        ------
        InvalidStep
            Positions that do not fit the mesh, or are not finite.
        """
        return self._detector.has_intersection(rows(positions, "positions"))
