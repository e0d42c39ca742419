# SPDX-License-Identifier: GPL-3.0-or-later
"""Run by picture.sh in Blender's window: simulates a cloth that passes through a torus, checks it, shows a bad frame.

Writes FOLDER/shown once the frame is on the screen, waits while picture.sh opens the tab, then takes the picture and
writes FOLDER/taken.
"""

import pathlib
import sys

import bpy

zip_file, folder = sys.argv[sys.argv.index("--") + 1 :][:2]
FRAMES = 50
folder = pathlib.Path(folder)


def cloth():
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=36, y_subdivisions=36, size=2, location=(0, 0, 1))
    thing = bpy.context.object
    thing.name = "cloth"
    modifier = thing.modifiers.new("cloth", "CLOTH")
    modifier.settings.quality = 2  # few steps a frame, so that the cloth soon passes through the torus
    modifier.point_cache.frame_end = FRAMES
    collision = modifier.collision_settings
    collision.use_collision = collision.use_self_collision = True
    collision.collision_quality = 1
    collision.distance_min = collision.self_distance_min = 0.005
    return thing


def torus():
    bpy.ops.mesh.primitive_torus_add(
        major_radius=0.5, minor_radius=0.2, location=(0, 0, 0.3), rotation=(1.2, 0, 0)
    )
    thing = bpy.context.object
    thing.name = "torus"
    thing.modifiers.new("collision", "COLLISION")
    thing.keyframe_insert("rotation_euler", frame=12)
    thing.rotation_euler[2] = 6.0
    thing.keyframe_insert("rotation_euler", frame=FRAMES)
    return thing


def simulate():
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    things = cloth(), torus()
    bpy.context.scene.frame_end = FRAMES
    for frame in range(1, FRAMES + 1):
        bpy.context.scene.frame_set(frame)
    for thing in things:
        thing.select_set(True)
    bpy.context.view_layer.objects.active = things[0]


def show():
    space = next(a for a in bpy.context.window_manager.windows[0].screen.areas if a.type == "VIEW_3D").spaces.active
    space.show_region_ui = True
    space.region_3d.view_distance = 3.2
    space.region_3d.view_location = (0, 0, 0.35)
    checked = bpy.context.scene.tamis_check
    checked.active = min(4, len(checked.bad) - 1)
    (folder / "shown").touch()
    bpy.app.timers.register(take, first_interval=12)


def take():
    bpy.ops.screen.screenshot(filepath=str(folder / "blender.png"))
    (folder / "taken").touch()


bpy.ops.preferences.addon_install(filepath=zip_file, overwrite=True)
bpy.ops.preferences.addon_enable(module="tamis_check")
bpy.context.preferences.view.show_splash = False
simulate()
bpy.ops.tamis.check_cache()
bpy.app.timers.register(show, first_interval=4)
