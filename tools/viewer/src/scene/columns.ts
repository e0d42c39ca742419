// Reads columns of numbers as tools/files/view/columns.hpp writes them: bytes of one significance together, differences of rows.

/** Reads elements of `size` bytes: the lowest bytes of all elements come first, then the next bytes of all, ... */
export function fromPlanes(bytes: Uint8Array, size: number): Uint8Array<ArrayBuffer> {
  const count = bytes.length / size;
  const result = new Uint8Array(bytes.length);
  for (let byte = 0; byte < size; ++byte) {
    const plane = byte * count;
    for (let i = 0; i < count; ++i) result[i * size + byte] = bytes[plane + i];
  }
  return result;
}

/** Reads rows of `width` integers, each written as its folded difference from the row above. */
export function fromDifferences(bytes: Uint8Array, width: number): Uint32Array {
  const column = new Uint32Array(fromPlanes(bytes, 4).buffer);
  for (let i = 0; i < column.length; ++i) {
    const difference = (column[i] >>> 1) ^ -(column[i] & 1);
    column[i] = i < width ? difference : column[i - width] + difference;
  }
  return column;
}
