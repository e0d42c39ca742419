"""The answer to an audit."""

from __future__ import annotations

from typing import Any

from tamis import _core
from tamis._audit._tables import AuditFrame, AuditFrames, AuditPairs, ObjectNames


class AuditReport:
    """What was found in a motion, frame by frame. It owns its memory."""

    __slots__ = ("_facts", "_report", "frames", "pairs")

    frames: AuditFrames
    pairs: AuditPairs

    def __init__(self, report: _core.AuditReport) -> None:
        facts: dict[str, Any] = report.as_dict()
        self._report = report
        self._facts = facts
        self.frames = AuditFrames(facts["frames"], facts["names"])
        self.pairs = AuditPairs(facts["pairs"], ObjectNames(facts["segments"]))

    @property
    def is_free(self) -> bool:
        """True: no frame has an intersection and no step a contact, proven, and all could be asked about."""
        return bool(self._facts["is_free"])

    @property
    def first_bad(self) -> AuditFrame | None:
        """The first frame in which something was found, or at which a step with contacts ends; None if there is none."""
        bad = self.frames.is_bad.nonzero()[0]
        return self.frames[int(bad[0])] if len(bad) else None

    @property
    def steps(self) -> AuditFrames:
        """The rows of `frames` at which a step ends that was asked about."""
        return self.frames[self.frames.has_step]

    @property
    def problems(self) -> dict[int, str]:
        """Frames that could not be asked about, and why."""
        return {frame: text for frame, text in enumerate(self._facts["problems"]) if text}

    @property
    def notes(self) -> dict[int, str]:
        """What else a reader should know, by frame: the topology changes there, frames are missing before it."""
        return {frame: text for frame, text in enumerate(self._facts["notes"]) if text}

    @property
    def pairs_left_out(self) -> int:
        """Pairs that were found and counted, but are not listed in `pairs`: see `listed_pairs`."""
        return int(self._facts["pairs_left_out"])

    @property
    def ring_limit(self) -> int:
        """How far paths between features were searched, in edges."""
        return int(self._facts["ring_limit"])

    @property
    def rings(self) -> dict[int, int]:
        """All pairs, those that are not listed too, by the edges between their features: as `AuditPair.rings`."""
        *connected, apart = self._facts["by_rings"]
        return {rings: count for rings, count in [*enumerate(connected, 1), (-1, apart)] if count}

    def __repr__(self) -> str:
        frames, steps = len(self.frames), len(self.steps)
        found = f"{len(self.pairs) + self.pairs_left_out} pairs" if len(self.pairs) else "nothing found"
        return f"AuditReport({frames} frames, {steps} steps, {found}{', free' if self.is_free else ''})"
