"""Right values for all arguments, by name, for calls with one wrong argument. A name that is missing fails the test."""

from __future__ import annotations

import base64
import importlib
import inspect
import json
import pathlib
from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from conftest import END, FACES, START

import tamis
import tamis.compat.ipctk as ipctk
from misuse.public import Argument, Callee

_MESH = tamis.Mesh(FACES)
_POSE = np.zeros((2, 3))
PATH = tamis.BezierPath(np.stack([START, END]))
_SHAPE = tamis.Shape(_MESH, START)
_LINKAGE = tamis.Linkage([-1], np.zeros((1, 2, 3)), ["turning"], [[0.0, 0, 1]], [0], [0], [0])
_BARRIER_MESH = ipctk.CollisionMesh(START, ipctk.edges(FACES), FACES)


def _still(time: float, vertices: Any) -> tuple[Any, float]:
    return START[vertices], 0.0


def _no_deviation(start: float, end: float, vertices: Any) -> float:
    return 0.0


_NAMED: Mapping[str, Any] = {
    "bodies": [0, 1],
    "body": 0,
    "body_of_vertex": np.zeros(6, int),
    "chain": tamis.interpolated_chain(_POSE, _POSE),
    "chains": [tamis.interpolated_chain(_POSE, _POSE)],
    "control_points": np.stack([START, END]),
    "distance": 1.5,
    "edges": np.array([[0, 1], [3, 4]]),
    "end": END,
    "end_position": np.ones(3),
    "faces": FACES,
    "frames": np.stack([START, END]),
    "index": 0,
    "is_enabled": True,
    "kind": tamis.PairKind.VERTEX_FACE,
    "may_touch": False,
    "mesh": _MESH,
    "meshes": [_MESH] * 2,
    "motion": _POSE,
    "motions": np.zeros((2, 2, 3)),
    "nthreads": 1,
    "conservative_rescaling": 0.5,
    "points": START,
    "points_at": _still,
    "position": np.zeros((2, 3)),
    "positions": START,
    "radius": 0.25,
    "can_collide": lambda a, b: True,
    "rest": START,
    "rotation": np.array([[1.0, 0, 0, 0], [0, 1, 0, 0]]),
    "shape": _SHAPE,
    "rest_positions": START,
    "start": START,
    "deviations": _no_deviation,
    "time": 0.5,
    "source": np.stack([START, END]),
    "turn": np.ones(3),
    "vertex_count": 6,
    "vertices": np.array([[3, 0, 1, 2]]),
    "vertices_t0": START,
    "vertices_t1": END,
    "parents": [-1],
    "places": np.zeros((1, 2, 3)),
    "kinds": ["turning"],
    "axes": np.array([[0.0, 0, 1]]),
    "coordinates": [0],
    "carriers": [0, 0],
    "body_places": np.zeros((2, 2, 3)),
    "factors": np.ones(1),
    "offsets": np.zeros(1),
    "linkage": _LINKAGE,
    "configurations": np.zeros((1, 1)),
    "starts": np.zeros((1, 1)),
    "ends": np.ones((1, 1)),
    "waypoints": np.zeros((2, 1)),
    "starts_are_free": True,
    "start_is_free": True,
}


_STAGE = """#usda 1.0
def Mesh "Spike" {
    int[] faceVertexCounts = [3]
    int[] faceVertexIndices = [0, 1, 2]
    point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
}
"""


def _gltf() -> str:
    corners = base64.b64encode(START[:3].astype("<f4").tobytes()).decode()
    return json.dumps(
        {
            "asset": {"version": "2.0"},
            "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}],
            "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64," + corners}],
        }
    )


def _objects() -> list[Any]:
    """Return an object of each class that has methods, by the class."""
    detector = tamis.Detector(_MESH, threads=1)
    report = tamis.audit(np.stack([START, END]), faces=FACES)
    pairs = tamis.narrow_phase(tamis.PairKind.VERTEX_FACE, [3, 0, 1, 2], START, END)
    crossing = START - [0, 0, 1] * (np.arange(6) == 3)[:, np.newaxis] * 2
    world = tamis.World(threads=1)
    world.add(_SHAPE)
    world.add(_SHAPE, tamis.Deforming(START, END))
    return [
        *(
            _LINKAGE,
            _SHAPE,
            world,
            world.contacts(),
            world.pairs_within(0.5),
            world.intersections(),
            tamis.Deforming(START, END),
        ),
        *(_MESH, detector, pairs, PATH, ipctk.Candidates(), _BARRIER_MESH, ipctk.TightInclusionCCD()),
        *(ipctk.AdditiveCCD(), detector.contacts(START, END), detector.pairs_within(START, 1.5)),
        *(detector.intersections(crossing), tamis.CatmullRomPath(np.stack([START, END]))),
        *(report, report.frames, report.pairs, tamis.Auditor(_MESH, threads=1)),
        tamis.FunctionPath(6, _still, _no_deviation),
        tamis.RigidPath(START, np.zeros(6, int), [tamis.interpolated_chain(_POSE, _POSE)]),
    ]


def receiver_of(callee: Callee) -> Any:
    """Return a new object to call the method on; None if the callee is a function."""
    return next(thing for thing in _objects() if isinstance(thing, callee.of)) if callee.of else None


def use(thing: Any) -> None:
    """Use an object that keeps its arguments, functions above all, so that it needs them."""
    if isinstance(thing, tamis.Detector):
        thing.contacts(START, END)
    elif isinstance(thing, tamis.World):
        thing.contacts()
    elif isinstance(thing, tamis.Deforming):
        tamis.World(threads=1).add(_SHAPE, thing)
    elif isinstance(thing, tamis.FunctionPath):
        tamis.Detector(_MESH, threads=1).contacts(thing)
        thing.points_at(0.5)
    elif isinstance(thing, tamis.AuditReport) and thing.problems:
        raise tamis.InvalidStep(f"source: {next(iter(thing.problems.values()))}")
    elif isinstance(thing, tamis.StepReport) and thing.problem:
        raise tamis.InvalidStep(f"positions: {thing.problem}")
    elif isinstance(thing, ipctk.CollisionMesh):
        ipctk.is_step_collision_free(thing, START, END)


def _of_callee(callee: Callee, folder: pathlib.Path) -> dict[str, Any]:
    """Return the arguments whose right values differ in this call."""
    short = callee.name.rpartition(".")[2]
    if short in ("interpolated_chain", "turned_chain", "chain_between", "nlerp_deviation"):
        return {"start": _POSE, "end": _POSE}
    if short == "roadmap":
        return {"edges": [[0, 0]]}
    if short == "earliest_many":
        return {"motions": np.zeros((3, 2, 1, 4, 3))}
    if callee.name.startswith("bridge"):
        theirs = importlib.import_module("ipctk").CollisionMesh(START, ipctk.edges(FACES), FACES)
        return {"collision_mesh": theirs, "pairs": tamis.Detector(_MESH).pairs_within(START, 1.5)}
    if callee.name.startswith("ipctk"):
        return {"mesh": _BARRIER_MESH, "vertices": START}
    if short == "read_mesh" or short == "read_frames":
        tamis.write_mesh(folder / "mesh.ply", START, FACES)
        return {"path": folder / "mesh.ply", "names": folder / "mesh.ply"}
    if short == "simulate":
        return {"name": "funnel", "folder": folder / "run", "triangles": 500, "frames": 0}
    if short == "read_usd":
        pytest.importorskip("pxr.Usd")
        (folder / "stage.usda").write_text(_STAGE)
        return {"stage": folder / "stage.usda", "prims": ["/Spike"]}
    if short == "read_gltf":
        pytest.importorskip("pygltflib")
        (folder / "mesh.gltf").write_text(_gltf())
        return {"path": folder / "mesh.gltf"}
    same = next((thing for thing in _objects() if type(thing) is callee.function), None)
    return {
        "name": "soup",
        "path": folder / {"view": "page.html", "Page": "page.html", "write_mesh": "new.ply"}.get(short, "table.csv"),
        "table": getattr(same, "table", None),
    }


def _needed(callee: Callee, argument: Argument) -> bool:
    default = inspect.signature(callee.function).parameters[argument.name].default
    return default is inspect.Parameter.empty or callee.name == "simulate"


def right_calls(callee: Callee, folder: pathlib.Path) -> list[dict[str, Any]]:
    """Return arguments with which the call works: as few as possible; if it takes paths, also those with a path."""
    known = {**_NAMED, **_of_callee(callee, folder)}
    if "_ccd" in callee.name:
        known.update({a.name: START[i % 4] for i, a in enumerate(callee.arguments) if a.takes == ("array",)})
    needed = [a.name for a in callee.arguments if _needed(callee, a)]
    missing = [name for name in needed if known.get(name) is None and name != "seed"]
    assert not missing, f"{callee.name}: what is right for {missing}? Say so in bindings/python/tests/misuse/right.py"
    calls = [{name: known[name] for name in needed if name in known}]
    if callee.name == "audit":
        calls[0]["faces"] = FACES
    moving = [a.name for a in callee.arguments if "Path" in a.takes]
    if moving:
        calls.append({**calls[0], moving[0]: PATH})
        calls[0]["end"] = END
    return calls
