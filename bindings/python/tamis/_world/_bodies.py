"""Shapes and motions of bodies, and checks of arguments that name bodies or give motions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from tamis import _core
from tamis._arrays import Doubles, Indices, doubles, indices, numbers, packed_rows, shape_text
from tamis._checks import instance, word
from tamis._errors import InvalidMesh, InvalidOptions, InvalidPath
from tamis._mesh import Mesh, known_mesh
from tamis._options import Isa

AT_REST = np.zeros((2, 3))
_MOTION = "give a pose (2, 3), a chain (links, 4, 3) as tamis.chain_between makes one, or a tamis.Deforming"
_MOTIONS = "give poses (n, 2, 3), as tamis.pose_of makes them, or chains (n, links, 4, 3), as tamis.chain_between does"


class Shape:
    """A mesh with its points at rest, in the body's own frame, and the hierarchy over them.

    Make it once, then share it among any number of bodies.

    Parameters
    ----------
    mesh : Mesh
        The topology.
    points : array_like, shape (n, 3)
        Where each vertex is. They are copied.
    isa : str
        The instruction set that builds the hierarchy: "best", "baseline", "avx2", "avx512". Changes speed only.

    Raises
    ------
    InvalidMesh
        Points that do not fit the mesh, or are not finite.
    InvalidOptions
        An unknown name, or an instruction set that this machine lacks.
    """

    __slots__ = ("_mesh", "_shape")

    def __init__(self, mesh: Mesh, points: npt.ArrayLike, *, isa: Isa = "best") -> None:
        self._mesh = known_mesh(mesh)
        given = packed_rows(points, "points", InvalidMesh)
        self._shape = _core.Shape(self._mesh._mesh, given, word(isa, "isa"))

    @property
    def mesh(self) -> Mesh:
        """The topology."""
        return self._mesh

    @property
    def points(self) -> Doubles:
        """A copy of the points at rest, shape (n, 3)."""
        return self._shape.points()

    @property
    def memory_bytes(self) -> int:
        """Memory that the shape holds besides mesh and points."""
        return self._shape.memory_bytes()

    def __repr__(self) -> str:
        return f"Shape({self._mesh!r})"

    def __reduce__(self) -> tuple[type[Shape], tuple[Mesh, Doubles]]:
        return Shape, (self._mesh, self.points)


class Deforming:
    """The motion of a body that deforms: each vertex goes straight, in the world's frame. The body may touch itself.

    Parameters
    ----------
    start, end : array_like, shape (n, 3)
        Where each vertex is at t=0 and at t=1. Arrays other than contiguous float64 are copied.

    Raises
    ------
    InvalidStep
        Arrays of another shape or type.
    """

    __slots__ = ("_end", "_start")

    def __init__(self, start: npt.ArrayLike, end: npt.ArrayLike) -> None:
        self._start = packed_rows(start, "start")
        self._end = packed_rows(end, "end")

    @property
    def start(self) -> Doubles:
        """Where each vertex is at t=0, shape (n, 3)."""
        return self._start

    @property
    def end(self) -> Doubles:
        """Where each vertex is at t=1, shape (n, 3)."""
        return self._end

    def __repr__(self) -> str:
        return f"Deforming({len(self._start)} vertices)"


def known_shape(given: Shape) -> Shape:
    """Return the argument if it is a `Shape`, else raise."""
    return instance(given, Shape, "shape", "a tamis.Shape, such as tamis.Shape(mesh, points)")


def numbers_of(given: npt.ArrayLike) -> Indices:
    """Return the numbers of one or many bodies, shape (n,)."""
    return indices(given, 0, "bodies", InvalidOptions, one_may_come_alone=True)


def each_once(named: Indices) -> Indices:
    """Return the numbers of bodies if none is given twice, else raise."""
    ordered = np.sort(named)
    twice = ordered[1:][ordered[1:] == ordered[:-1]]
    if len(twice):
        raise InvalidOptions(f"bodies holds {twice[0]} twice: give each once")
    return named


def motion_of(given: npt.ArrayLike | Deforming, body: int | None = None) -> tuple[Doubles, ...]:
    """Return the compiled part's arguments for the motion of one body; errors name `body`, if it has a number yet."""
    if isinstance(given, Deforming):
        return given.start, given.end
    motion = numbers(given, "motion", InvalidPath)
    chains = _poses_or_chains(motion[np.newaxis], motion, "motion", _MOTION)
    return (_finite(chains, lambda _: "motion" if body is None else f"motion of body {body}"),)


def motions_of(given: npt.ArrayLike) -> Doubles:
    """Return the motions of n new bodies: poses, shape (n, 2, 3), or chains, shape (n, links, 4, 3)."""
    return _finite(_motions(given), lambda i: f"motions[{i}]")


def motions_of_bodies(given: npt.ArrayLike, named: Indices) -> Doubles:
    """Return motions as `motions_of` does, one for each of the bodies `named`; errors name the body."""
    motions = _motions(given)
    if len(named) != len(motions):
        raise InvalidPath(f"motions has {len(motions)} entries, bodies {len(named)}: give as many")
    return _finite(motions, lambda i: f"motions[{i}], of body {named[i]},")


def chains_of_each(given: npt.ArrayLike, named: Indices) -> Doubles:
    """Return the chains of n motions of b bodies, shape (n * b, links, 4, 3), from (n, b, links, 4, 3)."""
    motions = numbers(given, "motions", InvalidPath)
    count = len(named)
    if motions.ndim != 5 or motions.shape[1] != count or motions.shape[3:] != (4, 3):
        raise InvalidPath(
            f"motions has the shape {shape_text(motions)}: give (n, {count}, links, 4, 3), for each motion as many "
            "chains as bodies"
        )
    if not count:
        raise InvalidOptions("bodies is empty: name those that move")
    chains = _motions(motions.reshape(len(motions) * count, *motions.shape[2:]))
    return _finite(chains, lambda i: f"motions[{i // count}, {i % count}], of body {named[i % count]},")


def _motions(given: npt.ArrayLike) -> Doubles:
    motions = numbers(given, "motions", InvalidPath)
    return _poses_or_chains(motions, motions, "motions", _MOTIONS)


def _poses_or_chains(array: npt.NDArray[Any], given: npt.NDArray[Any], name: str, advice: str) -> Doubles:
    if array.shape[1:] != (2, 3) and (array.ndim != 4 or array.shape[2:] != (4, 3)):
        raise InvalidPath(f"{name} has the shape {shape_text(given)}: {advice}")
    return doubles(array)


def _finite(motions: Doubles, name_of: Callable[[int], str]) -> Doubles:
    if not np.isfinite(motions).all():
        first = int(np.argmin(np.isfinite(motions).all(axis=tuple(range(1, motions.ndim)))))
        raise InvalidPath(f"{name_of(first)} holds a number that is not finite: give finite ones")
    return motions
