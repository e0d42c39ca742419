"""Right values for all arguments and fields, by name. A name that is missing fails the test."""
import ctypes
import struct as packed

import headers

FACES, START = (0, 1, 2, 3, 4, 5), (0, 0, 0, 1, 0, 0, 0, 1, 0, .25, .25, 1, 1, .5, 2, .5, 1, 2)
END = (*START[:11], -1, *START[12:])
ROOM = 4096  # bytes for any output

POINTS_AT = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_double, ctypes.POINTER(ctypes.c_int32), ctypes.c_size_t,
                             ctypes.POINTER(ctypes.c_double), ctypes.POINTER(ctypes.c_double))
DEVIATIONS = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.POINTER(ctypes.c_int32),
                          ctypes.c_size_t, ctypes.POINTER(ctypes.c_double))
ASKED = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p)
ACCEPTS = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_int32, ctypes.POINTER(ctypes.c_int32))

BODY = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_int32)
LOOP = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_int32, BODY, ctypes.c_void_p)


@LOOP
def _one_after_the_other(user, count, body, loop):
    for i in range(count):
        body(loop, i)


@POINTS_AT
def _still(user, time, vertices, count, points, errors):
    for i in range(count):
        errors[i] = 0
        for axis in range(3):
            points[3 * i + axis] = START[3 * vertices[i] + axis]


@DEVIATIONS
def _no_deviation(user, start, end, vertices, count, deviations):
    for i in range(count):
        deviations[i] = 0


def doubles(*values):
    return (ctypes.c_double * len(values))(*values)


def indices(*values):
    return (ctypes.c_int32 * len(values))(*values)


def pair(name, vertex_count):
    """Return the points of a pair: the corner that falls, then corners of the triangle below, `vertex_count` in all."""
    return doubles(*[number for corner in (3, 0, 1, 2)[:vertex_count] for number in START[3 * corner:3 * corner + 3]])


# The fields of all structs.
FIELDS = {
    "vertex_count": 6, "start": doubles(*START), "end": doubles(*END), "start_stride": 0, "end_stride": 0,
    "faces": indices(*FACES), "face_count": 2, "loose_edges": indices(0, 3), "loose_edge_count": 1,
    "loose_points": indices(1), "loose_point_count": 1, "threads": 1, "min_separation": 0.0, "group_count": 2,
    "group_of_vertex": indices(0, 0, 0, 1, 1, 1), "groups_may_touch": (ctypes.c_uint8 * 4)(1, 1, 1, 1),
    "radii": doubles(0, 0), "at_start": 0, "rings": 1, "isa": b"best",
    "accepts": ACCEPTS(lambda user, kind, vertices: 1), "is_cancelled": ASKED(lambda user: 0), "parallel_for": _one_after_the_other, "user": None,
    "latest": doubles(1), "kind": 0, "vertices": (3, 0, 1, 2), "rest": doubles(*START), "rest_end": doubles(*END), "body_count": 1,
    "body_of_vertex": indices(0, 0, 0, 0, 0, 0), "links_of_body": (ctypes.c_size_t * 1)(0), "links": None,
    "frame_count": 2, "frames": doubles(*START, *END), "points_at": _still, "deviations": _no_deviation, "tolerance": 0.0,
    "position": (0., 0., 0.), "rotation": (0., 0., 1.), "count": 1, "poses": doubles(0, 0, 9, 0, 0, 1), "links_of_each": 0,
}
# Fields of one struct that differ: a motion is given in one of several ways.
LEFT_OUT = {"tamis_motions": {"start": None, "end": None, "vertex_count": 0}}
INPUTS = ("tamis_step", "tamis_mesh_input", "tamis_options", "tamis_pair_options", "tamis_rigid_path_input",
          "tamis_spline_path_input", "tamis_path_functions", "tamis_path_options", "tamis_feature_pair", "tamis_pose",
          "tamis_world_options", "tamis_shape_options", "tamis_motions")
ARGUMENTS = {
    "kind": 0, "stored": 0, "u": .25, "v": .25, "keep": .1, "distance": 1.5, "time": .5, "first": 0, "turn": doubles(0, 0, 1),
    "end_position": doubles(1, 1, 1), "center": doubles(1, 0, 0), "quaternion": doubles(1, 0, 0, 0),
    "links": doubles(*[0] * 12), "rows": doubles(1, 0, 0, 0, 1, 0, 0, 0, 1), "position": doubles(1, 1, 1), "edges": indices(0, 1), "faces": indices(0, 1, 2),
    # A joint that slides body 0 along x: parent, kind, coordinate; place, axis, factor, offset. And the body.
    "joints": ctypes.create_string_buffer(packed.pack("iii4x11d", -1, 2, 0, *[0] * 6, 1, 0, 0, 1, 0)), "joint_count": 1,
    "carried": ctypes.create_string_buffer(packed.pack("ii6d", 0, 0, *[0] * 6)), "carried_count": 1,
    "configurations": doubles(0), "starts": doubles(0), "ends": doubles(1), "waypoints": doubles(0, 1), "waypoint_count": 2,
    "edge_ends": indices(0, 0), "edge_count": 1, "starts_are_free": 0,
    "points": doubles(*START), "bodies": indices(0, 1), "body_count": 1, "is_enabled": 1, "may_touch": 0, "include_static": 0, "radius": 0.25, "body": 0, "vertex_count": 6,
}
_CORNERS = {"vertex_face": 4, "edge_edge": 4, "vertex_edge": 3, "vertex_vertex": 2}


def struct(interface: headers.Interface, name: str, **changed) -> ctypes.Structure:
    """Return a struct with right values, except for the fields in `changed`."""
    made = interface.types[name]()
    keep = made.kept = []
    for field in interface.structs[name]:
        usual = {**FIELDS, "size": ctypes.sizeof(made), **LEFT_OUT.get(name, {}), **changed}
        value = usual.get(field.name, 0)
        assert field.name in usual, \
            f"{name}.{field.name}: what is right for it? Say so in bindings/c/tests/misuse/right.py"
        put(made, field, value, keep)
    return made


def put(made: ctypes.Structure, field: headers.Parameter, value, keep: list) -> None:
    """Write a field; `keep` holds the object that it points to, as long as the struct lives."""
    if field.type == "const double*" and isinstance(value, float):
        value = doubles(value)
    if field.is_pointer and value is not None:
        keep.append(value)
        value = ctypes.cast(ctypes.c_char_p(value) if isinstance(value, bytes) else value, ctypes.c_void_p)
    is_array = isinstance(getattr(made, field.name), ctypes.Array)
    if is_array:
        value = type(getattr(made, field.name))(*value)
    setattr(made, field.name, value)


def argument(interface: headers.Interface, function: headers.Function, parameter: headers.Parameter, handles: dict):
    """Return a right value for one argument of this function."""
    kind = parameter.type.replace("const ", "").rstrip("*")
    if parameter.type.endswith("**"):
        return ctypes.c_void_p()
    if kind in handles:
        return handles[kind]
    if kind in INPUTS and parameter.type.startswith("const"):
        return struct(interface, kind)
    corners = next((n for name, n in _CORNERS.items() if function.name.endswith(name)), 4)
    if parameter.name in ("start", "end"):
        return pair(parameter.name, corners)
    if parameter.name == "vertices":
        return indices(*(3, 0, 1, 2)[:corners])
    if parameter.name == "count" and not parameter.is_pointer:
        return 0 if "_copy_" in function.name else 1
    if parameter.name.endswith("_size"):
        return next(ctypes.sizeof(interface.types[p.type.rstrip("*")]) for p in function.parameters
                    if p.type.rstrip("*") in interface.types and not p.type.startswith("const"))
    if parameter.is_pointer and not parameter.type.startswith("const"):
        room = ctypes.create_string_buffer(ROOM)
        if kind in interface.structs and interface.structs[kind][0].name == "size":
            ctypes.c_size_t.from_buffer(room).value = ctypes.sizeof(interface.types[kind])
        return room
    assert parameter.name in ARGUMENTS, \
        f"{function.name}: what is right for {parameter.name}? Say so in bindings/c/tests/misuse/right.py"
    return ARGUMENTS[parameter.name]
