# SPDX-License-Identifier: GPL-3.0-or-later
"""Simulates anew, at a higher quality, what a check finds bad: from some frames before until some frames after it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from .checking import Check
from .cloths import Cloth, cloths_of
from .library import Trouble

_BACK, _CALM = 3, 3  # frames


class Repair(Check):
    """A check that goes back where a frame is bad: `findings` has what stays bad even so."""

    def __init__(
        self, scene: Any, objects: list[Any], frames: range, separation: float, rings: int, better: tuple[int, int]
    ) -> None:
        super().__init__(scene, objects, frames, separation, rings)
        self._cloths: list[Cloth] = cloths_of(objects, frames, better)
        if not self._cloths:
            raise Trouble("no cloth is selected: select what is to be simulated anew, and what it must not pass through")
        self._better: set[int] = set()

    def run(self, view_layer: Any) -> Iterator[int]:
        """Ask about one frame after the other, and of some again."""
        frame = self._frames[0]
        while frame <= self._frames[-1]:
            self._go_to(frame, view_layer)
            yield frame
            start = self._start_before(frame) if frame in self.findings.bad else None
            if start is None:
                frame += 1
                continue
            self._improve(range(start + 1, frame + _CALM + 1), start)
            self._go_to(start, view_layer)
            frame = start + 1

    def _start_before(self, frame: int) -> int | None:
        """Return a free frame to simulate from, the farther back the more often it was tried.

        None once a frame stayed bad with everything before it of the higher quality.
        """
        if len(self.findings.bad) > 1:
            return None
        back = _BACK
        while frame - back >= self._frames[0] and frame - back + 1 in self._better:
            back *= 2
        start = max(self._frames[0], frame - back)
        return start if set(range(start + 1, frame + 1)) - self._better else None

    def _improve(self, frames: range, start: int) -> None:
        self._better |= set(frames)
        for cloth in self._cloths:
            cloth.improve(frames)
            cloth.forget_after(start)
        self.go_back(start)
        self.findings.better = len(self._better & set(self._frames))
