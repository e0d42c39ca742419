"""Questions to a detector about how far a step may go."""

from __future__ import annotations

import numpy.typing as npt

from tamis import _core
from tamis._answers import SafeStep, TruncatedStep, safe_step_of
from tamis._checks import shown, word
from tamis._errors import InvalidOptions
from tamis._motion import step_asked_to_keep
from tamis._options import AtStart


class StepLengths:
    """How far all vertices may go, and how far each; part of `Detector`."""

    __slots__ = ()
    _detector: _core.Detector

    def safe_step(
        self,
        start: npt.ArrayLike,
        end: npt.ArrayLike,
        keep: float = 0.1,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
    ) -> SafeStep:
        """Find how far the step may go so that every pair keeps a fraction of its distance.

        The step length for the line search of a barrier method. The distance that counts is what exceeds the minimum
        separation. What is proven is said of the straight motion: ``start + t * (end - start)`` is rounded, and pairs
        that are a few units in the last place apart there may touch. Ask ``is_free(start, positions)`` of the rounded
        positions, or `truncate`, whose positions are proven as they are stored.

        Parameters
        ----------
        start, end, min_separation
            As of `contacts` of a step.
        at_start : str
            As of `contacts`. A pair that is ignored has nothing to keep: it ends the step where it touches again.
        keep : float
            0 <= keep < 1. 0.1 for the line search of a barrier, where the next steps need room; 0.01 and less to
            come near what is met; 0.5 and more where distances may shrink slowly only. 0: only contacts count. The
            closer to 1, the longer the search.

        Returns
        -------
        SafeStep
            On [0, lower] every pair keeps the fraction: proven.

        Raises
        ------
        InvalidOptions
            `keep` is outside its range.
        """
        return safe_step_of(self._detector.safe_step(*step_asked_to_keep(start, end, keep, min_separation, at_start)))

    def truncate(
        self,
        start: npt.ArrayLike,
        end: npt.ArrayLike,
        keep: float = 0.1,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
        stored: str = "float64",
    ) -> TruncatedStep:
        """Find positions to go to, so that every pair keeps a fraction of its distance, and one does not stop all.

        First all vertices go together, as far as every pair keeps a little more than the fraction. From there each goes
        on by itself, by a quarter of the mean edge at most, and stays on its own side of planes between the features
        that it could reach. A pair that starts within the minimum separation may move as long as it comes no nearer;
        where there is one, no vertex goes farther than a quarter of the mean edge in all.

        Parameters
        ----------
        start, end, min_separation
            As of `contacts` of a step.
        keep : float
            0 < keep < 1, of the distance as far as that exceeds the minimum separation.
        at_start : str
            As of `contacts`. A pair that is ignored may move as it likes, but not apart and back.
        stored : str
            The type of number that you keep positions in: "float64" or "float32". With the latter all positions are
            values that a float32 has, so that storing them as such changes nothing.

        Returns
        -------
        TruncatedStep
            Positions as doubles: the straight way there is proven.

        Raises
        ------
        InvalidOptions
            `keep` is outside its range; `stored` is another name.
        InvalidStep
            With "float32": `start` has a number that no float32 has, or `end` is beyond all of them.
        """
        given = step_asked_to_keep(start, end, keep, min_separation, at_start)
        return TruncatedStep(*self._detector.truncate(*given, _is_float32(stored)))


def _is_float32(stored: str) -> bool:
    if word(stored, "stored") not in ("float64", "float32"):
        raise InvalidOptions(f"stored is {shown(stored)}: give 'float64' or 'float32'")
    return stored == "float32"
