"""Questions to a detector about how far a step may go."""

from __future__ import annotations

import numpy.typing as npt

from tamis import _core
from tamis._answers import SafeStep, TruncatedStep, VertexSteps, safe_step
from tamis._arrays import rows


class StepLengths:
    """How far all vertices may go, and how far each; part of `Detector`."""

    __slots__ = ()
    _detector: _core.Detector

    def keep_distance(
        self, start: npt.ArrayLike, end: npt.ArrayLike, fraction: float, *, min_separation: float | None = None
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
            0 <= fraction < 1. 0: only contacts count. The closer to 1, the longer the search.

        Returns
        -------
        SafeStep
            On [0, lower] every pair keeps the fraction: proven.

        Raises
        ------
        InvalidOptions
            The fraction is outside its range.
        """
        return safe_step(self._detector.keep_distance(rows(start, "start"), rows(end, "end"), fraction, min_separation))

    def vertex_steps(
        self, start: npt.ArrayLike, end: npt.ArrayLike, fraction: float = 0.1, *, min_separation: float | None = None
    ) -> VertexSteps:
        """Find a step for each vertex, so that one near pair does not stop all.

        All go together as far as `keep_distance` lets them, from there each on its own side of planes between the
        features that it could reach, and no farther than a quarter of the mean edge.

        Parameters
        ----------
        start, end : array_like, shape (n, 3)
            Where each vertex is at the start and at the end of the step.
        fraction : float
            Of its distance that every pair keeps on the way that all go together: 0 < fraction < 1.
        min_separation : float, optional
            Of this question alone; by default the detector's.

        Returns
        -------
        VertexSteps
            Fractions of the step up to which every vertex may go, whatever the others do: proven.

        Raises
        ------
        InvalidOptions
            The fraction is outside its range.
        """
        return VertexSteps(
            *self._detector.vertex_steps(rows(start, "start"), rows(end, "end"), fraction, min_separation)
        )

    def truncate(
        self, start: npt.ArrayLike, end: npt.ArrayLike, fraction: float = 0.1, *, min_separation: float | None = None
    ) -> TruncatedStep:
        """Find the positions to go to, by `vertex_steps`: the straight way to these very doubles is proven free.

        Parameters
        ----------
        start, end, fraction, min_separation
            As of `vertex_steps`.

        Returns
        -------
        TruncatedStep
            Each vertex on its own line towards its end.

        Raises
        ------
        InvalidOptions
            The fraction is outside its range.
        """
        return TruncatedStep(*self._detector.truncate(rows(start, "start"), rows(end, "end"), fraction, min_separation))
