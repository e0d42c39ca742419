"""Worlds of bodies, each with its own shape and motion."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tamis import _core
from tamis._options import Isa, make_options
from tamis._statistics import Statistics
from tamis._world._changes import Changes
from tamis._world._edges import EdgeQuestions
from tamis._world._questions import Questions


class World(Changes, Questions, EdgeQuestions):
    """Bodies, each with its own shape and motion, and the questions of a `Detector` about them.

    During t in [0, 1] each body moves as it was told last. A body with a pose stays there; a body with a chain moves by
    it as a whole; each vertex of a `Deforming` body goes straight. Bodies that do not deform cost nothing to keep, and
    pairs of bodies that are far from each other next to nothing. If neither body of a pair turns, its contacts are
    decided exactly, as in a step. If one turns, they are answers about a `Path`: proven free, certified with a bracket
    no wider than the tolerance, or not certified.

    Other Python threads run during a question, and Ctrl-C ends it. A question or change during a question raises
    `Busy`. Functions that name a body raise `InvalidOptions`, and change nothing, if the world never had it or has it
    no more. The answers do not depend on the number of threads, on the machine, or on earlier questions.

    Parameters
    ----------
    threads : int
        The number of threads to use, >= 0; 0: all. Changes speed only.
    min_separation : float
        d >= 0, in the unit of the points: contact means Euclidean distance <= d. A question may have its own.
    isa : str
        Instruction set: "best", "baseline", "avx2", "avx512". Changes speed only.
    rings : int
        As in `Detector`, for deforming bodies with themselves.
    is_cancelled : callable, optional
        As in `Detector`.

    Raises
    ------
    InvalidOptions
        An option outside its range, an unknown name, or an instruction set that this machine lacks.

    Examples
    --------
    Two triangles; the second falls onto the first:

    >>> triangle = Shape(Mesh([[0, 1, 2]]), [[0, 0, 0], [1, 0, 0], [0, 1, 0]])
    >>> world = World()
    >>> ground = world.add(triangle)
    >>> above, below = [[0.1, 0.1, 1], [0, 0, 0]], [[0.1, 0.1, -1], [0, 0, 0]]
    >>> falling = world.add(triangle, interpolated_chain(above, below))
    >>> round(world.earliest().toi_lower, 9)
    0.5
    """

    __slots__ = ("_description", "_world")

    def __init__(
        self,
        *,
        threads: int = 0,
        min_separation: float = 0.0,
        isa: Isa = "best",
        rings: int = 1,
        is_cancelled: Callable[[], bool] | None = None,
    ) -> None:
        options = make_options(
            threads=threads,
            min_separation=min_separation,
            isa=isa,
            rings=rings,
            is_cancelled=is_cancelled,
        )
        self._world = _core.World(options)
        self._description = f"min_separation={float(min_separation):g}"

    @property
    def statistics(self) -> Statistics:
        """The cost of the last question; `memory_bytes` does not count shapes."""
        return Statistics(**self._world.statistics())

    def __repr__(self) -> str:
        return f"World({self._description})"

    def __reduce__(self) -> Any:
        raise TypeError("a World cannot be pickled: pickle its shapes, and make a World where you need it")
