"""`read_gltf`: reads the animated meshes of a glTF file with pygltflib."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from typing import Any

import numpy as np

from tamis._audit._gltf_animation import Pose, animation_of
from tamis._audit._gltf_buffers import Buffers
from tamis._audit._gltf_mesh import moving_nodes
from tamis._audit._joined import Part, joined
from tamis._audit._recorded import Frame, Motion
from tamis._checks import file_name, number
from tamis._errors import Error, FileError, InvalidOptions
from tamis._versions import needed

# Extensions that do not change where vertices are.
_HARMLESS = (
    "KHR_materials_",
    "KHR_texture_",
    "KHR_lights_",
    "EXT_texture_",
    "KHR_mesh_quantization",
    "KHR_animation_pointer",
)
_INSTANCES = "EXT_mesh_gpu_instancing"


def read_gltf(
    path: str | os.PathLike[str], *, frames_per_second: float = 30.0, animation: int | str | None = None
) -> Motion:
    """Read the meshes of a glTF file in motion: morph targets, skins and moving nodes, in world space.

    An animation is sampled, as its values have keys at different times and curves between them. Each node with a mesh
    in the default scene is an object with the node's name. Vertices that differ only in normals, textures and the like
    are joined.

    Parameters
    ----------
    path : path_like
        A .gltf file, with its buffers beside it, or a .glb file.
    frames_per_second : float
        Finite and > 0: the number of frames to sample in each second.
    animation : int or str, optional
        The number or name of the animation; by default the first. A file without animations has a single frame.

    Returns
    -------
    Motion
        For `audit`.

    Raises
    ------
    FileError
        The file cannot be read, needs an extension that is not understood, or has no triangles.
    InvalidOptions
        There is no such animation, or `frames_per_second` is outside its range.
    ModuleNotFoundError
        pygltflib is not installed: pip install pygltflib.
    """
    name = file_name(path, "path")
    rate = number(frames_per_second, "frames_per_second")
    if not 0 < rate < float("inf"):
        raise InvalidOptions(f"frames_per_second is {rate}: give a finite number above 0")
    gltf = _load(name)
    buffers = Buffers(gltf, name)
    try:
        nodes = moving_nodes(gltf, buffers, name)
        moves = animation_of(gltf, buffers, name, animation)
        times = np.array([0.0]) if moves is None else moves.frame_times(rate)
        for node in nodes:
            node.points(Pose(gltf, moves, float(times[0])))
    except Error:
        raise
    except (AttributeError, IndexError, KeyError, TypeError, ValueError) as error:
        raise FileError(f"{name}: its parts do not fit each other ({error}): export the file again") from None
    note = _note(gltf, animation)

    def frames() -> Iterator[Frame]:
        shared = joined([Part(node.name, node.vertex_count, node.faces) for node in nodes])
        for i, time in enumerate(times.tolist()):
            pose = Pose(gltf, moves, time)
            points = np.concatenate([node.points(pose) for node in nodes])
            yield Frame(f"{time:g} s", points, shared, note="" if i else note)

    return Motion(frames, f"{name}, {len(nodes)} meshes, {len(times)} frames")


def _note(gltf: Any, animation: int | str | None) -> str:
    notes = []
    if len(gltf.animations or []) > 1 and animation is None:
        notes.append("only the first animation is asked about")
    if _INSTANCES in (gltf.extensionsUsed or []):
        notes.append(f"of the instances of {_INSTANCES} one each is asked about, where its node is")
    if any(channel.target.node is None for each in gltf.animations or [] for channel in each.channels):
        notes.append("what is animated by KHR_animation_pointer stays where it is")
    return "; ".join(notes)


def _require_version_2(name: str) -> None:
    """Raise FileError for glTF 1, which has objects by name where 2 has lists; other faults are left to the reader."""
    try:
        with open(name, "rb") as file:
            head = file.read(8)
            is_first = head == b"glTF\x01\0\0\0"
            if not head.startswith(b"glTF"):
                given = json.loads(head + file.read())
                version = str(given.get("asset", {}).get("version", ""))
                is_first = version.startswith("1") or (not version and isinstance(given.get("meshes"), dict))
    except (OSError, ValueError, AttributeError):
        return
    if is_first:
        raise FileError(f"{name}: glTF 1 is not read: export it as glTF 2")


def _load(name: str) -> Any:
    with needed("pygltflib", "read_gltf"):
        import pygltflib

    _require_version_2(name)
    try:
        gltf = pygltflib.GLTF2().load(name)
    except Exception as error:  # the package lets exceptions of all kinds through: KeyError, struct.error, ...
        raise FileError(f"{name}: cannot be read as glTF ({error}): check the path and what the file is") from None
    if gltf is None:
        raise FileError(f"{name}: no such file: check the path")
    for extension in gltf.extensionsRequired or []:
        if not extension.startswith(_HARMLESS):
            raise FileError(f"{name}: needs the extension {extension}, which is not understood: export it without")
    return gltf
