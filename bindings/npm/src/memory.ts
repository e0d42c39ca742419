import type { Module } from "./module.js";

/** Numbers as you have them: an array, or a typed one. Float64Array and Int32Array go into the module as they are. */
export type Numbers = ArrayLike<number>;

/** The library's refusal, in its own words. */
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

export function need(holds: boolean, message: string, status = 1): asserts holds {
  if (!holds) throw new TamisError(message, status);
}

/** Refuses a misspelt option, which would do nothing. */
export function only(given: object, what: string, ...names: string[]): void {
  for (const name of Object.keys(given)) need(names.includes(name), `${what} have no '${name}': use ${names.join(", ")}`, 4);
}

/** An integer of 32 bits: the module would cut off the fraction. */
export function whole(x: number, name: string): number {
  need((x | 0) === x, `${name} is ${x}: give a whole number`);
  return x;
}

/** How many rows of so many numbers there are. */
export function rowsOf(numbers: Numbers, width: number, name: string, row: string): number {
  need(width > 0 ? numbers.length % width === 0 : numbers.length === 0, `${name} has ${numbers.length} numbers: give ${width} for each ${row}`);
  return width > 0 ? numbers.length / width : 0;
}

/** What a function of the user has thrown. It waits until the question has ended: nothing is thrown through C. */
let thrown: { error: unknown } | null = null;
export function rethrow(): void {
  const kept = thrown;
  thrown = null;
  if (kept) throw kept.error;
}

/** Memory of the module that one owner holds, and frees at once. Growth of the memory moves no pointer. */
export class Memory {
  private readonly held: number[] = [];
  private readonly functions: number[] = [];
  isFree = false;

  constructor(readonly module: Module) {}

  /** Room for so many bytes, all zero; at a multiple of eight. */
  room(bytes: number): number {
    const place = this.module._malloc(Math.max(bytes, 1));
    need(place !== 0, `no memory for ${bytes} bytes: take a smaller mesh, or free detectors`, 7);
    this.module.HEAPU8.fill(0, place, place + bytes);
    this.held.push(place);
    return place;
  }

  /** A copy of integers; 0, which is NULL, if there are none. */
  integers(numbers: Numbers): number {
    if (!(numbers instanceof Int32Array)) for (let i = 0; i < numbers.length; ++i) whole(numbers[i], `number ${i} of ${numbers.length}`);
    return this.copy(numbers, "HEAP32", 4);
  }
  /** A copy of doubles; 0 if there are none. */
  doubles(numbers: Numbers): number {
    return this.copy(numbers, "HEAPF64", 8);
  }
  /** A copy of one number; 0 if it is not given. */
  optional(number: number | undefined): number {
    return number === undefined ? 0 : this.doubles([number]);
  }

  /** A C struct that begins with its size; then 32-bit words from the second on, and doubles by the bytes before them. */
  struct(bytes: number, words: readonly number[], doubles: Record<number, Numbers> = {}): number {
    return this.fill(this.room(bytes), [bytes, ...words], doubles);
  }
  /** Writes words from a place on, and doubles by the bytes between. */
  fill(place: number, words: readonly number[], doubles: Record<number, Numbers>): number {
    this.module.HEAP32.set(words, place / 4);
    for (const [bytes, numbers] of Object.entries(doubles)) this.module.HEAPF64.set(numbers, (place + Number(bytes)) / 8);
    return place;
  }

  /** A function that C calls. Once one has thrown, `failed` answers until the question has ended. */
  callback(f: (...numbers: number[]) => number, signature: string, failed: (...numbers: number[]) => number): number {
    const place = this.module.addFunction((...numbers) => {
      try {
        return thrown ? failed(...numbers) : f(...numbers);
      } catch (error) {
        thrown = { error };
        return failed(...numbers);
      }
    }, signature);
    this.functions.push(place);
    return place;
  }

  /** Views of the memory itself: no copies. They end when the memory grows or is freed. */
  viewOfIntegers(place: number, length: number): Int32Array<ArrayBuffer> {
    return this.module.HEAP32.subarray(place / 4, place / 4 + length);
  }
  viewOfDoubles(place: number, length: number): Float64Array<ArrayBuffer> {
    return this.module.HEAPF64.subarray(place / 8, place / 8 + length);
  }
  viewOfBytes(place: number, length: number): Uint8Array<ArrayBuffer> {
    return this.module.HEAPU8.subarray(place, place + length);
  }

  free(): void {
    this.isFree = true;
    for (const place of this.held.splice(0)) this.module._free(place);
    for (const place of this.functions.splice(0)) this.module.removeFunction(place);
  }

  /** The room may make the memory grow, which ends views of it: such a one is copied before. */
  private copy(numbers: Numbers, heap: "HEAP32" | "HEAPF64", bytes: number): number {
    if (ArrayBuffer.isView(numbers) && numbers.byteLength === 0) refuseEnded(numbers);
    if (numbers.length === 0) return 0;
    const isOwn = ArrayBuffer.isView(numbers) && numbers.buffer === this.module.HEAPU8.buffer;
    const kept = isOwn ? (numbers as unknown as Float64Array).slice() : numbers;
    const place = this.room(bytes * kept.length);
    this.module[heap].set(kept, place / bytes);
    return place;
  }
}

function refuseEnded({ buffer }: ArrayBufferView): void {
  try {
    new Uint8Array(buffer);
  } catch {
    throw new TamisError("these numbers are a view of memory that has grown since: read them anew, or copy what you keep", 1);
  }
}

/** Runs `use` with memory that it alone needs. */
export function within<T>(module: Module, use: (given: Memory) => T): T {
  const given = new Memory(module);
  try {
    return use(given);
  } finally {
    given.free();
  }
}
