# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks a cache for intersections and contacts; marks bad frames on the timeline, selects faces and draws pairs."""

bl_info = {
    "name": "Tamis: check this cache",
    "author": "The Tamis authors",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "View3D > Sidebar > Tamis",
    "description": "Finds the frames in which meshes pass through themselves or each other, and proves the others free",
    "category": "Physics",
}

from . import drawing, operators, panel, settings  # noqa: E402

_PARTS = (settings, operators, panel, drawing)


def register() -> None:
    """Add the add-on to Blender."""
    for part in _PARTS:
        part.register()


def unregister() -> None:
    """Remove the add-on from Blender."""
    for part in reversed(_PARTS):
        part.unregister()
