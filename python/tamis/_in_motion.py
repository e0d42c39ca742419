"""Questions to a detector about contacts of a step, or of a path."""

from __future__ import annotations

from typing import overload

import numpy.typing as npt

from tamis import _core
from tamis._answers import EarliestContact
from tamis._checks import number_or_none
from tamis._contacts import Contacts
from tamis._looking import Asked
from tamis._mesh import Mesh
from tamis._motion import motion
from tamis._paths import Path


class InMotion:
    """Which contacts there are, which is the first, and whether there is any; part of `Detector`."""

    __slots__ = ()
    _mesh: Mesh
    _options: _core.Options
    _detector: _core.Detector

    @overload
    def contacts(
        self, start: npt.ArrayLike, end: npt.ArrayLike, *, min_separation: float | None = None
    ) -> Contacts: ...
    @overload
    def contacts(
        self, start: Path, /, *, min_separation: float | None = None, tolerance: float | None = None
    ) -> Contacts: ...
    def contacts(
        self,
        start: npt.ArrayLike | Path,
        end: npt.ArrayLike | None = None,
        *,
        min_separation: float | None = None,
        tolerance: float | None = None,
    ) -> Contacts:
        """Find every contact of a step, or of a path.

        Parameters
        ----------
        start, end : array_like, shape (n, 3)
            Where each vertex is at the start and at the end of the step. Or a `Path` alone: curved motion.
        min_separation : float, optional
            Of this question alone; by default the detector's.
        tolerance : float, optional
            Of a path: widest bracket of a contact, in (0, 1], a fraction of the step; by default 1e-9.

        Returns
        -------
        Contacts
            By kind, then vertices; `Contacts.view` shows them. On a path, what cannot be decided (a touch
            without crossing, say) is a contact that is not certified.
        """
        moving = motion(start, end, tolerance)
        separation = number_or_none(min_separation, "min_separation")
        found = self._detector.contacts(*moving.native(), separation)
        return Contacts(found, Asked(self._mesh._mesh, self._options, moving, separation))

    @overload
    def earliest(
        self, start: npt.ArrayLike, end: npt.ArrayLike, *, min_separation: float | None = None
    ) -> EarliestContact: ...
    @overload
    def earliest(
        self, start: Path, /, *, min_separation: float | None = None, tolerance: float | None = None
    ) -> EarliestContact: ...
    def earliest(
        self,
        start: npt.ArrayLike | Path,
        end: npt.ArrayLike | None = None,
        *,
        min_separation: float | None = None,
        tolerance: float | None = None,
    ) -> EarliestContact:
        """Find the first contact: how far the step, or the path, may go. `truncate` says to which positions.

        Parameters
        ----------
        start, end, min_separation, tolerance
            As of `contacts`.

        Returns
        -------
        EarliestContact
            The motion is free before its `toi_lower`: proven.
        """
        separation = number_or_none(min_separation, "min_separation")
        lower, upper, found = self._detector.earliest(*motion(start, end, tolerance).native(), separation)
        contacts = Contacts(found)
        return EarliestContact(lower, upper, contacts[0] if len(contacts) else None)

    @overload
    def is_free(self, start: npt.ArrayLike, end: npt.ArrayLike, *, min_separation: float | None = None) -> bool: ...
    @overload
    def is_free(
        self, start: Path, /, *, min_separation: float | None = None, tolerance: float | None = None
    ) -> bool: ...
    def is_free(
        self,
        start: npt.ArrayLike | Path,
        end: npt.ArrayLike | None = None,
        *,
        min_separation: float | None = None,
        tolerance: float | None = None,
    ) -> bool:
        """Tell whether the whole step, or the whole path, is free of contacts.

        Parameters
        ----------
        start, end, min_separation, tolerance
            As of `contacts`.

        Returns
        -------
        bool
            True is a proof. On a path False may be due to a contact that is not certified.
        """
        separation = number_or_none(min_separation, "min_separation")
        return self._detector.is_free(*motion(start, end, tolerance).native(), separation)
