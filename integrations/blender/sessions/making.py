# SPDX-License-Identifier: GPL-3.0-or-later
"""What the sessions of the add-on's tests make in Blender, and how they ask it."""

import addon_utils
import bpy


def fresh(zip_file):
    """Start with an empty file, and the add-on."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    if not any(module.__name__ == "tamis_check" for module in addon_utils.modules()):
        bpy.ops.preferences.addon_install(filepath=zip_file)
    bpy.ops.preferences.addon_enable(module="tamis_check")
    bpy.context.scene.frame_start, bpy.context.scene.frame_end = 1, 12


def mesh(name, corners, faces):
    data = bpy.data.meshes.new(name)
    data.from_pydata(corners, [], faces)
    thing = bpy.data.objects.new(name, data)
    bpy.context.collection.objects.link(thing)
    return thing


def sheet_that_falls_through_the_ground():
    ground = mesh("ground", [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], [(0, 1, 2, 3)])
    side = range(4)
    corners = [(0.25 * x - 0.4, 0.25 * y - 0.4, 0) for y in side for x in side]
    faces = [(4 * y + x, 4 * y + x + 1, 4 * y + x + 5, 4 * y + x + 4) for y in range(3) for x in range(3)]
    sheet = mesh("sheet", corners, faces)
    sheet.rotation_euler = (0.3, 0.2, 0)
    for frame, height in ((1, 1), (11, -1)):
        sheet.location = (0, 0, height)
        sheet.keyframe_insert("location", frame=frame)
    return ground, sheet


def linked(name, data):
    thing = bpy.data.objects.new(name, data)
    bpy.context.collection.objects.link(thing)
    return thing


def wire():
    """A curve with a thickness, in the sheet's way."""
    data = bpy.data.curves.new("wire", "CURVE")
    data.dimensions, data.bevel_depth = "3D", 0.2
    ends = data.splines.new("POLY").points
    ends.add(1)
    ends[0].co, ends[1].co = (-2, 0, 0, 1), (2, 0, 0, 1)
    return linked("wire", data)


def select(*things):
    for thing in bpy.context.scene.objects:
        thing.select_set(thing in things)


def said(operator, **options):
    """Its answer, or its sentence."""
    try:
        return sorted(operator(**options))
    except RuntimeError as error:
        return str(error)


def facts(scene):
    rows = [(row.frame, row.text) for row in scene.tamis_check.bad]
    markers = sorted((marker.frame, marker.name) for marker in scene.timeline_markers)
    return {"summary": scene.tamis_check.summary, "rows": rows, "markers": markers, "frame": scene.frame_current}


def chosen_faces(thing):
    return [face.index for face in thing.data.polygons if face.select]
