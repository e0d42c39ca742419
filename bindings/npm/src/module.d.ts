/** `module.js`, which pack.mjs writes: the C interface as emscripten compiles it. Pointers are places in the module's memory. */
export interface Module {
  HEAPU8: Uint8Array<ArrayBuffer>;
  HEAP32: Int32Array<ArrayBuffer>;
  HEAPU32: Uint32Array<ArrayBuffer>;
  HEAPF64: Float64Array<ArrayBuffer>;
  UTF8ToString(place: number): string;
  addFunction(f: (...numbers: number[]) => number, signature: string): number;
  removeFunction(place: number): void;
  _malloc(bytes: number): number;
  _free(place: number): void;
  [name: `_tamis_${string}`]: (...numbers: number[]) => number;
}
/** Compiles the module, anew with each call. */
export function createModule(): Promise<Module>;
/** The package's version. */
export const version: string;
