"""Small inputs, and a command line for each verb that works on them."""
import json
import struct

TRIANGLE = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]


def obj(height):
    points = TRIANGLE + [(0.2, 0.5, height)]
    return "".join(f"v {x} {y} {z}\n" for x, y, z in points) + "f 1 2 3\np 4\n"


def ply(height, order):
    """Return a PLY file with a triangle above a triangle: it has faces only."""
    points = TRIANGLE + [(0.2, 0.2, height), (0.4, 0.2, height), (0.2, 0.4, height)]
    name = {"": "ascii", "<": "binary_little_endian", ">": "binary_big_endian"}[order]
    text = (f"ply\nformat {name} 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty double z\n"
            "element face 2\nproperty list uchar int vertex_indices\nend_header\n").encode()
    if not order:
        rows = [f"{x} {y} {z}\n" for x, y, z in points] + ["3 0 1 2\n", "3 3 4 5\n"]
        return text + "".join(rows).encode()
    for x, y, z in points:
        text += struct.pack(order + "ffd", x, y, z)
    return text + struct.pack(order + "Biii", 3, 0, 1, 2) + struct.pack(order + "Biii", 3, 3, 4, 5)


def stl(height):
    """Return an ascii STL file with two triangles; each corner belongs to one of them."""
    text = "solid two\n"
    for triangle in (TRIANGLE, [(0.2, 0.2, height), (0.4, 0.2, height), (0.2, 0.4, height)]):
        rows = "".join(f"vertex {x} {y} {z}\n" for x, y, z in triangle)
        text += f"facet normal 0 0 1\nouter loop\n{rows}endloop\nendfacet\n"
    return text + "endsolid two\n"


def off(height):
    points = TRIANGLE + [(0.2, 0.5, height)]
    return "OFF\n4 2 0\n" + "".join(f"{x} {y} {z}\n" for x, y, z in points) + "3 0 1 2\n1 3\n"


def queries():
    """Return two queries; in the first the vertex falls through the face."""
    face = ["0,1,0,1,0,1", "1,1,0,1,0,1", "0,1,1,1,0,1"]
    rows = ["1,4,1,4,1,1", *face, "1,4,1,4,-1,1", *face]
    apart = ["1,4,1,4,1,1", *face, "1,4,1,4,1,2", *face]
    return "".join(f"{row},1\n" for row in rows) + "".join(f"{row},0\n" for row in apart)


def cloth(size, height):
    """Return a sheet above a sheet, which have many contacts if one falls through the other."""
    text, faces = "", ""
    for level in range(2):
        for i in range(size):
            for j in range(size):
                text += f"v {i + 0.3 * level} {j + 0.3 * level} {level * height}\n"
                if i + 1 < size and j + 1 < size:
                    a = level * size * size + i * size + j + 1
                    faces += f"f {a} {a + 1} {a + size}\nf {a + 1} {a + size + 1} {a + size}\n"
    return text + faces


def bodies(*frames):
    """Return a scene with a falling triangle, and a body with these frames; without frames a triangle on the floor."""
    falling = {"points": [[0.1, 0.1, 0], [0.5, 0.1, 0], [0.1, 0.5, 0.5]], "faces": [[0, 1, 2]]}
    floor = {"points": TRIANGLE, "faces": [[0, 1, 2]]}
    poses = [{"position": [0, 0, 1 - 2 * i]} for i in range(2)]
    other = {"frames": frames} if frames else {"mesh": "floor"}
    meshes = {"falling": falling} | ({} if frames else {"floor": floor})
    return json.dumps({"meshes": meshes, "bodies": [other, {"mesh": "falling", "poses": poses}]})


def write_inputs(folder):
    for name, text in {"above.obj": obj(1), "below.obj": obj(-2), "high.obj": obj(3), "fall/1.obj": obj(1),
                       "fall/2.obj": obj(0.5), "asked/vertex-face/1.csv": queries(), "cloth1.obj": cloth(40, 1),
                       "cloth2.obj": cloth(40, -1), "scene.json": bodies(),
                       "large.json": bodies("cloth1.obj", "cloth2.obj")}.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    for name, order in {"ascii": "", "little": "<", "big": ">"}.items():
        (folder / f"{name}1.ply").write_bytes(ply(1, order))
        (folder / f"{name}2.ply").write_bytes(ply(-2, order))
    for name, height in {"1": 1, "2": -2}.items():
        (folder / f"solid{name}.stl").write_text(stl(height))
        (folder / f"list{name}.off").write_text(off(height))
    # Pictures, which Python draws, take seconds and are not attacked.
    (folder / "bin").mkdir()
    (folder / "bin/python3").write_text("#!/bin/sh\nexit 0\n")
    (folder / "bin/python3").chmod(0o755)


# Words for the positional arguments of these names; verbs that need other words are in BASELINES.
POSITIONALS = {"START": ["above.obj"], "END": ["below.obj"], "MESH": ["above.obj"], "SCENE": ["scene.json"],
               "FRAMES": ["above.obj", "high.obj", "below.obj"], "FILES_OR_FOLDERS": ["asked"]}
BASELINES = {
    "scene": ["funnel", "--triangles", "600", "--frames", "2", "--out", "frames"],
    "paper": ["--scenes", "none", "--frames", "fall=fall", "--out", "laboratory"],
    "within": ["above.obj", "--distance", "2"],
    "bench": ["above.obj", "below.obj", "--cold", "1", "--warm-up", "0", "--repeat", "1"],
}
# Inputs whose answers take long enough to write that a signal can interrupt it.
LARGE = {"SCENE": ["large.json"], "START": ["cloth1.obj"], "END": ["cloth2.obj"], "FRAMES": ["cloth1.obj", "cloth2.obj"]}
# The endings of outputs' names, for verbs that require one.
SUFFIXES = {"view": ".html"}


def positionals_of(verb, large=False):
    """Return words for the verb's positional arguments; None if one of them is unknown."""
    words = []
    for name in verb.positionals:
        known = (LARGE if large else {}).get(name) or POSITIONALS.get(name)
        if known is None:
            return None
        words += known
    return words


def baseline(verb, large=False):
    """Return the verb with arguments that give an answer; None if these are not known for this verb."""
    words = BASELINES.get(verb.name)
    if words is None or (large and verb.name == "bench"):
        found = positionals_of(verb, large)
        words = None if found is None else found + (words[2:] if words else [])
    return None if words is None else [verb.name, *words]
