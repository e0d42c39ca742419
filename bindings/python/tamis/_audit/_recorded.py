"""Recorded motions, which an audit reads frame by frame."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Callable, NamedTuple

from tamis import _core
from tamis._arrays import Doubles
from tamis._checks import shown
from tamis._errors import Error, InvalidStep


class Frame(NamedTuple):
    """One frame for the compiled part; `mesh` is another object if the topology changes, `problem` why it has none."""

    name: str
    positions: Doubles | None
    mesh: _core.SharedMesh | None
    problem: str = ""
    note: str = ""


def require_frames_first(name: str, shape: tuple[int, ...], vertices: int) -> None:
    """Raise InvalidStep if the first dimension of the array counts the vertices, and the second does not."""
    if len(shape) == 3 and shape[0] == vertices != shape[1]:
        raise InvalidStep(
            f"{name} has the shape {shape}, and the faces name {vertices} vertices: give (frames, vertices, 3), as "
            "numpy.swapaxes(array, 0, 1) does; if these are frames, give mesh=tamis.Mesh(faces, vertices)"
        )


class Motion:
    """A recorded motion for `audit`, as `read_usd` and `read_gltf` return it.

    Its frames are read during the audit; it may be audited several times.
    """

    __slots__ = ("_description", "_frames")

    def __init__(self, frames: Callable[[], Iterator[Frame]], description: str) -> None:
        if not callable(frames):
            raise Error(f"frames is {shown(frames)}: take a Motion from tamis.read_usd or tamis.read_gltf")
        self._frames = frames
        self._description = str(description)

    def __repr__(self) -> str:
        return f"Motion({self._description})"
