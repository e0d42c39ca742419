"""The report of an attachment."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass
class AttachmentReport:
    """Counts and times since `attach`.

    Attributes
    ----------
    steps : int
        The number of steps of the solver.
    shortened : int
        How often vertices were held back because they would have touched others or come too near.
    moved_into_contact : int
        The number of steps that start with an intersection, or before which the caller moved vertices, such as pinned
        ones, through others.
    detection_seconds, truncation_seconds : float
        Wall-clock time spent on finding near pairs, and on finding where vertices may go.
    """

    steps: int = 0
    shortened: int = 0
    moved_into_contact: int = 0
    detection_seconds: float = 0.0
    truncation_seconds: float = 0.0
