#!/usr/bin/env python3
"""Renders frames of `tamis scene` to pictures with POV-Ray.

usage: render_scene.py FRAME.ply PICTURE.png --from X Y Z [--at X Y Z] [--angle DEGREES] [--up y|z] [--clear N ...]
Needs the Debian packages povray and python3-numpy. Connected objects are numbered from 0 in the order of
their first vertices; each gets a colour of its own. --clear draws the objects with these numbers as glass, --hide
leaves them out.
"""
import argparse

import numpy

from render import components, read_ply, run_povray, vertex_normals

COLOURS = [(0.75, 0.22, 0.17), (0.30, 0.45, 0.62), (0.85, 0.72, 0.45), (0.42, 0.58, 0.36), (0.55, 0.45, 0.60)]


def objects_of(positions, faces):
    """Return the number of the object that each face belongs to; objects are numbered by first vertex."""
    return numpy.unique(components(len(positions), faces)[faces[:, 0]], return_inverse=True)[1]


def vectors(rows):
    return ",".join("<%.7g,%.7g,%.7g>" % tuple(r) for r in rows)


def mesh2(positions, normals, faces, texture):
    used, local = numpy.unique(faces, return_inverse=True)
    indices = ",".join("<%d,%d,%d>" % tuple(f) for f in local.reshape(-1, 3))
    return (f"mesh2 {{ vertex_vectors {{ {len(used)},{vectors(positions[used])} }}"
            f" normal_vectors {{ {len(used)},{vectors(normals[used])} }}"
            f" face_indices {{ {len(faces)},{indices} }} {texture} }}\n")


def texture_of(index, clear):
    r, g, b = COLOURS[index % len(COLOURS)]
    transmit = 0.75 if index in clear else 0
    return (f"texture {{ pigment {{ rgbt <{r},{g},{b},{transmit}> }}"
            " finish { ambient 0.12 diffuse 0.75 specular 0.12 roughness 0.05 } }")


def scene_text(arguments):
    positions, faces = read_ply(arguments.frame)
    label, normals = objects_of(positions, faces), vertex_normals(positions, faces)
    if arguments.hide:
        print("objects:", numpy.bincount(label))
    axes = [0, 1, 2] if arguments.up == "y" else [0, 2, 1]
    positions, normals = positions[:, axes], normals[:, axes]
    eye, at = (numpy.array(v)[axes] for v in (arguments.eye, arguments.at))
    sun = eye + numpy.linalg.norm(eye - at) * numpy.array([-0.8, 1.2, 0.3])
    text = "#version 3.7; global_settings { assumed_gamma 1.0 } background { rgb 1 }\n"
    text += f"camera {{ location {vectors([eye])} angle {arguments.angle} right x*image_width/image_height look_at {vectors([at])} }}\n"
    text += f"light_source {{ {vectors([sun])} rgb 0.95 }} light_source {{ {vectors([eye])} rgb 0.35 shadowless }}\n"
    for index in set(label) - set(arguments.hide):
        text += mesh2(positions, normals, faces[label == index], texture_of(index, arguments.clear))
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("frame")
    parser.add_argument("picture")
    parser.add_argument("--from", dest="eye", type=float, nargs=3, required=True)
    parser.add_argument("--at", type=float, nargs=3, default=[0, 0, 0])
    parser.add_argument("--angle", type=float, default=35)
    parser.add_argument("--up", choices=["y", "z"], default="z")
    parser.add_argument("--clear", type=int, nargs="*", default=[])
    parser.add_argument("--hide", type=int, nargs="*", default=[])
    parser.add_argument("--size", type=int, nargs=2, default=[640, 480])
    arguments = parser.parse_args()
    run_povray(scene_text(arguments), arguments.picture, *arguments.size, "+A0.2")


if __name__ == "__main__":
    main()
