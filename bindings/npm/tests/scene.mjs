// Two triangles, whose corner 3 falls; and other things that the tests share.
import assert from "node:assert/strict";
import { load, TamisError } from "tamis";

export const tamis = await load();
/** The functions of C that tests have called. Each replaces itself in the module when it is first called. */
export const called = new Set();
export const functions = Object.keys(tamis.module).filter((name) => name.startsWith("_tamis_"));
for (const name of functions) {
  const original = tamis.module[name];
  tamis.module[name] = (...numbers) => (called.add(name.slice(1)), original(...numbers));
}

export const faces = [0, 1, 2, 3, 4, 5];
export const start = Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, 1, 1, 0.5, 2, 0.5, 1, 2);
export const end = start.map((x, i) => (i === 11 ? -1 : x));
export const two = (options) => tamis.detector({ faces }, options);
export const refuses = (f, sentence, status) =>
  assert.throws(f, (error) => error instanceof TamisError && sentence.test(error.message) && error.status === status);
export function brackets(found, time) {
  const { toiLower, toiUpper } = found;
  assert(toiLower <= time && time <= toiUpper && toiUpper - toiLower < 1e-6, `${time} is not in [${toiLower}, ${toiUpper}]`);
}
export function near(a, b, most = 1e-12) {
  assert(Math.abs(a - b) <= most, `${a} is not ${b}`);
}
