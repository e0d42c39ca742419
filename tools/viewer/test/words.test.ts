// The sentences for steps without contacts.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { badFrames, firstBadStep, type SceneHeader, type Strip } from "../src/scene/header";
import { nothingFound, percentWithout, shareOf, withoutContacts } from "../src/scene/proofs";

const step = { contacts: {}, toi_upper: null, stages: [], complete: true, ignored: 0 };

// Bug: a piece of a path in which no contact begins is called free, though a pair that met before still touches.
void test("only what is proven free is called so", () => {
  assert.equal(withoutContacts({ ...step, toi_lower: null }), "the step is free, proven.");
  assert.ok(withoutContacts({ ...step, toi_lower: 0 }).endsWith("may touch."));
  assert.ok(withoutContacts({ ...step, toi_lower: 0.5 }).endsWith("may touch from 0.500000 on."));
});

// Bug: of a frame to which no step leads the page says that nothing was found in the step to it.
void test("a step that was not asked about is not spoken of as if it was", () => {
  const header = { names: ["0", "1"], strip: { asks_intersections: true } };
  const sentence = (ends: [number, number]): string =>
    nothingFound(header as unknown as SceneHeader, { ...step, toi_lower: null, ends });
  assert.ok(sentence([0, 1]).endsWith("nor in the step to it."));
  assert.ok(sentence([1, 1]).endsWith("no step to it was asked about."));
});

// Bug: a frame in which an object has collapsed is called free, as its pairs are not listed.
void test("of what has collapsed nothing is called free", () => {
  const header = { names: ["0", "1"], strip: { asks_intersections: true } } as unknown as SceneHeader;
  const collapsed = { ...step, toi_lower: 0, collapsed: "all vertices lie at one point" };
  assert.ok(nothingFound(header, collapsed).startsWith("all vertices lie at one point. No pair of it is listed"));
  assert.ok(shareOf({ ...collapsed, stages: [] }, 5, 0).startsWith("all vertices lie at one point"));
});

// Bug: of an audit's frames one that has collapsed is passed over by the button for bad ones.
void test("a frame in which an object has collapsed is bad", () => {
  const of = { contacts: [0, 0, 0], intersections: [0, 0, 0], fresh: [0, 0, 0], steps: [0, 1, 2] };
  const strip = { ...of, collapsed: [false, true, false] } as unknown as Strip;
  assert.deepEqual(badFrames(strip), [1]);
  assert.equal(firstBadStep({ strip }), 1);
});

// Bug: 100 % of 1e20 pairs are called free, though one of them touches.
void test("a share is all of it only if nothing is left", () => {
  assert.equal(percentWithout(0, 5), "100 %");
  assert.equal(percentWithout(1, 3), "66.6 %");
  assert.equal(percentWithout(1, 1e4), "99.990 %");
  assert.ok(percentWithout(1, 1e20).startsWith("99.99999"));
  assert.ok(percentWithout(494, 1e9).startsWith("99.9999"));
  assert.equal(percentWithout(3, 3), "0.0 %");
});

/** The lines of a source that print a word of proof: strings, without comments. */
function claims(path: string): string[] {
  const lines = readFileSync(path, "utf8").split("\n");
  return lines.filter((line) =>
    /["`][^"`]*\b(proven|certified|exactly|is free|free,)/i.test(line.replace(/\/\/.*|^\s*\/?\*.*/, "")),
  );
}

// Bug: a panel says "free, proven" of a pair that was never asked about.
void test("only the sentences made from verdicts speak of proofs", () => {
  const sources = join(process.cwd(), "src");
  const files = readdirSync(sources, { recursive: true }).map(String);
  const speaking = files.filter((name) => name.endsWith(".ts") && claims(join(sources, name)).length > 0);
  assert.deepEqual(speaking, [join("program", "words.ts"), join("scene", "proofs.ts")]);
});
