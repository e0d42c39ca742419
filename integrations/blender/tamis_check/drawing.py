# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the pairs of the present frame over the 3D view: intersections red, contacts orange."""

from __future__ import annotations

from typing import Any

import bpy
import numpy as np

from . import results
from .checking import BadFrame

_RED, _ORANGE = (1.0, 0.1, 0.1, 1.0), (1.0, 0.6, 0.0, 1.0)
_SIDES = {1: [], 2: [(0, 1)], 3: [(0, 1), (1, 2), (2, 0)]}
_handle: Any = None


def lines_of(bad: BadFrame, is_intersection: bool) -> np.ndarray:
    """Return the ends of all sides of the features of intersections, or of contacts: shape (2 n, 3)."""
    ends = [
        points[[*side]]
        for crosses, points in bad.features
        if crosses == is_intersection
        for side in _SIDES[len(points)]
    ]
    return np.vstack(ends) if ends else np.empty((0, 3))


def points_of(bad: BadFrame) -> np.ndarray:
    """Return the features that are single vertices, shape (n, 3)."""
    single = [points for _, points in bad.features if len(points) == 1]
    return np.vstack(single) if single else np.empty((0, 3))


def _draw() -> None:
    scene = bpy.context.scene
    bad = results.bad_frame(scene, scene.frame_current)
    if bad is None:
        return
    import gpu
    from gpu_extras.batch import batch_for_shader

    name = "UNIFORM_COLOR" if bpy.app.version >= (4, 0) else "3D_UNIFORM_COLOR"
    shader = gpu.shader.from_builtin(name)
    gpu.state.depth_test_set("NONE")
    gpu.state.line_width_set(2)
    gpu.state.point_size_set(6)
    batches = [("LINES", lines_of(bad, False), _ORANGE), ("LINES", lines_of(bad, True), _RED)]
    for kind, corners, colour in [*batches, ("POINTS", points_of(bad), _ORANGE)]:
        if len(corners):
            shader.bind()
            shader.uniform_float("color", colour)
            batch_for_shader(shader, kind, {"pos": corners.astype(np.float32).tolist()}).draw(shader)


def register() -> None:
    """Draw in every 3D view."""
    global _handle
    _handle = bpy.types.SpaceView3D.draw_handler_add(_draw, (), "WINDOW", "POST_VIEW")


def unregister() -> None:
    """Stop drawing."""
    bpy.types.SpaceView3D.draw_handler_remove(_handle, "WINDOW")
