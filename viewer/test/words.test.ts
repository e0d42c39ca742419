// The sentences for steps without contacts.
import assert from "node:assert/strict";
import { test } from "node:test";
import { withoutContacts } from "../src/scene/header";

const step = { contacts: {}, toi_upper: null, stages: [] };

// Bug: a piece of a path in which no contact begins is called free, though a pair that met before still touches.
void test("only what is proven free is called so", () => {
  assert.equal(withoutContacts({ ...step, toi_lower: null }), "the step is free, proven.");
  assert.ok(withoutContacts({ ...step, toi_lower: 0 }).endsWith("may touch."));
  assert.ok(withoutContacts({ ...step, toi_lower: 0.5 }).endsWith("may touch from 0.5 on."));
});
