# SPDX-License-Identifier: GPL-3.0-or-later
"""The user's settings and the list of findings, which are kept with the scene."""

from __future__ import annotations

from typing import Any

import bpy

from . import results


def _show(rows: Any, context: Any) -> None:
    """Show the frame of the row that was clicked."""
    if 0 <= rows.active < len(rows.bad):
        results.show(context, rows.bad[rows.active].frame)


class TamisBadFrame(bpy.types.PropertyGroup):
    """A row of the list of bad frames."""

    frame: bpy.props.IntProperty()
    text: bpy.props.StringProperty()


class TamisSettings(bpy.types.PropertyGroup):
    """The settings and findings of a scene."""

    min_separation: bpy.props.FloatProperty(
        name="Minimum separation",
        description="What comes as near as this is a contact; 0: only what touches",
        min=0.0,
        subtype="DISTANCE",
    )
    rings: bpy.props.IntProperty(
        name="Ignore rings",
        description="Leave out pairs that so many edges of the mesh or fewer lead from one to the other; 0: none",
        min=0,
        max=1000,
    )
    key: bpy.props.StringProperty()  # of what was found
    summary: bpy.props.StringProperty()
    bad: bpy.props.CollectionProperty(type=TamisBadFrame)
    active: bpy.props.IntProperty(update=_show, default=-1)


_register, _unregister = bpy.utils.register_classes_factory((TamisBadFrame, TamisSettings))


def register() -> None:
    """Add the classes and the scene's property to Blender."""
    _register()
    bpy.types.Scene.tamis_check = bpy.props.PointerProperty(type=TamisSettings)


def unregister() -> None:
    """Remove them from Blender."""
    del bpy.types.Scene.tamis_check
    _unregister()
