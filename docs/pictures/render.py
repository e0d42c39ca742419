#!/usr/bin/env python3
"""Renders a mesh with its contacts glowing: render.py MESH.ply CONTACTS.csv OUT.png [--yaw DEGREES] [--pitch DEGREES].

MESH.ply has triangles, in binary; CONTACTS.csv is from `tamis contacts --out`.
Needs NumPy and POV-Ray (Debian: python3-numpy, povray).
"""
import argparse
import pathlib
import subprocess
import tempfile

import numpy as np

STEPS = 32  # the number of colours from cloth to contact
CLOTH = np.array([0.36, 0.47, 0.62])
OTHER = np.array([0.80, 0.80, 0.78])
WARM = np.array([[0.95, 0.62, 0.12], [0.92, 0.16, 0.05]])
FLOAT = {"float": "f4", "float32": "f4", "double": "f8", "float64": "f8"}

SCENE = """#version 3.7;
global_settings {{ assumed_gamma 1 max_trace_level 4 }}
background {{ rgb 1 }}
camera {{ perspective angle 26 right x*{aspect} up y
         location <{eye}> look_at <{target}> }}
light_source {{ <{key}> rgb 0.95 area_light <{span},0,0>, <0,0,{span}>, 9, 9 adaptive 1 jitter circular orient }}
light_source {{ <{fill}> rgb 0.22 shadowless }}
light_source {{ <{eye}> rgb 0.15 shadowless }}
plane {{ y, {floor} pigment {{ rgb 1 }} finish {{ ambient 0 emission 0.35 diffuse 0.62 }} }}
mesh2 {{
  vertex_vectors {{ {vertices} }}
  normal_vectors {{ {normals} }}
  texture_list {{ {textures} }}
  face_indices {{ {faces} }}
}}
"""


def read_ply(path):
    with open(path, "rb") as file:
        header = []
        while not header or header[-1] != "end_header":
            header.append(file.readline().decode().strip())
        order = ">" if "format binary_big_endian 1.0" in header else "<"
        counts = {line.split()[1]: int(line.split()[2]) for line in header if line.startswith("element")}
        scalar = [line.split()[1:] for line in header if line.startswith("property") and "list" not in line]
        vertex = np.dtype([(name, order + FLOAT[kind]) for kind, name in scalar])
        face = np.dtype([("count", "u1"), ("corners", order + "i4", 3)])
        points = np.frombuffer(file.read(counts["vertex"] * vertex.itemsize), vertex)
        faces = np.frombuffer(file.read(counts["face"] * face.itemsize), face)["corners"].astype(int)
    return np.stack([points[axis].astype(float) for axis in "xyz"], axis=1), faces


def vertex_normals(points, faces):
    a, b, c = (points[faces[:, i]] for i in range(3))
    normals = np.zeros_like(points)
    for i in range(3):
        np.add.at(normals, faces[:, i], np.cross(b - a, c - a))
    return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30)


def glow(contacts_path, vertex_count, faces):
    """Return a heat for each vertex: 1 at vertices of a contact, less at vertices around them."""
    rows = np.genfromtxt(contacts_path, delimiter=",", skip_header=1, usecols=(1, 2, 3, 4), dtype=int, ndmin=2)
    heat = np.zeros(vertex_count)
    heat[np.unique(rows)] = 1
    for _ in range(2):
        total, count = np.zeros(vertex_count), np.zeros(vertex_count)
        mean = heat[faces].mean(axis=1)
        for i in range(3):
            np.add.at(total, faces[:, i], mean)
            np.add.at(count, faces[:, i], 1)
        heat = np.maximum(0.8 * heat, total / np.maximum(count, 1))
    return heat


def components(vertex_count, faces):
    """Return the smallest vertex of each vertex' connected component."""
    label = np.arange(vertex_count)
    while True:
        lowest = label[faces].min(axis=1)
        new = label.copy()
        for i in range(3):
            np.minimum.at(new, faces[:, i], lowest)
        new = new[new]
        if (new == label).all():
            return label
        label = new


def largest_component(vertex_count, faces):
    label = components(vertex_count, faces)
    return label == np.bincount(label).argmax()


def colour(base, heat):
    stops = np.array([base, WARM[0], WARM[1]])
    return np.array([np.interp(heat, [0, 0.5, 1], stops[:, channel]) for channel in range(3)])


def triples(rows):
    return ",".join("<" + ",".join("%.6g" % x for x in row) + ">" for row in rows)


def pov_scene(points, faces, heat, is_cloth, yaw, pitch, aspect):
    low, high = points.min(axis=0), points.max(axis=0)
    size = np.linalg.norm(high - low)
    target = (low + high) / 2 - [0, 0.075 * size, 0]
    direction = np.array([np.cos(pitch) * np.sin(yaw), np.sin(pitch), -np.cos(pitch) * np.cos(yaw)])
    eye = target + 1.9 * size * direction
    step = np.minimum((heat * STEPS).astype(int), STEPS - 1) + STEPS * (~is_cloth)
    textures = []
    for base in (CLOTH, OTHER):
        for k in range(STEPS):
            rgb, emission = colour(base, k / (STEPS - 1)), 0.05 + 0.45 * k / (STEPS - 1)
            textures.append("texture { pigment { rgb <%.3f,%.3f,%.3f> } finish { ambient 0 emission %.3f diffuse 0.75 "
                            "specular 0.08 roughness 0.08 } }" % (*rgb, emission))
    face_rows = ",".join("<%d,%d,%d>,%d,%d,%d" % (*f, *step[f]) for f in faces)
    vector = lambda v: ",".join("%.6g" % x for x in v)
    return SCENE.format(
        aspect=aspect, eye=vector(eye), target=vector(target), floor="%.6g" % (low[1] - 0.002 * size), span=0.6 * size,
        key=vector(target + size * np.array([-1.1 * np.cos(yaw) + 0.9 * np.sin(yaw), 2.2, -1.1 * np.sin(yaw) - 0.9 * np.cos(yaw)])), fill=vector(target + size * np.array([2.0, 1.0, -1.0])),
        vertices=f"{len(points)}," + triples(points), normals=f"{len(points)}," + triples(vertex_normals(points, faces)),
        textures=f"{len(textures)}, " + ", ".join(textures),
        faces=f"{len(faces)}," + face_rows)


def run_povray(scene, picture, width, height, *options):
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder) / "scene.pov"
        source.write_text(scene)
        subprocess.run(["povray", f"+I{source}", f"+O{picture}", f"+W{width}", f"+H{height}", "-D", "-GA", *options],
                       check=True, capture_output=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("mesh")
    parser.add_argument("contacts")
    parser.add_argument("out")
    parser.add_argument("--yaw", type=float, default=30)
    parser.add_argument("--pitch", type=float, default=30)
    parser.add_argument("--size", default="1600x900")
    arguments = parser.parse_args()
    width, height = map(int, arguments.size.split("x"))

    points, faces = read_ply(arguments.mesh)
    scene = pov_scene(points, faces, glow(arguments.contacts, len(points), faces), largest_component(len(points), faces),
                      np.radians(arguments.yaw), np.radians(arguments.pitch), width / height)
    run_povray(scene, arguments.out, width, height, "+A0.1", "-V")


if __name__ == "__main__":
    main()
