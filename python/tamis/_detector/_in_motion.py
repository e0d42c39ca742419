"""Questions to a detector about contacts of a step, or of a path."""

from __future__ import annotations

from typing import overload

import numpy.typing as npt

from tamis import _core
from tamis._answers import EarliestContact, earliest_of
from tamis._looking import Asked
from tamis._mesh import Mesh
from tamis._motion import Motion, motion
from tamis._options import AtStart, query_options
from tamis._paths._path import Path
from tamis._tables._contacts import Contacts


class InMotion:
    """Which contacts there are, which is the first, and whether there is any; part of `Detector`."""

    __slots__ = ()
    _mesh: Mesh
    _options: _core.Options
    _detector: _core.Detector

    @overload
    def contacts(
        self,
        start: npt.ArrayLike,
        end: npt.ArrayLike,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
    ) -> Contacts: ...
    @overload
    def contacts(
        self,
        start: Path,
        /,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
        tolerance: float | None = None,
    ) -> Contacts: ...
    def contacts(
        self,
        start: npt.ArrayLike | Path,
        end: npt.ArrayLike | None = None,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
        tolerance: float | None = None,
    ) -> Contacts:
        """Find every contact of a step, or of a path.

        Parameters
        ----------
        start, end : array_like, shape (n, 3)
            Where each vertex is at the start and at the end of the step. Or a `Path` alone: curved motion.
        min_separation : float, optional
            Of this question alone; by default the detector's.
        at_start : str
            What becomes of pairs that touch at the start of a step, whose distance there is at most `min_separation`
            plus both radii. "report": they are contacts at t=0. "ignore": they count once they have come apart, so
            that one that never comes apart, or never comes back, is no contact (`Statistics.ignored`). "fail":
            `InvalidStep` names the first of them. On a path a pair that cannot be told from one that touches is
            taken for one.
        tolerance : float, optional
            Of a path: widest bracket of a contact, in (0, 1], a fraction of the step; by default 1e-9.

        Returns
        -------
        Contacts
            By kind, then vertices; `Contacts.view` shows them. On a path, what cannot be decided (a touch
            without crossing, say) is a contact that is not certified.
        """
        return self._contacts_of(motion(start, end, tolerance), query_options(min_separation, at_start, tolerance))

    def _contacts_of(self, moving: Motion, own: _core.QueryOptions) -> Contacts:
        """Ask the same without a look at what is given."""
        found = self._detector.contacts(own, *moving.native())
        return Contacts(found, Asked(self._mesh._mesh, self._options, moving, own))

    @overload
    def earliest(
        self,
        start: npt.ArrayLike,
        end: npt.ArrayLike,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
    ) -> EarliestContact: ...
    @overload
    def earliest(
        self,
        start: Path,
        /,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
        tolerance: float | None = None,
    ) -> EarliestContact: ...
    def earliest(
        self,
        start: npt.ArrayLike | Path,
        end: npt.ArrayLike | None = None,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
        tolerance: float | None = None,
    ) -> EarliestContact:
        """Find the first contact: how far the step, or the path, may go. `truncate` says to which positions.

        Parameters
        ----------
        start, end, min_separation, at_start, tolerance
            As of `contacts`.

        Returns
        -------
        EarliestContact
            The motion is free before its `toi_lower`: proven.
        """
        own = query_options(min_separation, at_start, tolerance)
        return earliest_of(self._detector.earliest(own, *motion(start, end, tolerance).native()))

    @overload
    def is_free(
        self,
        start: npt.ArrayLike,
        end: npt.ArrayLike,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
    ) -> bool: ...
    @overload
    def is_free(
        self,
        start: Path,
        /,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
        tolerance: float | None = None,
    ) -> bool: ...
    def is_free(
        self,
        start: npt.ArrayLike | Path,
        end: npt.ArrayLike | None = None,
        *,
        min_separation: float | None = None,
        at_start: AtStart = "report",
        tolerance: float | None = None,
    ) -> bool:
        """Tell whether the whole step, or the whole path, is free of contacts.

        Parameters
        ----------
        start, end, min_separation, at_start, tolerance
            As of `contacts`.

        Returns
        -------
        bool
            True is a proof. On a path False may be due to a contact that is not certified.
        """
        own = query_options(min_separation, at_start, tolerance)
        return self._detector.is_free(own, *motion(start, end, tolerance).native())
