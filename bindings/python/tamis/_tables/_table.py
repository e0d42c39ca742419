"""The base of all answers with many rows: a table around one structured array that owns its memory."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Generic, NoReturn, TypeVar, overload

import numpy as np
import numpy.typing as npt

from tamis._checks import shown
from tamis._errors import Error

if TYPE_CHECKING:
    import pandas

Row = TypeVar("Row")
Part = TypeVar("Part", bound="Table[Any]")
Array = TypeVar("Array", bound="npt.NDArray[Any]")


class Column(Generic[Array]):
    """A column of a `Table`: the field with this name of its array, as a read-only property with a docstring."""

    def __init__(self, doc: str) -> None:
        self.__doc__ = doc

    def __set_name__(self, owner: type, name: str) -> None:
        self._name = name

    def __get__(self, table: Any, owner: type | None = None) -> Array:
        return self if table is None else table._table[self._name]  # type: ignore[return-value]

    def __set__(self, table: Any, value: NoReturn) -> None:
        raise AttributeError(f"{self._name} is a column of {type(table).__name__} and cannot be replaced")


class Table(Generic[Row]):
    """Rows of one structured array; the columns are views of it.

    `len()` counts the rows; an integer index gives a row, any other index of an array gives a table.
    """

    __slots__ = ("_table",)
    _dtype: ClassVar[np.dtype[np.void]]
    _record: ClassVar[Callable[..., Any]]  # makes a Row

    def __init__(self, table: npt.NDArray[np.void] | npt.NDArray[np.uint8]) -> None:
        self._table: npt.NDArray[np.void] = _as_rows(table, self._dtype, type(self).__name__)

    @property
    def table(self) -> npt.NDArray[np.void]:
        """The structured array, shape (n,), whose fields are the columns."""
        return self._table

    def to_pandas(self) -> pandas.DataFrame:
        """Return a DataFrame with the columns of the command's tables. pandas must be installed."""
        import pandas as pd

        return pd.DataFrame(self._columns())

    def _columns(self) -> dict[str, npt.NDArray[Any]]:
        raise NotImplementedError

    def _fields(self, values: Sequence[Any]) -> tuple[Any, ...]:
        """Return the arguments of `_record`, from the fields of one row."""
        raise NotImplementedError

    def _row(self, values: Sequence[Any], index: int) -> Row:
        """Return one row as a named tuple; `index` is its place, for subclasses that keep data outside the array."""
        row: Row = self._record(*self._fields(values))
        return row

    def _part(self: Part, table: npt.NDArray[np.void], index: Any) -> Part:
        """Return a table of the rows that `index` chose."""
        return type(self)(table)

    def __len__(self) -> int:
        return len(self._table)

    def __iter__(self) -> Iterator[Row]:
        return (self._row(values, index) for index, values in enumerate(self._table.tolist()))

    @overload
    def __getitem__(self, index: int | np.integer[Any]) -> Row: ...
    @overload
    def __getitem__(self: Part, index: slice | npt.NDArray[Any] | list[int] | list[bool]) -> Part: ...
    def __getitem__(self, index: Any) -> Any:
        try:
            chosen = self._table[index]
        except (IndexError, KeyError, TypeError, ValueError):
            raise self._no_rows(index) from None
        if chosen.dtype != self._dtype or chosen.ndim > 1:
            raise self._no_rows(index)
        if isinstance(chosen, np.ndarray) and chosen.ndim:
            return self._part(chosen, index)
        return self._row(chosen.tolist(), index)

    def _no_rows(self, index: object) -> IndexError:
        advice = "give integers, slices or masks; columns are attributes"
        return IndexError(f"the index {shown(index)} chooses none of {len(self)} rows: {advice}")

    def __eq__(self, other: object) -> bool:
        return isinstance(other, type(self)) and np.array_equal(self._table, other._table)

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[type[Any], tuple[Any, ...]]:
        return type(self), (self._table,)


def bracket_of(
    found: tuple[float, float, npt.NDArray[np.uint8]], table: Callable[[npt.NDArray[np.uint8]], Table[Row]]
) -> tuple[float, float, Row | None]:
    """Return the compiled part's answer with its only row, if it has one, as a row of the table."""
    lower, upper, rows = found
    return lower, upper, next(iter(table(rows)), None)


def _as_rows(given: Any, dtype: np.dtype[np.void], name: str) -> npt.NDArray[np.void]:
    is_array = isinstance(given, np.ndarray) and given.ndim == 1
    if is_array and given.dtype == dtype:
        return given  # type: ignore[no-any-return]
    if is_array and given.dtype == np.uint8 and len(given) % dtype.itemsize == 0:
        return given.view(dtype)  # type: ignore[no-any-return]
    raise Error(f"{shown(given)} is not a table of {name}: take what a question has returned, or its `table`")
