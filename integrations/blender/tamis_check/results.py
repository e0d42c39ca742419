# SPDX-License-Identifier: GPL-3.0-or-later
"""Shows the findings: markers on the timeline, rows of the list, selected faces."""

from __future__ import annotations

import uuid
from typing import Any

import numpy as np

from .checking import BadFrame, Findings

_PREFIX = "Tamis: "
# By the key that the scene keeps, which undoing brings back, too; what is drawn is too much to keep in the file.
_found: dict[str, Findings] = {}


def publish(scene: Any, findings: Findings) -> None:
    """Show these findings in place of those before."""
    clear(scene)
    settings = scene.tamis_check
    settings.key = uuid.uuid4().hex
    _found[settings.key] = findings
    settings.summary = str(findings)
    for frame in sorted(findings.bad):
        row = settings.bad.add()
        row.frame, row.text = frame, str(findings.bad[frame])
        scene.timeline_markers.new(f"{_PREFIX}{findings.bad[frame]}"[:63], frame=frame)


def clear(scene: Any) -> None:
    """Forget what was found; the user's own markers stay."""
    _found.pop(scene.tamis_check.key, None)
    scene.tamis_check.key = scene.tamis_check.summary = ""
    scene.tamis_check.bad.clear()
    for marker in [m for m in scene.timeline_markers if m.name.startswith(_PREFIX)]:
        scene.timeline_markers.remove(marker)


def bad_frame(scene: Any, frame: int) -> BadFrame | None:
    """What was found in a frame, if it was bad."""
    findings = _found.get(scene.tamis_check.key)
    return findings.bad.get(frame) if findings else None


def notes(scene: Any) -> list[str]:
    """What else the last check had to say."""
    findings = _found.get(scene.tamis_check.key)
    return findings.notes if findings else []


def show(context: Any, frame: int) -> str:
    """Go to a frame and select the faces of its pairs; return a sentence about faces that cannot be selected, or ''."""
    context.scene.frame_set(frame)
    bad = bad_frame(context.scene, frame)
    if bad is None:
        return f"frame {frame} was not checked since this file was opened, or is free: check it again"
    if context.mode != "OBJECT":
        return "faces are selected in object mode alone: leave edit mode and show the frame again"
    return _select(context.scene, bad.faces)


def _select(scene: Any, faces_of: dict[str, np.ndarray]) -> str:
    """These and no others, of all objects that were checked; what modifiers have made anew has no faces to select."""
    things = {thing.name_full: thing for thing in scene.objects}
    chosen: dict[Any, list[np.ndarray]] = {}  # by mesh, which objects may share
    said = []
    for name, faces in faces_of.items():
        mesh = things[name].data if name in things and things[name].type == "MESH" else None
        if mesh is not None and not (len(faces) and faces[-1] >= len(mesh.polygons)):
            chosen.setdefault(mesh, []).append(faces)
        elif len(faces):
            said.append(f"{name} has other faces than its modifiers make: its pairs are drawn.")
    for mesh, faces in chosen.items():
        _select_faces(mesh, np.concatenate(faces))
    return " ".join(said)


def _select_faces(mesh: Any, faces: np.ndarray) -> None:
    sides = {side for face in faces.tolist() for side in mesh.polygons[face].edge_keys}
    corners = [vertex for side in sides for vertex in side]
    _set_selected(mesh, "poly", mesh.polygons, np.isin(np.arange(len(mesh.polygons)), faces))
    _set_selected(mesh, "edge", mesh.edges, np.array([edge.key in sides for edge in mesh.edges], bool))
    _set_selected(mesh, "vert", mesh.vertices, np.isin(np.arange(len(mesh.vertices)), corners))
    mesh.update()


def _set_selected(mesh: Any, kind: str, things: Any, chosen: np.ndarray) -> None:
    """Replace a selection, removing the old one: Blender 5.0.1 crashes on writing to one that it stores as one value."""
    old = mesh.attributes.get(f".select_{kind}")
    if old:
        mesh.attributes.remove(old)
    things.foreach_set("select", chosen)
