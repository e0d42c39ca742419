"""Recorded motions, which an audit reads frame by frame."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Callable, NamedTuple

from tamis import _core
from tamis._arrays import Doubles
from tamis._checks import shown
from tamis._errors import Error


class Frame(NamedTuple):
    """One frame for the compiled part; `mesh` is another object if the topology changes, `problem` why it has none."""

    name: str
    positions: Doubles | None
    mesh: _core.SharedMesh | None
    problem: str = ""
    note: str = ""


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
