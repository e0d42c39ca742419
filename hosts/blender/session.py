# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the add-on run inside Blender: ``blender -b --python session.py -- ZIP ANSWER``, or with bpy.

Writes what it saw as JSON.
"""

import json
import sys

import bpy

zip_file, answer = sys.argv[sys.argv.index("--") + 1 :][:2]


def mesh(name, corners, faces):
    data = bpy.data.meshes.new(name)
    data.from_pydata(corners, [], faces)
    thing = bpy.data.objects.new(name, data)
    bpy.context.collection.objects.link(thing)
    return thing


def scene_of_a_sheet_that_falls_through_the_ground():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    ground = mesh("ground", [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], [(0, 1, 2, 3)])
    side = range(4)
    corners = [(0.25 * x - 0.4, 0.25 * y - 0.4, 0) for y in side for x in side]
    faces = [(4 * y + x, 4 * y + x + 1, 4 * y + x + 5, 4 * y + x + 4) for y in range(3) for x in range(3)]
    sheet = mesh("sheet", corners, faces)
    sheet.rotation_euler = (0.3, 0.2, 0)
    for frame, height in ((1, 1), (11, -1)):
        sheet.location = (0, 0, height)
        sheet.keyframe_insert("location", frame=frame)
    bpy.context.scene.frame_start, bpy.context.scene.frame_end = 1, 12
    return ground, sheet


def scene_of_a_cloth_that_a_torus_goes_through():
    """At the quality it has; it does not at a higher one."""
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=16, y_subdivisions=16, size=2, location=(0, 0, 1))
    sheet = bpy.context.object
    cloth = sheet.modifiers.new("cloth", "CLOTH")
    cloth.settings.quality, cloth.collision_settings.collision_quality = 1, 1
    collision = cloth.collision_settings
    collision.use_self_collision = True
    collision.distance_min = collision.self_distance_min = 0.005
    bpy.ops.mesh.primitive_torus_add(major_radius=0.5, minor_radius=0.2, location=(0, 0, 0.3), rotation=(1.2, 0, 0))
    torus = bpy.context.object
    torus.modifiers.new("collision", "COLLISION")
    for frame, height in ((8, 0.3), (18, 0.8)):
        torus.location[2] = height
        torus.keyframe_insert("location", frame=frame)
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end, scene.tamis_check.min_separation = 1, 25, 0
    cloth.point_cache.frame_end = 25
    return sheet, torus, cloth


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


def repaired(scene):
    *things, cloth = scene_of_a_cloth_that_a_torus_goes_through()
    select(things[1])
    seen = {"no cloth": said(bpy.ops.tamis.repair_cache)}
    select(*things)
    seen["in memory"] = said(bpy.ops.tamis.repair_cache)
    bpy.ops.wm.save_as_mainfile(filepath=answer + ".blend")
    cloth.point_cache.use_disk_cache = True
    said(bpy.ops.tamis.check_cache)
    seen["before"] = facts(scene)["summary"]
    said(bpy.ops.tamis.repair_cache)
    seen["after"] = facts(scene)["summary"]
    said(bpy.ops.tamis.check_cache)
    seen["again"] = facts(scene)["summary"]
    return seen


def main():
    ground, sheet = scene_of_a_sheet_that_falls_through_the_ground()
    bpy.ops.preferences.addon_install(filepath=zip_file)
    bpy.ops.preferences.addon_enable(module="tamis_check")
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
    select(ground, sheet)
    scene.tamis_check.min_separation = 0.3
    said(bpy.ops.tamis.check_cache)
    seen["separated"] = facts(scene)
    modifier = sheet.modifiers.new("sub", "SUBSURF")
    modifier.levels = 0
    for frame, levels in ((1, 0), (8, 1)):
        modifier.levels = levels
        modifier.keyframe_insert("levels", frame=frame)
    said(bpy.ops.tamis.check_cache)
    seen["notes"] = results.notes(scene)
    said(bpy.ops.tamis.clear)
    seen["cleared"] = facts(scene)
    seen["repair"] = repaired(scene)
    bpy.ops.preferences.addon_disable(module="tamis_check")
    seen["gone"] = not hasattr(bpy.types.Scene, "tamis_check")
    with open(answer, "w") as file:
        json.dump(seen, file)


main()
