"""What an attachment has done."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass
class AttachmentReport:
    """Counts and seconds since `attach`.

    Attributes
    ----------
    steps : int
        That the solver has taken.
    shortened : int
        Times that positions would have led to a contact, or too near one, and were held back.
    moved_into_contact : int
        Steps before which the caller moved vertices (pinned ones, say) through others.
    detection_seconds, truncation_seconds : float
        Spent on what is near, and on where vertices may go.
    """

    steps: int = 0
    shortened: int = 0
    moved_into_contact: int = 0
    detection_seconds: float = 0.0
    truncation_seconds: float = 0.0
