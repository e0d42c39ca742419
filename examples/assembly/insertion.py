import pathlib

import numpy as np
import trimesh

import tamis

# a servo motor and the printed base of the arm SO-101, from the package example-robot-data, in metres
folder = pathlib.Path(trimesh.__file__).parents[1] / "cmeel.prefix/share/example-robot-data/robots/so_arm_description"


def part(name, size=1.0):
    mesh = trimesh.load(folder / "meshes/so101" / name)
    middle = mesh.bounds.mean(0)
    return tamis.Shape(tamis.Mesh(mesh.faces), middle + size * (mesh.vertices - middle))


seat = tamis.pose_of([0, 0, 0.0], [0.0263353, 0, 0.0437])
world = tamis.World()
world.add(part("base_so101_v2.stl"), tamis.pose_of(np.full(3, 2 * np.pi / 27**0.5), [-0.00636471, 0, -0.0024]))
for size in (1.0, 0.985):
    for name, way in (("front", [0.08, 0, 0]), ("side", [0, 0.08, 0]), ("top", [0, 0, 0.08])):
        motor = world.add(part("sts3215_03a_v1.stl", size), tamis.interpolated_chain(seat + [way, [0, 0, 0]], seat))
        first = world.earliest()
        left = 80 * (1 - first.toi_lower)
        found = "proven free" if first.contact is None else f"jams {left:.2f} mm before its seat"
        print(f"at {100 * size:g}% of its size, from the {name}: {found}")
        world.remove(motor)
