"""What all answers with many rows have in common: one structured array that owns its memory."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np
import numpy.typing as npt


class Table:
    """Rows of one structured array; the columns are views of it."""

    __slots__ = ("_table",)
    _dtype: ClassVar[np.dtype[np.void]]

    def __init__(self, table: npt.NDArray[np.void] | npt.NDArray[np.uint8]) -> None:
        self._table: npt.NDArray[np.void] = table.view(self._dtype)

    @property
    def table(self) -> npt.NDArray[np.void]:
        """One structured array; its fields are the columns."""
        return self._table

    def __len__(self) -> int:
        return len(self._table)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, type(self)) and np.array_equal(self._table, other._table)

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[type[Any], tuple[npt.NDArray[np.void]]]:
        return type(self), (self._table,)
