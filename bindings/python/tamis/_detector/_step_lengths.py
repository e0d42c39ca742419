"""Questions to a detector about how far a step may go."""

from __future__ import annotations

import numpy.typing as npt

from tamis import _core
from tamis._answers import SafeStep, TruncatedStep
from tamis._checks import shown, word
from tamis._errors import InvalidOptions
from tamis._motion import step_asked_to_keep
from tamis._options import AtStart
from tamis._tables._near import NearPairs
from tamis._tables._table import bracket_of


class StepLengths:
    """Questions about step lengths: how far all vertices may go, and how far each; a base of `Detector`."""

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
        """Find how far the step may go while every pair keeps a fraction of its distance.

        This is the step length for the line search of a barrier method. The distance that counts is what exceeds the
        minimum separation and both radii. The proof is about the straight motion: ``start + t * (end - start)`` is
        rounded to doubles, and pairs that are a few units in the last place apart there may touch. So query
        ``is_free(start, positions)`` about the rounded positions, or use `truncate`. Its positions are proven as they
        are stored.

        Parameters
        ----------
        start, end, min_separation
            As in `contacts`, for a step.
        keep : float
            The fraction to keep, 0 <= keep < 1. Take 0.1 for a barrier's line search, whose next steps need space. Take
            0.01 or less if a step should come near obstacles. Take 0.5 or more if distances may only shrink slowly. 0:
            only contacts count. The closer to 1, the longer the search takes.
        at_start : str
            As in `contacts`. An ignored pair has no distance to keep: it ends the step where it touches again.

        Returns
        -------
        SafeStep
            On [0, toi_lower] every pair keeps the fraction, proven.

        Raises
        ------
        InvalidStep
            As in `contacts`.
        InvalidOptions
            `keep` or another option is outside its range.
        """
        given = step_asked_to_keep(start, end, keep, min_separation, at_start)
        return SafeStep(*bracket_of(self._detector.safe_step(*given), NearPairs))

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
        """Find positions to go to: every pair keeps a fraction of its distance, and near pairs do not stop the rest.

        All vertices go together as long as every pair keeps a little more than the fraction. From there each vertex
        moves by itself, by at most a quarter of the mean edge. It stays on its own side of planes between the features
        that it could reach. A pair that starts within the minimum separation may move as long as it comes no nearer; if
        there is one, no vertex goes farther than that quarter in all.

        Parameters
        ----------
        start, end, min_separation
            As in `contacts`, for a step.
        keep : float
            The fraction to keep, 0 < keep < 1, of the distance as far as it exceeds the minimum separation and both
            radii.
        at_start : str
            As in `contacts`. An ignored pair may move freely, but not apart and back.
        stored : str
            The type of your stored positions, "float64" or "float32". With "float32" all positions are values of
            float32: storing them so changes nothing, and the proof holds for the stored positions.

        Returns
        -------
        TruncatedStep
            Its positions are doubles. The straight way to them is proven.

        Raises
        ------
        InvalidOptions
            `keep` or another option is outside its range, or `stored` is another name.
        InvalidStep
            As in `contacts`. With "float32" also if `start` has a number that is not float32, or if `end` is outside
            their range.
        """
        given = step_asked_to_keep(start, end, keep, min_separation, at_start)
        return TruncatedStep(*self._detector.truncate(*given, _is_float32(stored)))


def _is_float32(stored: str) -> bool:
    if word(stored, "stored") not in ("float64", "float32"):
        raise InvalidOptions(f"stored is {shown(stored)}: give 'float64' or 'float32'")
    return stored == "float32"
