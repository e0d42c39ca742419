// node --test package_test.mjs, in a project that has installed the package: every question, every refusal. TAMIS_HEADERS names
// the folder of the C interface's headers.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { called, functions } from "./scene.mjs";
import "./detectors.mjs";
import "./paths.mjs";
import "./worlds.mjs";
import "./planners.mjs";
import "./pairs.mjs";

/** Functions of C that no part of the package calls, and why. */
const LEFT_OUT = { tamis_has_threads: "the module has one thread" };

function declared(folder) {
  const headers = readdirSync(folder).filter((name) => name.endsWith(".h"));
  const text = headers.map((name) => readFileSync(join(folder, name), "utf8")).join("").replaceAll(/\/\*[^]*?\*\//g, "");
  return Array.from(text.matchAll(/^TAMIS_API [^(]*\b(tamis_\w+)\(/gm), (match) => match[1]).sort();
}

test("the package reaches every function of the C interface", () => {
  const headers = declared(process.env.TAMIS_HEADERS);
  assert(headers.length > 50);
  assert.deepEqual(functions.map((name) => name.slice(1)).sort(), headers, "module.js is older than the headers: scripts/program_module.sh");
  const expected = headers.filter((name) => !(name in LEFT_OUT));
  assert.deepEqual([...called].sort(), expected, "functions that no test here calls: offer them in bindings/npm/src, or name them in LEFT_OUT");
});
