# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the add-on run inside Blender: ``blender -b --python caches.py -- ZIP ANSWER``, or with bpy.

Installs ZIP, checks several selections, and writes the results to ANSWER as JSON.
"""

import json
import pathlib
import sys

import bpy

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from making import chosen_faces, facts, fresh, linked, mesh, said, select, sheet_that_falls_through_the_ground, wire  # noqa: E402

zip_file, answer = sys.argv[sys.argv.index("--") + 1 :][:2]


def unread():
    """Return two objects that show meshes of others (instancers), and two that show nothing: a lamp, a plain empty."""
    group = bpy.data.collections.new("group")
    group.objects.link(mesh("grouped", [(-1, -1, 0), (1, -1, 0), (0, 1, 0)], [(0, 1, 2)]))
    whole = linked("whole", None)
    whole.instance_type, whole.instance_collection = "COLLECTION", group
    many = mesh("many", [(0, 0, 0)], [])
    mesh("one of many", [(-1, -1, 0), (1, -1, 0), (0, 1, 0)], [(0, 1, 2)]).parent = many
    many.instance_type = "VERTS"
    return whole, many, linked("lamp", bpy.data.lights.new("lamp", "POINT")), linked("plain", None)


def imported_as_alembic(things):
    """Export objects to an Alembic file; return the objects that Blender imports from it."""
    file, before = str(pathlib.Path(answer).with_suffix(".abc")), set(bpy.context.scene.objects)
    select(*things)
    bpy.ops.wm.alembic_export(filepath=file, selected=True, start=1, end=12)
    bpy.ops.wm.alembic_import(filepath=file, set_frame_range=False)
    return [thing for thing in set(bpy.context.scene.objects) - before if thing.type == "MESH"]


def main():
    fresh(zip_file)
    ground, sheet = sheet_that_falls_through_the_ground()
    from tamis_check import drawing, results

    scene, seen = bpy.context.scene, {"version": bpy.app.version_string}
    scene.timeline_markers.new("mine", frame=3)
    scene.frame_set(2)
    select(ground, sheet)
    seen["check"] = said(bpy.ops.tamis.check_cache)
    seen["both"] = facts(scene)
    scene.tamis_check.active = 1
    seen["shown"] = {"frame": scene.frame_current, "sheet": chosen_faces(sheet), "ground": chosen_faces(ground)}
    bad = results.bad_frame(scene, 6)
    seen["drawn"] = [len(drawing.lines_of(bad, True)), len(drawing.lines_of(bad, False)), len(drawing.points_of(bad))]
    select(sheet)
    said(bpy.ops.tamis.check_cache)
    seen["alone"] = facts(scene)
    select()
    seen["nothing"] = said(bpy.ops.tamis.check_cache)
    select(wire(), sheet)
    said(bpy.ops.tamis.check_cache)
    seen["wire"] = facts(scene)
    seen["wire shown"] = said(bpy.ops.tamis.show_frame, frame=6)
    select(*unread(), sheet)
    said(bpy.ops.tamis.check_cache)
    seen["unread"] = facts(scene)
    select(ground, sheet)
    scene.tamis_check.min_separation = 0.3
    said(bpy.ops.tamis.check_cache)
    seen["separated"] = facts(scene)
    scene.tamis_check.min_separation = 0
    select(*imported_as_alembic([ground, sheet]))
    said(bpy.ops.tamis.check_cache)
    seen["alembic"] = facts(scene)
    select(ground, sheet)
    modifier = sheet.modifiers.new("sub", "SUBSURF")
    modifier.levels = 0
    for frame, levels in ((1, 0), (8, 1)):
        modifier.levels = levels
        modifier.keyframe_insert("levels", frame=frame)
    said(bpy.ops.tamis.check_cache)
    seen["notes"] = results.notes(scene)
    said(bpy.ops.tamis.clear)
    seen["cleared"] = facts(scene)
    bpy.ops.preferences.addon_disable(module="tamis_check")
    seen["gone"] = not hasattr(bpy.types.Scene, "tamis_check")
    with open(answer, "w") as file:
        json.dump(seen, file)


main()
