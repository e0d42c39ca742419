# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks a cache for what passes through what: bad frames on the timeline, their faces selected, their pairs drawn."""

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
    """Add everything to Blender."""
    for part in _PARTS:
        part.register()


def unregister() -> None:
    """Take everything out again."""
    for part in reversed(_PARTS):
        part.unregister()
