"""What users give, as the arrays that the compiled part takes: a view where that is possible, else one copy."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from tamis._errors import Error, InvalidStep

Doubles = npt.NDArray[np.float64]
Indices = npt.NDArray[np.int32]
Groups = npt.NDArray[np.uint8]

_DOUBLE = np.dtype(np.float64)


def _numbers(given: npt.ArrayLike, name: str, error: type[Error]) -> npt.NDArray[Any]:
    """Make an array of integers or floating-point numbers; anything else is refused with a sentence."""
    try:
        array = np.asarray(given)
    except (TypeError, ValueError) as reason:
        raise error(f"{name} is no array of numbers ({reason}): give numbers") from None
    if array.dtype.kind not in "iuf":
        raise error(f"{name} has the dtype {array.dtype}: give integers or floating-point numbers")
    return array


def _shape(array: npt.NDArray[Any]) -> str:
    return f"({', '.join(str(n) for n in array.shape)})"


def _is_view(array: npt.NDArray[Any]) -> bool:
    """Whether the library can walk the rows as they lie in memory."""
    return (
        array.dtype == _DOUBLE
        and array.dtype.isnative
        and array.flags.aligned
        and (array.shape[0] <= 1 or (array.strides[0] >= 24 and array.strides[0] % 8 == 0))
        and array.strides[1] == 8
    )


def rows(given: npt.ArrayLike, name: str, error: type[Error] = InvalidStep) -> Doubles:
    """Return n rows of three doubles, without a copy if they lie so already, also with a stride between rows."""
    array = _numbers(given, name, error)
    if array.ndim != 2 or array.shape[1] != 3:
        raise error(f"{name} has the shape {_shape(array)}: give one row of three numbers a vertex, (n, 3)")
    return array if _is_view(array) else np.require(array, dtype=_DOUBLE, requirements=["C", "ALIGNED"])


def pairs(given: npt.ArrayLike, corners: int, name: str) -> Doubles:
    """Return n pairs of so many points, without a copy if they are contiguous doubles; one pair may come alone."""
    array = _numbers(given, name, InvalidStep)
    if array.shape == (corners, 3):
        array = array[np.newaxis]
    if array.ndim != 3 or array.shape[1:] != (corners, 3):
        raise InvalidStep(
            f"{name} has the shape {_shape(array)}: give {corners} points of three numbers a pair, (n, {corners}, 3)"
        )
    return np.require(array, dtype=_DOUBLE, requirements=["C", "ALIGNED"])


def point_frames(given: npt.ArrayLike, name: str, error: type[Error]) -> Doubles:
    """Return contiguous doubles, so many frames of points: (f, n, 3)."""
    array = _numbers(given, name, error)
    if array.ndim != 3 or array.shape[2] != 3:
        raise error(f"{name} has the shape {_shape(array)}: give three numbers a vertex and frame, (f, n, 3)")
    return np.require(array, dtype=_DOUBLE, requirements=["C", "ALIGNED"])


def table(given: npt.ArrayLike, name: str, error: type[Error]) -> Doubles:
    """Return contiguous doubles in two dimensions."""
    array = _numbers(given, name, error)
    if array.ndim != 2:
        raise error(f"{name} has the shape {_shape(array)}: give two dimensions")
    return np.require(array, dtype=_DOUBLE, requirements=["C", "ALIGNED"])


def vector(given: npt.ArrayLike, name: str, error: type[Error]) -> Doubles:
    """Return contiguous doubles in one dimension."""
    array = _numbers(given, name, error)
    if array.ndim != 1:
        raise error(f"{name} has the shape {_shape(array)}: give one dimension")
    return np.require(array, dtype=_DOUBLE, requirements=["C", "ALIGNED"])


def indices(given: npt.ArrayLike | None, columns: int, name: str, error: type[Error]) -> Indices:
    """Return contiguous 32-bit indices, `columns` a row (0: in one dimension); None and [] are none."""
    shape = (0, columns) if columns else (0,)
    if given is None:
        return np.empty(shape, np.int32)
    array = _numbers(given, name, error)
    if array.size == 0:
        return np.empty(shape, np.int32)
    if array.ndim != len(shape) or (columns and array.shape[1] != columns):
        wanted = f"(n, {columns})" if columns else "(n,)"
        raise error(f"{name} has the shape {_shape(array)}: give {wanted}")
    if array.dtype.kind == "f":
        raise error(f"{name} has the dtype {array.dtype}: give integers")
    limits = np.iinfo(np.int32)
    wrong = (array < limits.min) | (array > limits.max)
    if wrong.any():
        raise error(f"{name} holds {array[wrong][0]}: give indices below 2^31")
    return np.require(array, dtype=np.int32, requirements=["C", "ALIGNED"])


def pair_list(kind: npt.ArrayLike, vertices: npt.ArrayLike, error: type[Error]) -> tuple[Groups, Indices]:
    """Return kinds (n,) and vertices (n, 4) of pairs of features; one kind may serve for all, one pair come alone."""
    given = indices(np.atleast_2d(_numbers(vertices, "vertices", error)), 4, "vertices", error)
    kinds = indices(np.atleast_1d(_numbers(kind, "kind", error)), 0, "kind", error)
    if len(kinds) not in (1, len(given)):
        raise error(f"kind has {len(kinds)} entries, vertices {len(given)} rows: give as many, or one kind for all")
    wrong = (kinds < 0) | (kinds > 3)
    if wrong.any():
        raise error(f"kind holds {kinds[wrong][0]}, which is none: give a PairKind")
    return np.ascontiguousarray(np.broadcast_to(kinds, len(given)), dtype=np.uint8), given
