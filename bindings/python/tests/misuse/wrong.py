"""Wrong values for arguments: whatever a script may hold in a variable of the wrong name."""

from __future__ import annotations

import fractions
from collections.abc import Iterator
from typing import Any

import numpy as np
from conftest import END, FACES, START

import tamis
import tamis.compat.ipctk as ipctk
from misuse.public import Argument


class _Unwilling:
    """Raises whenever it is converted: to an array, a number, a name of a file, a text."""

    def __array__(self, *given: Any, **named: Any) -> Any:
        raise RuntimeError("no array today")

    def __float__(self) -> float:
        raise RuntimeError("no number today")

    def __index__(self) -> int:
        raise RuntimeError("no whole number today")

    def __fspath__(self) -> str:
        raise RuntimeError("no name today")

    def __repr__(self) -> str:
        raise RuntimeError("no description today")


_MESH = tamis.Mesh(FACES)

# Values, with the kinds of arguments that may take them; for all other arguments they are wrong.
THINGS: dict[str, tuple[str, ...]] = {}
POOL: dict[str, Any] = {}


def _thing(name: str, value: Any, *suits: str) -> None:
    """Add a value; `suits`: the kinds of arguments that may take it."""
    POOL[name], THINGS[name] = value, suits


_thing("None", None, "nothing")
_thing("True", True, "truth", "index")
_thing("1.5", 1.5, "number")
_thing("nan", float("nan"))
_thing("inf", float("inf"))
_thing("-1", -1, "index")
_thing("-1.0", -1.0)
_thing("2**31", 2**31, "number")
_thing("2**70", 2**70, "number")
_thing("10**400", 10**400)
_thing("a complex number", 1j)
_thing("a fraction", fractions.Fraction(1, 2), "number")
_thing("''", "", "word")
_thing("'a'", "a", "word", "file")
_thing("half a character", "\ud800", "file")
_thing("a NUL", "a\0b")
_thing("bytes", b"a", "file")
_thing("[]", [], "array", "words", "arrays", "index")
_thing("a list of a string", ["a"], "words")
_thing("a list of None", [None], "index")
_thing("rows of several lengths", [[0, 1, 2], [0]])
_thing("a list of lists", [[[[0]]]])
_thing("a dictionary", {"start": 1})
_thing("a set", {1, 2})
_thing("a generator", (i for i in range(3)))
_thing("a function", lambda *given: None, "function")
_thing("a class", tamis.Mesh, "function")
_thing("an object", object())
_thing("an unwilling one", _Unwilling())
_thing("a mesh", _MESH, "Mesh")
_thing("a detector", tamis.Detector(_MESH))
_thing("an ipctk mesh", ipctk.CollisionMesh(START, ipctk.edges(FACES), FACES), "CollisionMesh")
_thing("a shape", tamis.Shape(_MESH, START), "Shape")
_thing("a deforming motion", tamis.Deforming(START, END), "Deforming")
_thing("a path", tamis.BezierPath(np.stack([START, START])), "Path")
_thing("contacts", tamis.contacts(FACES, START, END), "NamedPairs[Any]")
_thing("an array of objects", np.array([[None, object(), 1]] * 6, object))
_thing("numbers as objects", np.arange(18).reshape(6, 3).astype(object))
_thing("an array of words", np.array([["a", "b", "c"]] * 6))
_thing("an array of dates", np.zeros((6, 3), "datetime64[s]"))
_thing("an array of complex numbers", np.zeros((6, 3), complex))
_thing("an array with fields", np.zeros(6, [("x", "f8"), ("y", "f8"), ("z", "f8")]))
_thing("five dimensions", np.zeros((1, 1, 1, 1, 3)))
_thing("three dimensions too small", np.zeros((1, 1, 1)), "array")
_thing("a single number as an array", np.array(0.5), "number", "array")
_thing("nothing at all", np.empty((0, 3)), "array", "index")

_ANSWERS = ("None", "'a'", "[]", "nan", "an object", "an unwilling one", "2**70", "rows of several lengths")


def _spoilt(right: np.ndarray[Any, Any]) -> Iterator[tuple[str, Any, bool]]:
    """Yield copies of the right array with one thing wrong."""
    yield "one row less", right[:-1], False
    yield "one dimension more", np.asarray(right)[np.newaxis, np.newaxis, np.newaxis], True
    yield "one column more", np.concatenate([right, right[..., :1]], -1), False
    yield "objects", right.astype(object), True
    if np.issubdtype(right.dtype, np.integer):
        yield "floats for indices", right.astype(float), True
        yield "a negative index", _with(right, -1), False
        yield "too large an index", _with(right, 10**6), False
        yield "an index above 2^31", _with(right, 2**40), True
    else:
        yield "a NaN", _with(right, np.nan), True
        yield "infinity", _with(right, np.inf), True
        yield "long doubles", right * np.longdouble(1), False
        yield "huge numbers", _with(right, 1.7e308), False


def _with(right: np.ndarray[Any, Any], value: Any) -> np.ndarray[Any, Any]:
    changed = right.astype(np.int64 if isinstance(value, int) else float)
    changed.flat[0] = value
    return changed


def wrong_values(argument: Argument, right: Any) -> Iterator[tuple[str, Any, bool]]:
    """Yield name, value, and whether the value can have no meaning here, so that it must be refused."""
    for name, value in POOL.items():
        yield name, value, not set(THINGS[name]) & set(argument.takes)
    if isinstance(right, np.ndarray) and "array" in argument.takes:
        yield from _spoilt(right)
    if "function" in argument.takes:
        for name in _ANSWERS:
            yield f"a function that returns {name}", (lambda *given, it=POOL[name]: it), False
