# SPDX-License-Identifier: GPL-3.0-or-later
"""As caches.py: scenes that change from frame to frame, while they are checked, or afterwards."""

import json
import pathlib
import sys

import bpy

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from making import chosen_faces, facts, fresh, linked, mesh, said, select, sheet_that_falls_through_the_ground  # noqa: E402

zip_file, answer = sys.argv[sys.argv.index("--") + 1 :][:2]
seen = {}


def falling():
    fresh(zip_file)
    things = sheet_that_falls_through_the_ground()
    select(*things)
    return things


def checked():
    from tamis_check import results

    said_of_it = said(bpy.ops.tamis.check_cache)
    return {**facts(bpy.context.scene), "said": said_of_it, "notes": results.notes(bpy.context.scene)}


def hidden_from_a_frame_on():
    ground, sheet = falling()
    for frame, is_hidden in ((1, False), (5, True)):
        sheet.hide_viewport = is_hidden
        sheet.keyframe_insert("hide_viewport", frame=frame)
    bpy.context.scene.frame_set(1)
    select(ground, sheet)  # hiding has deselected it
    return checked()


def nodes_that_make(kind):
    """A tree of geometry nodes: of a mesh it makes a cube on each vertex, or a curve."""
    tree = bpy.data.node_groups.new(kind, "GeometryNodeTree")
    if hasattr(tree, "interface"):
        tree.interface.new_socket("In", in_out="INPUT", socket_type="NodeSocketGeometry")
        tree.interface.new_socket("Out", in_out="OUTPUT", socket_type="NodeSocketGeometry")
    else:  # before Blender 4.0
        tree.inputs.new("NodeSocketGeometry", "In")
        tree.outputs.new("NodeSocketGeometry", "Out")
    given, made = tree.nodes.new("NodeGroupInput"), tree.nodes.new("NodeGroupOutput")
    if kind == "curve":
        last = tree.nodes.new("GeometryNodeCurvePrimitiveCircle")
    else:
        last, cube = tree.nodes.new("GeometryNodeInstanceOnPoints"), tree.nodes.new("GeometryNodeMeshCube")
        tree.links.new(given.outputs[0], last.inputs["Points"])
        tree.links.new(cube.outputs[0], last.inputs["Instance"])
    tree.links.new(last.outputs[0], made.inputs[0])
    return tree


def made_by_nodes(kind):
    _, sheet = falling()
    maker = mesh("maker", [(0, 0, 0)], [])
    maker.modifiers.new("nodes", "NODES").node_group = nodes_that_make(kind)
    select(maker, sheet)
    return checked()


def born_later():
    _, sheet = falling()
    emitter = mesh("emitter", [(-1, -1, 2), (1, -1, 2), (0, 1, 2)], [(0, 1, 2)])
    emitter.modifiers.new("particles", "PARTICLE_SYSTEM")
    settings = emitter.particle_systems[0].settings
    settings.frame_start, settings.frame_end, settings.count, settings.lifetime = 4, 6, 20, 50
    settings.render_type = "OBJECT"
    settings.instance_object = mesh("drop", [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
    select(emitter, sheet)
    return checked()


def removed_in_a_frame():
    falling()

    def remove(scene, *_):
        if scene.frame_current == 5 and "ground" in bpy.data.objects:
            bpy.data.objects.remove(bpy.data.objects["ground"])

    bpy.context.scene.frame_set(2)
    bpy.app.handlers.frame_change_post.append(remove)
    try:
        return checked()
    finally:
        bpy.app.handlers.frame_change_post.remove(remove)


def undone_in_a_frame():
    falling()
    bpy.ops.ed.undo_push(message="falling")
    linked("nothing", None)
    bpy.ops.ed.undo_push(message="nothing")
    from tamis_check.checking import Check

    check = Check(bpy.context, range(1, 13), 0, 0)
    for frame in check.run():
        if frame == 4:
            bpy.ops.ed.undo()
    return str(check.findings)


def built_from_a_frame_on():
    _, sheet = falling()
    build = sheet.modifiers.new("build", "BUILD")
    build.frame_start, build.frame_duration = 3, 2
    return checked()


def without_faces():
    fresh(zip_file)
    select(mesh("points", [(0, 0, 0), (1, 0, 0)], []))
    return checked()


def another_file():
    from tamis_check import results

    falling()
    checked()
    fresh(zip_file)
    return results.bad_frame(bpy.context.scene, 6) is not None


def undone_afterwards():
    falling()
    bpy.ops.ed.undo_push(message="falling")
    bpy.ops.tamis.check_cache("EXEC_DEFAULT", True)
    linked("nothing", None)
    bpy.ops.ed.undo_push(message="nothing")
    bpy.ops.ed.undo()
    return facts(bpy.context.scene)


def two_objects_of_one_mesh():
    """A long strip across the ground's edge, and its copy elsewhere: each touches with another face."""
    fresh(zip_file)
    ground = mesh("ground", [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], [(0, 1, 2, 3)])
    corners = [(x, 0.1 * y, -0.5 + 0.1 * y) for x in (0, 4, 8) for y in (0, 10)]
    left = mesh("left", corners, [(0, 1, 3, 2), (2, 3, 5, 4)])
    right = linked("right", left.data)
    left.location, right.location = (0.1, 0, 0), (-7.9, 0.3, 0.1)
    apart = mesh("apart", [(20, 0, 0), (21, 0, 0), (20, 1, 0)], [(0, 1, 2)])
    select(ground, left, right, apart)
    bpy.context.scene.frame_end = 1
    answers = checked()
    bpy.ops.tamis.show_frame(frame=1)
    return {**answers, "left": chosen_faces(left), "apart": chosen_faces(apart)}


def of_one_name():
    falling()
    library = str(pathlib.Path(answer).with_suffix(".blend"))
    bpy.data.objects["ground"].name = "other"
    bpy.data.objects["sheet"].name = "ground"
    bpy.data.libraries.write(library, {bpy.data.objects["other"]})
    bpy.data.objects["other"].name = "free"
    with bpy.data.libraries.load(library, link=True) as (_, wanted):
        wanted.objects = ["other"]
    bpy.data.objects["ground"].name = "other"
    select()
    for thing in [*wanted.objects, bpy.data.objects["other"]]:
        if thing.name_full not in bpy.context.scene.objects:
            bpy.context.collection.objects.link(thing)
    select(*wanted.objects, next(thing for thing in bpy.data.objects if thing.name_full == "other"))
    return checked()


def main():
    seen["hidden"] = hidden_from_a_frame_on()
    seen["instances"] = made_by_nodes("instances")
    seen["curve"] = made_by_nodes("curve")
    seen["born"] = born_later()
    seen["removed"] = removed_in_a_frame()
    seen["undone in a frame"] = undone_in_a_frame()
    seen["built"] = built_from_a_frame_on()
    seen["without faces"] = without_faces()
    seen["another file"] = another_file()
    seen["undone afterwards"] = undone_afterwards()
    seen["one mesh"] = two_objects_of_one_mesh()
    seen["one name"] = of_one_name()
    with open(answer, "w") as file:
        json.dump(seen, file)


main()
