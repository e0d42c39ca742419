"""What is said of a whole step."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from tamis._arrays import Doubles
from tamis._contacts import Contact, PairKind

if TYPE_CHECKING:
    from tamis import _core


class EarliestContact(NamedTuple):
    """How far the step may go.

    Attributes
    ----------
    toi_lower : float
        The motion is free on [0, toi_lower): proven. 1 if the whole step is free.
    toi_upper : float
        A certified contact happens at or before this fraction of the step; 1 if none is certified.
    contact : Contact or None
        The contact that bounds the step first; None if the step is free.
    """

    toi_lower: float
    toi_upper: float
    contact: Contact | None


class LimitingPair(NamedTuple):
    """The pair of features that ends a step; `distance` is its own at the start, rounded."""

    kind: PairKind
    vertices: tuple[int, int, int, int]
    distance: float


class SafeStep(NamedTuple):
    """How far the step may go so that every pair keeps a fraction of its distance.

    Attributes
    ----------
    lower : float
        On [0, lower] every pair keeps at least the fraction, and on [0, lower) none touches: proven. 1 if the whole
        step may go.
    upper : float
        At this time some pair has no more than the fraction left: proven; 1 if that is not known of any time.
    pair : LimitingPair or None
        The pair that ends the step; None if the whole step may go.
    """

    lower: float
    upper: float
    pair: LimitingPair | None


def safe_step(found: _core._SafeStep) -> SafeStep:
    """Give what the compiled part has found its names."""
    lower, upper, pair = found
    return SafeStep(lower, upper, None if pair is None else LimitingPair(PairKind(pair[0]), *pair[1:]))


class VertexSteps(NamedTuple):
    """How far each vertex may go.

    Attributes
    ----------
    together : float
        Until here all vertices may go together, at one time of the step: what `Detector.keep_distance` says.
    until : array, shape (n,)
        Of each vertex, in [together, 1]. From where all are at `together`, every vertex may go, at a pace of its own,
        to its time or any before it, whatever the others do: no pair comes into contact. Proven, with room for
        positions that are rounded to doubles. 1 for vertices that take no part in contacts.
    """

    together: float
    until: Doubles


class TruncatedStep(NamedTuple):
    """Where a step may end.

    Attributes
    ----------
    positions : array, shape (n, 3)
        Where to go. The straight way there from the start of the step, to these very doubles, is free.
    is_free : bool
        False: not even that is proven, because something touches at the start, where `positions` then are.
    """

    positions: Doubles
    is_free: bool
