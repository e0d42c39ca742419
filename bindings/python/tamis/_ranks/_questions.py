"""Questions that all ranks call together."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

import numpy.typing as npt

from tamis._answers import EarliestContact, SafeStep
from tamis._arrays import Doubles
from tamis._checks import whole
from tamis._errors import Busy
from tamis._motion import step_asked, step_asked_to_keep
from tamis._options import AtStart
from tamis._ranks._together import Ranks
from tamis._tables._contacts import Contacts
from tamis._tables._near import NearPairs
from tamis._tables._table import bracket_of

if TYPE_CHECKING:
    from tamis import _core, _distributed


class Questions:
    """The questions of `tamis.distributed.Detector` (this is a base of it). All are collective."""

    __slots__ = ()
    _lock: threading.Lock
    _ranks: Ranks
    _detector: _distributed.Detector

    def contacts(
        self,
        start: npt.ArrayLike,
        end: npt.ArrayLike,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
    ) -> Contacts:
        """Find every contact of a step. Each contact is in the answer of one rank.

        Parameters
        ----------
        start, end : array_like, shape (n, 3)
            Where this rank's `vertices` are at the start and at the end of the step.
        min_separation : float, optional
            >= 0, instead of the detector's for this question alone.
        at_start : str
            "report" or "ignore", as in `tamis.Detector.contacts`.

        Returns
        -------
        Contacts
            The contacts whose first vertex this rank gives (if several ranks do, the lowest of them), sorted by kind,
            then vertices.

        Raises
        ------
        InvalidStep
            Positions that do not fit the vertices, are not finite, or differ between ranks.
        InvalidOptions
            An option outside its range, or one that differs between ranks.
        """
        with self._turn():
            return Contacts(self._detector.contacts(*self._asked(start, end, min_separation, at_start)))

    def gather_contacts(self, root: int = 0) -> Contacts:
        """Bring the contacts of the last `contacts` to one rank.

        Parameters
        ----------
        root : int
            The rank that gets them.

        Returns
        -------
        Contacts
            On `root` the contacts of all ranks, in the order of `tamis.Detector`; on the other ranks none.

        Raises
        ------
        InvalidOptions
            There is no such rank.
        """
        with self._turn():
            return Contacts(self._detector.gather_contacts(self._ranks.together(lambda: whole(root, "root"))))

    def earliest(
        self,
        start: npt.ArrayLike,
        end: npt.ArrayLike,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
    ) -> EarliestContact:
        """Find the first contact: how far the step may go. The same on every rank.

        Parameters
        ----------
        start, end, min_separation, at_start
            As in `contacts`.

        Returns
        -------
        EarliestContact
            The motion is free before its `toi_lower`, proven.
        """
        with self._turn():
            found = self._detector.earliest(*self._asked(start, end, min_separation, at_start))
            return EarliestContact(*bracket_of(found, Contacts))

    def is_free(
        self,
        start: npt.ArrayLike,
        end: npt.ArrayLike,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
    ) -> bool:
        """Tell whether the whole step is free of contacts. The same on every rank.

        Parameters
        ----------
        start, end, min_separation, at_start
            As in `contacts`.

        Returns
        -------
        bool
            True is a proof.
        """
        with self._turn():
            return self._detector.is_free(*self._asked(start, end, min_separation, at_start))

    def safe_step(
        self,
        start: npt.ArrayLike,
        end: npt.ArrayLike,
        keep: float = 0.1,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
    ) -> SafeStep:
        """Find how far the step may go while every pair keeps a fraction of its distance. The same on every rank.

        Parameters
        ----------
        start, end, min_separation, at_start
            As in `contacts`.
        keep : float
            The fraction to keep, 0 <= keep < 1, as in `tamis.Detector.safe_step`. 0: only contacts count.

        Returns
        -------
        SafeStep
            On [0, toi_lower] every pair keeps the fraction, proven.

        Raises
        ------
        InvalidOptions
            `keep` is outside its range.
        """
        with self._turn():
            asked = self._ranks.together(lambda: step_asked_to_keep(start, end, keep, min_separation, at_start))
            return SafeStep(*bracket_of(self._detector.safe_step(*asked), NearPairs))

    def _asked(
        self, start: npt.ArrayLike, end: npt.ArrayLike, min_separation: float | None, at_start: AtStart
    ) -> tuple[_core.QueryOptions, Doubles, Doubles]:
        return self._ranks.together(lambda: step_asked(start, end, min_separation, at_start))

    @contextmanager
    def _turn(self) -> Iterator[None]:
        if not self._lock.acquire(blocking=False):
            raise Busy("the detector is answering another question: ask one after the other, on all ranks alike")
        try:
            yield
        finally:
            self._lock.release()
