"""Questions to a detector about how far a step may go."""

from __future__ import annotations

import numpy.typing as npt

from tamis import _core
from tamis._answers import SafeStep, TruncatedStep, safe_step
from tamis._arrays import Doubles, rows
from tamis._checks import number, number_or_none


class StepLengths:
    """How far all vertices may go, and how far each; part of `Detector`."""

    __slots__ = ()
    _detector: _core.Detector

    def keep_distance(
        self, start: npt.ArrayLike, end: npt.ArrayLike, fraction: float = 0.1, *, min_separation: float | None = None
    ) -> SafeStep:
        """Find how far the step may go so that every pair keeps a fraction of its distance.

        The step length for the line search of a barrier method. The distance that counts is what exceeds the minimum
        separation.

        Parameters
        ----------
        start, end : array_like, shape (n, 3)
            Where each vertex is at the start and at the end of the step.
        min_separation : float, optional
            Of this question alone; by default the detector's.
        fraction : float
            0 <= fraction < 1. 0.1 for the line search of a barrier, where the next steps need room; 0.01 and less to
            come near what is met; 0.5 and more where distances may shrink slowly only. 0: only contacts count. The
            closer to 1, the longer the search.

        Returns
        -------
        SafeStep
            On [0, lower] every pair keeps the fraction: proven.

        Raises
        ------
        InvalidOptions
            The fraction is outside its range.
        """
        return safe_step(self._detector.keep_distance(*_given(start, end, fraction, min_separation)))

    def truncate(
        self, start: npt.ArrayLike, end: npt.ArrayLike, fraction: float = 0.1, *, min_separation: float | None = None
    ) -> TruncatedStep:
        """Find positions to go to, so that every pair keeps a fraction of its distance, and one does not stop all.

        All vertices go together as far as every pair keeps a little more than the fraction, from there each on its own
        side of planes between the features that it could reach, by a quarter of the mean edge at most. What starts
        within the minimum separation may move as long as it comes no nearer; then no vertex goes farther than that.

        Parameters
        ----------
        start, end : array_like, shape (n, 3)
            Where each vertex is at the start and at the end of the step.
        fraction : float
            0 < fraction < 1, of the distance as far as that exceeds the minimum separation.
        min_separation : float, optional
            Of this question alone; by default the detector's.

        Returns
        -------
        TruncatedStep
            Positions as doubles: the straight way there is proven.

        Raises
        ------
        InvalidOptions
            The fraction is outside its range.
        """
        return TruncatedStep(*self._detector.truncate(*_given(start, end, fraction, min_separation)))


def _given(
    start: npt.ArrayLike, end: npt.ArrayLike, fraction: float, min_separation: float | None
) -> tuple[Doubles, Doubles, float, float | None]:
    separation = number_or_none(min_separation, "min_separation")
    return rows(start, "start"), rows(end, "end"), number(fraction, "fraction"), separation
