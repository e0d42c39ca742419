# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel in the sidebar of the 3D view."""

from __future__ import annotations

from typing import Any

import bpy


class TAMIS_UL_bad_frames(bpy.types.UIList):  # noqa: N801: Blender wants this form
    """The list of bad frames; a click on a row shows its frame."""

    def draw_item(
        self, context: Any, layout: Any, data: Any, item: Any, icon: Any, active_data: Any, active_property: Any
    ) -> None:
        """Draw a row."""
        layout.label(text=f"{item.frame}   {item.text}", icon="ERROR")


class TAMIS_PT_check(bpy.types.Panel):  # noqa: N801
    """The panel: options, the button, the list."""

    bl_label = "Check this cache"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Tamis"

    def draw(self, context: Any) -> None:
        """Draw the panel."""
        settings, layout = context.scene.tamis_check, self.layout
        layout.prop(settings, "min_separation")
        layout.prop(settings, "rings")
        layout.prop(context.scene, "frame_start")
        layout.prop(context.scene, "frame_end")
        layout.operator("tamis.check_cache", icon="VIEWZOOM")
        if settings.summary:
            for part in settings.summary.split(", "):
                layout.label(text=part)
            layout.template_list("TAMIS_UL_bad_frames", "", settings, "bad", settings, "active", rows=5)
            layout.operator("tamis.clear", icon="X")


_CLASSES = (TAMIS_UL_bad_frames, TAMIS_PT_check)

register, unregister = bpy.utils.register_classes_factory(_CLASSES)
