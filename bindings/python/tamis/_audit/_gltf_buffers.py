"""The numbers in the buffers of a glTF file."""

from __future__ import annotations

import base64
import binascii
import pathlib
import urllib.parse
from typing import Any

import numpy as np
import numpy.typing as npt

from tamis._arrays import Doubles
from tamis._errors import FileError

_NUMBERS = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_COLUMNS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


class Buffers:
    """Reads the accessors of a file as arrays."""

    def __init__(self, gltf: Any, name: str) -> None:
        self._gltf, self._name = gltf, name
        self._bytes: dict[int, bytes] = {}

    def doubles(self, accessor: int) -> Doubles:
        """Return an accessor's numbers as doubles, shape (n, columns); normalized integers as fractions."""
        given = self._gltf.accessors[accessor]
        array = self._array(accessor)
        if not given.normalized or array.dtype.kind == "f":
            return array.astype(np.float64)
        largest = np.iinfo(array.dtype).max
        fractions: Doubles = np.maximum(array.astype(np.float64) / largest, -1.0)
        return fractions

    def whole(self, accessor: int) -> npt.NDArray[np.int64]:
        """Return an accessor's whole numbers, shape (n, columns)."""
        return self._array(accessor).astype(np.int64)

    def _array(self, accessor: int) -> npt.NDArray[Any]:
        try:
            given = self._gltf.accessors[accessor]
            columns, dtype = _COLUMNS[given.type], np.dtype(_NUMBERS[given.componentType])
            if given.bufferView is None:
                array = np.zeros((given.count, columns), dtype)
            else:
                array = self._view(given.bufferView, given.byteOffset or 0, dtype, given.count, columns)
            return self._with_sparse(array.copy(), given)
        except (IndexError, KeyError, MemoryError, TypeError, ValueError) as error:
            raise FileError(
                f"{self._name}: accessor {accessor} is not sound ({error}): export the file again"
            ) from None

    def _view(self, view: int, offset: int, dtype: np.dtype[Any], count: int, columns: int) -> npt.NDArray[Any]:
        given = self._gltf.bufferViews[view]
        first = (given.byteOffset or 0) + offset
        stride = given.byteStride or columns * dtype.itemsize
        return np.ndarray((count, columns), dtype, self._buffer(given.buffer), first, (stride, dtype.itemsize))

    def _with_sparse(self, array: npt.NDArray[Any], given: Any) -> npt.NDArray[Any]:
        if given.sparse is None or not given.sparse.count:
            return array
        sparse = given.sparse
        kind = np.dtype(_NUMBERS[sparse.indices.componentType])
        places = self._view(sparse.indices.bufferView, sparse.indices.byteOffset or 0, kind, sparse.count, 1)
        values = self._view(
            sparse.values.bufferView, sparse.values.byteOffset or 0, array.dtype, sparse.count, array.shape[1]
        )
        array[places[:, 0]] = values
        return array

    def _buffer(self, buffer: int) -> bytes:
        if buffer not in self._bytes:
            self._bytes[buffer] = self._read(self._gltf.buffers[buffer].uri)
        return self._bytes[buffer]

    def _read(self, uri: str | None) -> bytes:
        if uri is None:
            return self._gltf.binary_blob() or b""
        try:
            if uri.startswith("data:"):
                return base64.b64decode(uri.partition(",")[2], validate=True)
            return (pathlib.Path(self._name).parent / urllib.parse.unquote(uri)).read_bytes()
        except (OSError, binascii.Error) as error:
            raise FileError(
                f"{self._name}: its buffer {uri[:60]} cannot be read ({error}): copy it beside the file"
            ) from None
