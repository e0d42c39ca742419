// The sentences for steps without contacts.
import assert from "node:assert/strict";
import { test } from "node:test";
import { nothingFound, withoutContacts, type SceneHeader } from "../src/scene/header";

const step = { contacts: {}, toi_upper: null, stages: [] };

// Bug: a piece of a path in which no contact begins is called free, though a pair that met before still touches.
void test("only what is proven free is called so", () => {
  assert.equal(withoutContacts({ ...step, toi_lower: null }), "the step is free, proven.");
  assert.ok(withoutContacts({ ...step, toi_lower: 0 }).endsWith("may touch."));
  assert.ok(withoutContacts({ ...step, toi_lower: 0.5 }).endsWith("may touch from 0.5 on."));
});

// Bug: of a frame to which no step leads the page says that nothing was found in the step to it.
void test("a step that was not asked about is not spoken of as if it was", () => {
  const header = { names: ["0", "1"], strip: { names: [], contacts: [], intersections: [], steps: [] } };
  const sentence = (ends: [number, number]): string =>
    nothingFound(header as unknown as SceneHeader, { ...step, toi_lower: null, ends });
  assert.ok(sentence([0, 1]).endsWith("nor in the step to it."));
  assert.ok(sentence([1, 1]).endsWith("no step to it was asked about."));
});
