"""Answers about a whole step: its first contact, and how far it may go."""

from __future__ import annotations

from typing import NamedTuple

from tamis._arrays import Doubles
from tamis._renamed import renamed
from tamis._tables._contacts import Contact
from tamis._tables._near import NearPair


class EarliestContact(NamedTuple):
    """The first contact of a step: how far the step may go.

    Attributes
    ----------
    toi_lower : float
        Fraction of the step: the motion is free on [0, toi_lower), proven. 1 if the whole step is free.
    toi_upper : float
        A certified contact happens at or before this fraction of the step. 1 if the step is free, or if no contact is
        certified, as may be on a path.
    contact : Contact or None
        The contact that ends the step; None if the step is free.
    """

    toi_lower: float
    toi_upper: float
    contact: Contact | None


@renamed(lower="toi_lower", upper="toi_upper")
class SafeStep(NamedTuple):
    """How far the step may go while every pair keeps a fraction of its distance.

    Attributes
    ----------
    toi_lower : float
        Fraction of the step: every pair keeps at least its fraction of the distance on [0, toi_lower], proven. No pair
        touches on [0, toi_lower), proven. 1 if the whole step may go.
    toi_upper : float
        Fraction of the step: at this time some pair has no more than its fraction of the distance left, proven. 1 if
        that is not known of any time.
    pair : NearPair or None
        The pair that ends the step, as it is at the start; None if the whole step may go.
    """

    toi_lower: float
    toi_upper: float
    pair: NearPair | None


class TruncatedStep(NamedTuple):
    """Where each vertex may go, on its own line from the start of the step towards its end.

    Attributes
    ----------
    positions : array of float64, shape (n, 3)
        The positions to go to. On the straight way from the start of the step to these doubles, every pair keeps
        the fraction of its distance, proven. A pair that starts within the minimum separation keeps all of its distance
        but a millionth, or none of its vertices moves.
    fractions : array of float64, shape (n,)
        The fraction of its way that each vertex goes, in [0, 1]; 1 for vertices that take no part in contacts.
        ``start + fraction * (end - start)``, rounded, may differ from `positions`.
    is_free : bool
        Whether the way to `positions` is free of contacts. False if some pair touches, or is within the minimum
        separation, at the start and is not ignored.
    """

    positions: Doubles
    fractions: Doubles
    is_free: bool
