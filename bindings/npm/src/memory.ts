import type { Module } from "./module.js";

/** What the library refuses, in its own words. */
export class TamisError extends Error {
  override name = "TamisError";
  constructor(
    message: string,
    /** `tamis_status` of the C interface. */
    readonly status: number,
  ) {
    super(message);
  }
}

/** Memory of the module that one owner holds, and frees at once. Growth of the memory moves no pointer. */
export class Memory {
  private readonly held: number[] = [];

  constructor(readonly module: Module) {}

  /** Room for so many bytes, all zero; at a multiple of eight. */
  room(bytes: number): number {
    const place = this.module._malloc(Math.max(bytes, 1));
    if (place === 0) throw new TamisError(`no memory for ${bytes} bytes: take a smaller mesh, or free detectors`, 7);
    this.module.HEAPU8.fill(0, place, place + bytes);
    this.held.push(place);
    return place;
  }

  /** A copy of integers; 0, which is NULL, if there are none. */
  integers(numbers: ArrayLike<number>): number {
    if (numbers.length === 0) return 0;
    const place = this.room(4 * numbers.length);
    this.module.HEAP32.set(numbers, place / 4);
    return place;
  }

  /** A copy of doubles; 0 if there are none. */
  doubles(numbers: ArrayLike<number>): number {
    if (numbers.length === 0) return 0;
    const place = this.room(8 * numbers.length);
    this.module.HEAPF64.set(numbers, place / 8);
    return place;
  }

  /** A C struct whose size_t, pointers and 32-bit integers are these, four bytes each, and whose size is `bytes`. */
  struct(bytes: number, words: ArrayLike<number>): number {
    const place = this.room(bytes);
    this.module.HEAPU32.set([bytes], place / 4);
    this.module.HEAP32.set(words, place / 4 + 1);
    return place;
  }

  /** Views of the memory itself: no copies. They end when the memory grows or is freed. */
  viewOfIntegers(place: number, length: number): Int32Array<ArrayBuffer> {
    return this.module.HEAP32.subarray(place / 4, place / 4 + length);
  }
  viewOfDoubles(place: number, length: number): Float64Array<ArrayBuffer> {
    return this.module.HEAPF64.subarray(place / 8, place / 8 + length);
  }

  free(): void {
    for (const place of this.held.splice(0)) this.module._free(place);
  }
}
