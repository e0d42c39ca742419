// The colours of the page are those of the other outputs.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { colourOfTime, kObjectColours } from "../src/colours";

// The file in which Tamis has them; tests run in tools/viewer/.
const source = readFileSync(join("..", "files", "output", "colours.cpp"), "utf8");

function coloursIn(name: string): number[][] {
  const list = new RegExp(`${name}\\{\\{([^;]*)\\}\\};`).exec(source)?.[1];
  assert.ok(list, `no ${name} in tools/files/output/colours.cpp`);
  const numbers = [...list.matchAll(/0x([0-9a-f]{2})/g)].map(([, digits]) => parseInt(digits, 16));
  return Array.from({ length: numbers.length / 3 }, (_, i) => numbers.slice(3 * i, 3 * i + 3));
}

// Bug: a colour is changed in one place only, and two pictures of one step differ.
void test("times have the colours that glTF and pictures give them", () => {
  const steps = coloursIn("kPlasma");
  assert.ok(steps.length > 2);
  steps.forEach((colour, i) => {
    assert.deepEqual(colourOfTime(i / (steps.length - 1)), colour);
  });
});

void test("objects have the colours that pictures give them", () => {
  assert.deepEqual(coloursIn("kColours"), kObjectColours);
});
