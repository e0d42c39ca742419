"""Bodies, each with its own mesh and its own way of moving."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tamis import _core
from tamis._options import Isa, make_options
from tamis._statistics import Statistics
from tamis._world._changes import Changes
from tamis._world._questions import Questions


class World(Changes, Questions):
    """Bodies, each with its own shape and motion, and the questions of a `Detector` about them.

    Each body moves during t in [0, 1] as it was told last. What does not deform costs nothing to keep, and bodies far
    from each other next to nothing. A body that has a pose stays there; one that has a chain moves by it as a whole;
    one that is `Deforming` goes straight, vertex by vertex. Where no rotation of a chain changes, contacts are decided
    exactly, as of a step; where one turns, as on a `Path`: proven free, or with a bracket as narrow as the tolerance,
    or not certified.

    Other Python threads run meanwhile, Ctrl-C ends a question, and a question or change during a question raises
    `Busy`. Whatever names a body that is not there, or no more, raises `InvalidOptions`, and has then changed nothing.
    The answers do not depend on the number of threads, on the machine, or on earlier questions.

    Parameters
    ----------
    threads : int
        To use; 0: all. Speed only.
    min_separation : float
        d >= 0 in the unit of the points: contact means Euclidean distance <= d. A question may bring its own.
    isa : str
        Instruction set: "best", "baseline", "avx2", "avx512". Speed only.
    rings : int
        As of `Detector`: of deforming bodies with themselves.
    is_cancelled : callable, optional
        Asked some 20 times a second during a question; True ends it with `Cancelled`.

    Raises
    ------
    InvalidOptions
        An option outside its range, or an unknown name.
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
        """What the last question cost; `memory_bytes` without shapes."""
        return Statistics(**self._world.statistics())

    def __repr__(self) -> str:
        return f"World({self._description})"

    def __reduce__(self) -> Any:
        raise TypeError("a World cannot be pickled: pickle its shapes, and make a World where you need it")
