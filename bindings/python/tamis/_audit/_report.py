"""The report of an audit."""

from __future__ import annotations

import os
from typing import Any

from tamis import _core
from tamis._audit._tables import AuditFrame, AuditFrames, AuditPairs, FrameNames, ObjectNames
from tamis._checks import file_name
from tamis._errors import Error
from tamis._pages import Page, place_for_page, show


class AuditReport:
    """The findings in a motion, frame by frame. They own their memory."""

    __slots__ = {
        "_facts": "What the compiled part has found.",
        "_report": "The compiled part's report.",
        "frames": "`AuditFrames`: one row a frame.",
        "pairs": "`AuditPairs`: the intersections and contacts, the first `listed_pairs` of them.",
    }

    frames: AuditFrames
    pairs: AuditPairs

    def __init__(self, report: _core.AuditReport) -> None:
        facts: dict[str, Any] = report.as_dict()
        self._report = report
        self._facts = facts
        self.frames = AuditFrames(facts["frames"], FrameNames(facts["names"]))
        self.pairs = AuditPairs(facts["pairs"], ObjectNames(facts["segments"]))

    @property
    def is_free(self) -> bool:
        """Whether all frames could be used, and no intersections and contacts were found. True is a proof.

        If `intersections` or `contacts` was False, it says nothing about these.
        """
        return bool(self._facts["is_free"])

    @property
    def first_bad(self) -> AuditFrame | None:
        """The first frame that has an intersection, or at which a step with contacts ends; None if there is none."""
        bad = self.frames.is_bad.nonzero()[0]
        return self.frames[int(bad[0])] if len(bad) else None

    @property
    def first_new(self) -> AuditFrame | None:
        """The first frame with a pair that the frame before does not have; None if there is none."""
        new = self.frames.new.nonzero()[0]
        return self.frames[int(new[0])] if len(new) else None

    @property
    def steps(self) -> AuditFrames:
        """The rows of `frames` that have a step: the step from the frame before was tested."""
        return self.frames[self.frames.has_step]

    @property
    def problems(self) -> dict[int, str]:
        """Why frames could not be used, by the number of the frame."""
        return {frame: text for frame, text in enumerate(self._facts["problems"]) if text}

    @property
    def notes(self) -> dict[int, str]:
        """Other remarks, by the number of the frame: the topology changes there, or frames are missing before it."""
        return {frame: text for frame, text in enumerate(self._facts["notes"]) if text}

    @property
    def pairs_left_out(self) -> int:
        """The number of pairs that were counted but are not in `pairs`, as there are more than `listed_pairs`."""
        return int(self._facts["pairs_left_out"])

    @property
    def ring_limit(self) -> int:
        """The largest number of edges for which paths between features were searched."""
        return int(self._facts["ring_limit"])

    @property
    def rings(self) -> dict[int, int]:
        """The number of pairs with each value of `AuditPair.rings`, pairs that are not listed included."""
        *connected, apart = self._facts["by_rings"]
        return {rings: count for rings, count in [*enumerate(connected, 1), (-1, apart)] if count}

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a page or a table, as the command's `--out` does. If that fails, no file is left.

        Parameters
        ----------
        path : path_like
            The extension decides. ``.html``: the page of `view`. ``.csv``: a table of `pairs`, with the columns frame,
            kind, v0, ..., v4, toi_lower, toi_upper, object_a, object_b, rings, new.

        Raises
        ------
        FileError
            The file cannot be written, or there is no frame that a page could show.
        Error
            The name has another extension.
        """
        name = file_name(path, "path")
        if name.lower().endswith(".html"):
            self._report.write_page(name)
        elif name.lower().endswith(".csv"):
            self._report.write_pairs(name)
        else:
            raise Error(f"{name}: let the name end in .html, for a page, or in .csv, for a table of the pairs")

    def view(self, path: str | os.PathLike[str] | None = None) -> Page:
        """Show the findings on the page that `tamis audit` writes: a strip of all frames, bad ones marked.

        A notebook shows the page below the cell; elsewhere it opens in the browser. It has all frames if they need no
        more than the `page_bytes` of the audit; else the bad ones, and some of the others.

        Parameters
        ----------
        path : path_like, optional
            The name of the page, which ends in ``.html``; by default in a new folder among the temporary files.

        Returns
        -------
        Page
            Its `path` is the file, which works alone.

        Raises
        ------
        FileError, Error
            As in `save`.
        """
        place = place_for_page(path)
        self.save(place)
        return show(place)

    def __reduce__(self) -> Any:
        raise TypeError("an AuditReport cannot be pickled: pickle its `frames` and its `pairs`, or save() it")

    def __repr__(self) -> str:
        frames, steps, first = len(self.frames), len(self.steps), self.first_bad
        found = f"{self.frames.intersections.sum()} intersections, {self.frames.contacts.sum()} contacts"
        not_tested = f", frames that could not be tested: {len(self.problems)}" if self.problems else ""
        verdict = "free" if self.is_free else "not free" if first else "not proven free"
        at = f", first bad frame {first.frame} ({first.name})" if first else ""
        return f"AuditReport({frames} frames, {steps} steps: {verdict}, {found}{at}{not_tested})"
