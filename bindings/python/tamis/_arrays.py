"""Arguments of users as arrays that the compiled part takes: views where possible, else one copy."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from tamis._checks import shown
from tamis._errors import Error, InvalidStep
from tamis._kinds import PairKind

Doubles = npt.NDArray[np.float64]
Indices = npt.NDArray[np.int32]
Groups = npt.NDArray[np.uint8]

_DOUBLE = np.dtype(np.float64)


# Doubles hold all integers up to here.
_FIRST_GAP = 2.0**53

_REAL = "floating-point numbers or integers"
_WHOLE = "integers below 2^31"


def _advice(given: npt.ArrayLike, wanted: str) -> str:
    """Return what to give: of a mesh file, or another package's mesh, where numbers are wanted, its positions."""
    parts = [part for part in ("positions", "vertices") if hasattr(given, part)] if wanted.startswith(_REAL) else []
    return f"its .{parts[0]}" if parts else wanted


def _array(given: npt.ArrayLike, name: str, error: type[Error], kinds: str, wanted: str) -> npt.NDArray[Any]:
    """Return an array whose `dtype.kind` is one of `kinds`; `name` and `wanted` go into the sentence of the error."""
    if isinstance(given, np.ma.MaskedArray):
        raise error(f"{name} is a masked array, whose mask would be lost: give its .filled(...) or .data")
    try:
        array = np.asarray(given)
    except (TypeError, ValueError, OverflowError):  # for example rows of different lengths
        advice = _advice(given, f"{wanted}, as many in each row")
        raise error(f"{name} is {shown(given)}, which is not an array: give {advice}") from None
    if array.dtype.kind not in kinds:
        raise error(f"{name} is {shown(given)}, of the dtype {array.dtype}: give {_advice(given, wanted)}")
    return array


def numbers(given: npt.ArrayLike, name: str, error: type[Error]) -> npt.NDArray[Any]:
    """Return an array of real numbers, of any shape; raise if a double would round one of them."""
    array = _array(given, name, error, "iuf", _REAL)
    if array.dtype.itemsize > 4 and array.dtype != _DOUBLE:
        _require_doubles(array, name, error)
    elif array.dtype == _DOUBLE and not hasattr(given, "dtype") and (np.abs(array) >= _FIRST_GAP).any():
        whole = [x for x in np.asarray(given, dtype=object).flat if isinstance(x, (int, np.integer))]
        _require_doubles(np.asarray(whole, dtype=object), name, error)
    return array


def _require_doubles(array: npt.NDArray[Any], name: str, error: type[Error]) -> None:
    """Raise if a number is not a double: an integer beyond 2^53, or one of more digits than a double has."""
    with np.errstate(over="ignore"):  # what becomes infinite is refused
        nearest = array.astype(_DOUBLE)
    # Compared by their former values: NumPy would compare integers with doubles as doubles.
    if array.dtype.kind == "f":
        wrong = (nearest.astype(array.dtype) != array) & ~np.isnan(array)
        candidates = array[wrong]
    else:
        large = (nearest >= _FIRST_GAP) | (nearest <= -_FIRST_GAP)
        candidates = array[large]
        candidates = candidates[[int(x) != int(d) for x, d in zip(candidates, nearest[large])]]
    if candidates.size > 0:
        first = candidates.flat[0]
        raise error(f"{name} holds {first!s}, which a double would round: subtract an offset, or give doubles")


def shape_text(array: npt.NDArray[Any]) -> str:
    """Return the shape as error messages show it."""
    return f"({', '.join(str(n) for n in array.shape)})"


def _is_view(array: npt.NDArray[Any]) -> bool:
    """Whether the library can read the rows in place."""
    return (
        array.dtype == _DOUBLE
        and array.dtype.isnative
        and array.flags.aligned
        and (array.shape[0] <= 1 or (array.strides[0] >= 24 and array.strides[0] % 8 == 0))
        and array.strides[1] == 8
    )


def doubles(array: npt.NDArray[Any]) -> Doubles:
    """Return contiguous doubles: the array itself if it is that already, else a copy."""
    return np.require(array, dtype=_DOUBLE, requirements=["C", "ALIGNED"])


def rows(given: npt.ArrayLike, name: str, error: type[Error] = InvalidStep) -> Doubles:
    """Return n rows of three doubles, shape (n, 3). Copies only rows that cannot be read in place, at any stride."""
    array = numbers(given, name, error)
    if array.ndim != 2 or array.shape[1] != 3:
        raise error(f"{name} has the shape {shape_text(array)}: give one row of three numbers a vertex, (n, 3)")
    return array if _is_view(array) else doubles(array)


def packed_rows(given: npt.ArrayLike, name: str, error: type[Error] = InvalidStep) -> Doubles:
    """Return n rows of three doubles, contiguous; copies them if they are not."""
    return doubles(rows(given, name, error))


def finite(array: Doubles, name: str, error: type[Error]) -> Doubles:
    """Return the array; raise if a number in it is not finite, for arrays that the compiled part does not check."""
    if not np.isfinite(array).all():
        place = np.argwhere(~np.isfinite(array))[0].tolist()
        raise error(f"{name} holds a number that is not finite, at {place}: give finite ones")
    return array


def point_frames(given: npt.ArrayLike, name: str, error: type[Error]) -> Doubles:
    """Return frames of points as contiguous doubles, shape (f, n, 3)."""
    array = numbers(given, name, error)
    if array.ndim != 3 or array.shape[2] != 3:
        raise error(f"{name} has the shape {shape_text(array)}: give three numbers a vertex and frame, (f, n, 3)")
    return doubles(array)


def vector(given: npt.ArrayLike, name: str, error: type[Error]) -> Doubles:
    """Return contiguous doubles, shape (n,)."""
    array = numbers(given, name, error)
    if array.ndim != 1:
        raise error(f"{name} has the shape {shape_text(array)}: give one dimension")
    return doubles(array)


def indices_or_none(given: npt.ArrayLike | None, columns: int, name: str, error: type[Error]) -> Indices:
    """Return indices as `indices` does; none for None."""
    return indices([] if given is None else given, columns, name, error)


def indices(
    given: npt.ArrayLike, columns: int, name: str, error: type[Error], *, one_may_come_alone: bool = False
) -> Indices:
    """Return contiguous 32-bit indices, shape (n, columns), or (n,) if `columns` is 0. [] has the shape of no rows.

    With `one_may_come_alone`, one row without the first dimension is taken for n = 1.
    """
    shape = (0, columns) if columns else (0,)
    array = _array(given, name, error, "iuf", _WHOLE)
    if array.size == 0:
        return np.empty(shape, np.int32)
    given_shape = shape_text(array)
    if one_may_come_alone and array.ndim == len(shape) - 1:
        array = array[np.newaxis]
    if array.ndim != len(shape) or (columns and array.shape[1] != columns):
        wanted = (f"(n, {columns})" if columns else "(n,)") + (", or one alone" if one_may_come_alone else "")
        raise error(f"{name} has the shape {given_shape}: give {wanted}")
    if array.dtype.kind == "f":
        raise error(f"{name} has the dtype {array.dtype}: give {_WHOLE}")
    if array.dtype != np.int32:
        limits = np.iinfo(np.int32)
        wrong = (array < limits.min) | (array > limits.max)
        if wrong.any():
            raise error(f"{name} holds {array[wrong][0]}: give {_WHOLE}")
    return np.require(array, dtype=np.int32, requirements=["C", "ALIGNED"])


def flags(given: npt.ArrayLike, name: str, error: type[Error]) -> Groups:
    """Return a square matrix of truth values, shape (g, g), contiguous, one byte each."""
    array = _array(given, name, error, "bui", "True or False")
    if array.ndim != 2 or array.shape[0] != array.shape[1]:
        raise error(f"{name} has the shape {shape_text(array)}: give a square matrix, one row and one column a group")
    return np.ascontiguousarray(array != 0).view(np.uint8)


def pair_list(kind: npt.ArrayLike, vertices: npt.ArrayLike, error: type[Error]) -> tuple[Groups, Indices]:
    """Return kinds, shape (n,), and vertices, shape (n, 4), of pairs; one kind may serve for all, one pair be (4,)."""
    given = indices(vertices, 4, "vertices", error, one_may_come_alone=True)
    kinds = np.atleast_1d(_array(kind, "kind", error, "iuf", "a PairKind"))
    if kinds.dtype != np.uint8 or kinds.ndim != 1:
        kinds = indices(kinds, 0, "kind", error)
    if len(kinds) not in (1, len(given)):
        raise error(f"kind has {len(kinds)} entries, vertices {len(given)} rows: give as many, or one kind for all")
    wrong = (kinds < 0) | (kinds >= len(PairKind))
    if wrong.any():
        raise error(f"kind holds {kinds[wrong][0]}, which is not a kind of pair: give a PairKind")
    return np.ascontiguousarray(np.broadcast_to(kinds, len(given)), dtype=np.uint8), given
