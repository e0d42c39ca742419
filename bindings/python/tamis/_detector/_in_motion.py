"""Questions to a detector about the contacts of a step or a path."""

from __future__ import annotations

from typing import TYPE_CHECKING, overload

import numpy.typing as npt

from tamis import _core
from tamis._answers import EarliestContact
from tamis._mesh import Mesh
from tamis._motion import AskedMotion, motion_asked
from tamis._options import AtStart
from tamis._pages import Asked
from tamis._paths._path import Path
from tamis._tables._contacts import Contacts
from tamis._tables._table import bracket_of

if TYPE_CHECKING:
    from tamis._motion import Own


class InMotion:
    """Questions about motion: all contacts, the first one, whether there is any; a base of `Detector`."""

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
        """Find every contact of a step or a path.

        Parameters
        ----------
        start, end : array_like, shape (n, 3)
            Where each vertex is at the start and at the end of the step. Or a `Path` alone, for motion on curves.
        min_separation : float, optional
            >= 0, instead of the detector's for this question alone.
        at_start : str
            How to count pairs that touch at t=0: whose distance there is at most `min_separation` plus both radii.
            "report": they are contacts at t=0. "ignore": such a pair is a contact only when it touches again after it
            has come apart; `Statistics.ignored` counts the pairs that never do. "fail": raise `InvalidStep`, which
            names the first such pair. On a path, a pair counts as touching at t=0 if it cannot be proven apart there.
        tolerance : float, optional
            Only for a path: the widest bracket of a contact, a fraction of the step in (0, 1]; by default 1e-9.

        Returns
        -------
        Contacts
            Sorted by kind, then vertices; `Contacts.view` shows them. A pair on a path that cannot be decided, such as
            a touch without crossing, is a contact that is not certified.

        Raises
        ------
        InvalidStep
            Positions that do not fit the mesh or are not finite; with "fail", a pair that touches at t=0.
        InvalidPath
            A path that does not fit the mesh or breaks its promises.
        InvalidOptions
            An option outside its range, or a tolerance for a step.
        """
        return self._contacts_of(*motion_asked(start, end, min_separation, at_start, tolerance))

    def _contacts_of(self, moving: AskedMotion, own: Own) -> Contacts:
        """Answer `contacts` for arguments that are already checked."""
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
        """Find the first contact: how far the step or the path may go. `truncate` returns positions to go to.

        Parameters
        ----------
        start, end, min_separation, at_start, tolerance
            As in `contacts`.

        Returns
        -------
        EarliestContact
            The motion is free before its `toi_lower`, proven.

        Raises
        ------
        InvalidStep, InvalidPath, InvalidOptions
            As in `contacts`.
        """
        moving, own = motion_asked(start, end, min_separation, at_start, tolerance)
        found = self._detector.earliest(own, *moving.native())
        return EarliestContact(*bracket_of(found, Contacts))

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
        """Tell whether the whole step or path is free of contacts.

        Parameters
        ----------
        start, end, min_separation, at_start, tolerance
            As in `contacts`.

        Returns
        -------
        bool
            True is a proof. On a path, False may be due to a contact that is not certified.

        Raises
        ------
        InvalidStep, InvalidPath, InvalidOptions
            As in `contacts`.
        """
        moving, own = motion_asked(start, end, min_separation, at_start, tolerance)
        return self._detector.is_free(own, *moving.native())
