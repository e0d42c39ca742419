"""What is said of a whole step."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from tamis._arrays import Doubles
from tamis._tables._contacts import Contact, Contacts
from tamis._tables._near import NearPair, NearPairs

if TYPE_CHECKING:
    from tamis import _core


class EarliestContact(NamedTuple):
    """How far the step may go.

    Attributes
    ----------
    toi_lower : float
        The motion is free on [0, toi_lower): proven. 1 if the whole step is free.
    toi_upper : float
        A certified contact happens at or before this fraction of the step; 1 if none is certified, as may be on a path.
    contact : Contact or None
        The contact that bounds the step first; None if the step is free.
    """

    toi_lower: float
    toi_upper: float
    contact: Contact | None


def earliest_of(found: _core._Earliest) -> EarliestContact:
    """Give what the compiled part has found its names."""
    lower, upper, rows = found
    contacts = Contacts(rows)
    return EarliestContact(lower, upper, contacts[0] if len(contacts) else None)


class SafeStep(NamedTuple):
    """How far the step may go so that every pair keeps a fraction of its distance.

    Attributes
    ----------
    lower : float
        On [0, lower] every pair keeps at least the fraction, and on [0, lower) none touches: proven. 1 if the whole
        step may go.
    upper : float
        At this time some pair has no more than the fraction left: proven; 1 if that is not known of any time.
    pair : NearPair or None
        The pair that ends the step, as it is at the start; None if the whole step may go.
    """

    lower: float
    upper: float
    pair: NearPair | None


def safe_step_of(found: _core._SafeStep) -> SafeStep:
    """Give what the compiled part has found its names."""
    lower, upper, rows = found
    pairs = NearPairs(rows)
    return SafeStep(lower, upper, pairs[0] if len(pairs) else None)


class TruncatedStep(NamedTuple):
    """Where a step may end, each vertex on its own line towards its end.

    Attributes
    ----------
    positions : array, shape (n, 3)
        Where to go. On the straight way there from the start of the step, to these very doubles, every pair keeps the
        fraction of its distance: proven. A pair that starts within the minimum separation keeps all of its distance but
        a millionth, or none of its vertices moves.
    fractions : array, shape (n,)
        How much of its way each vertex goes, in [0, 1]; 1 for vertices that take no part in contacts. What
        ``start + fraction * (end - start)`` is rounded to need not be `positions`.
    is_free : bool
        The whole way is free of contacts. False: some pair touches, or is within the minimum separation, at the start.
    """

    positions: Doubles
    fractions: Doubles
    is_free: bool
