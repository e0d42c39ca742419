# SPDX-License-Identifier: GPL-3.0-or-later
"""The operators behind the buttons."""

from __future__ import annotations

import time
from collections.abc import Iterator
from typing import Any

import bpy

from . import results
from .checking import Check
from .library import Trouble

_SECONDS_A_TURN = 0.1


class TamisCheckCache(bpy.types.Operator):
    """Find the intersections in each frame, and the contacts in each step between frames."""

    bl_idname = "tamis.check_cache"
    bl_label = "Check this cache"
    bl_options = {"REGISTER", "UNDO"}

    _check: Check
    _frames: Iterator[int]
    _timer: Any

    def execute(self, context: Any) -> set[str]:
        """Check all frames at once: Blender calls this from scripts."""
        if not self._begin(context):
            return {"CANCELLED"}
        return self._guarded(lambda: all(True for _ in self._frames))

    def invoke(self, context: Any, event: Any) -> set[str]:
        """Begin to check some frames at a time, until Esc: Blender calls this from the panel."""
        if not self._begin(context):
            return {"CANCELLED"}
        self._timer = context.window_manager.event_timer_add(0.01, window=context.window)
        context.window_manager.progress_begin(0, 100)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context: Any, event: Any) -> set[str]:
        """Check some more frames, or end at Esc; the findings until then stay."""
        if event.type not in {"ESC", "TIMER"}:
            return {"PASS_THROUGH"}
        done = {"CANCELLED"}
        try:
            done = self._guarded(lambda: event.type == "ESC" or self._some_frames(context))
        finally:
            if done != {"RUNNING_MODAL"}:
                context.window_manager.event_timer_remove(self._timer)
                context.window_manager.progress_end()
        return done

    def _begin(self, context: Any) -> bool:
        scene, settings = context.scene, context.scene.tamis_check
        frames = range(scene.frame_start, scene.frame_end + 1)
        self._before = scene.frame_current, scene.frame_subframe
        try:
            self._check = Check(context, frames, settings.min_separation, settings.rings)
        except Trouble as trouble:
            self.report({"ERROR"}, str(trouble))
            return False
        self._frames = self._check.run()
        return True

    def _some_frames(self, context: Any) -> bool:
        """Check frames for `_SECONDS_A_TURN`; return whether all are checked."""
        until = time.monotonic() + _SECONDS_A_TURN
        frames = self._check.frames
        for frame in self._frames:
            context.window_manager.progress_update(100 * (frame + 1 - frames.start) / len(frames))
            if time.monotonic() > until:
                return False
        return True

    def _guarded(self, go_on: Any) -> set[str]:
        """Publish once there is no more to do; Tamis' own sentences arrive as they are."""
        try:
            if not go_on():
                return {"RUNNING_MODAL"}
        except (Trouble, ValueError) as trouble:
            self.report({"ERROR"}, str(trouble))
            self._publish()
            return {"CANCELLED"}
        self._publish()
        findings = self._check.findings
        for note in findings.notes:
            self.report({"WARNING"}, note)
        self.report({"WARNING" if findings.bad or findings.left_out else "INFO"}, str(findings))
        return {"FINISHED"}

    def _publish(self) -> None:
        """In the scene that was checked, which need not be the one that the user sees by now."""
        scene = self._check.selection.scene()
        if scene is not None:
            results.publish(scene, self._check.findings)
            scene.frame_set(self._before[0], subframe=self._before[1])


class TamisShowFrame(bpy.types.Operator):
    """Go to a bad frame, and select the faces of its pairs."""

    bl_idname = "tamis.show_frame"
    bl_label = "Show this frame"
    bl_options = {"REGISTER"}

    frame: bpy.props.IntProperty(name="Frame")

    def execute(self, context: Any) -> set[str]:
        """Show the frame."""
        said = results.show(context, self.frame)
        if said:
            self.report({"WARNING"}, said)
        return {"FINISHED"}


class TamisClear(bpy.types.Operator):
    """Remove the markers and the list."""

    bl_idname = "tamis.clear"
    bl_label = "Clear"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context: Any) -> set[str]:
        """Remove them."""
        results.clear(context.scene)
        return {"FINISHED"}


_CLASSES = (TamisCheckCache, TamisShowFrame, TamisClear)

register, unregister = bpy.utils.register_classes_factory(_CLASSES)
