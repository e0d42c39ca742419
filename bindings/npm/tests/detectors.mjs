// Detectors: every question, every refusal.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { load } from "tamis";
import { end, faces, refuses, start, tamis, two } from "./scene.mjs";

test("the version is the package's", () => {
  const place = createRequire(import.meta.url).resolve("tamis/package.json");
  assert.equal(tamis.version, JSON.parse(readFileSync(place, "utf8")).version);
});

test("what falls touches half way", () => {
  const detector = two();
  const contacts = detector.contacts(start, end);
  assert.equal(contacts.length, 1);
  const { kind, vertices, toiLower, toiUpper, u, v, normal } = contacts.at(0);
  assert.equal(kind, "vertex-face");
  assert.deepEqual([...vertices], [3, 0, 1, 2]);
  assert(toiLower <= 0.5 && 0.5 <= toiUpper && toiUpper - toiLower < 1e-9);
  assert.deepEqual([u, v, ...normal.map(Math.abs)], [0.25, 0.25, 0, 0, 1]);
  assert.throws(() => contacts.at(1), /there is no row 1: the answer has 1/);
  detector.free();
});

test("the first contact, and a step without one", () => {
  const detector = two();
  const found = detector.earliest(start, end);
  assert.deepEqual([...found.contact.vertices], [3, 0, 1, 2]);
  assert(found.toiLower <= 0.5 && found.toiUpper >= 0.5);
  assert.equal(detector.isFree(start, end), false);
  assert.deepEqual(detector.earliest(start, start), { toiLower: 1, toiUpper: 1, contact: null });
  assert.equal(detector.isFree(start, start), true);
  detector.free();
});

test("a safe step keeps a fraction of the distance, and so do truncated positions", () => {
  const detector = two();
  const step = detector.safeStep(0.1, start, end);
  assert(Math.abs(step.toiLower - 0.45) < 1e-6 && step.toiLower <= step.toiUpper);
  assert.equal(step.pair.distance, 1);
  assert.deepEqual([...step.pair.vertices], [3, 0, 1, 2]);
  assert.equal(detector.safeStep(0.1, start, start).pair, null);
  const { positions, fractions, isFree } = detector.truncate(0.1, start, end);
  assert.equal(isFree, true);
  assert(positions[11] > 0 && fractions[3] > 0 && fractions[3] < 0.5 && fractions[0] === 1);
  detector.free();
});

test("near pairs and intersections are about the start", () => {
  const detector = two();
  assert.equal(detector.pairsWithin(0.5, start).length, 0);
  const [pair] = detector.pairsWithin(1, start);
  assert.equal(pair.distance, 1);
  assert.deepEqual(pair.direction.map(Math.abs), Float64Array.of(0, 0, 1));
  assert.equal(detector.hasIntersection(start), false);
  const through = detector.intersections(end).toArray();
  assert.equal(through.length, 2);
  for (const { edge, face, sLower, sUpper } of through) {
    assert.deepEqual([...face], [0, 1, 2]);
    assert.equal(edge[0], 3);
    assert(0 < sLower && sLower <= sUpper && sUpper < 1);
  }
  assert.equal(detector.hasIntersection(end), true);
  detector.free();
});

test("positions may be written into the module's memory", () => {
  const detector = two();
  detector.start.set(start);
  detector.end.set(end);
  assert.equal(detector.start.buffer, tamis.module.HEAPF64.buffer);
  assert.equal(detector.contacts().length, 1);
  detector.end[11] = 0.5;
  assert.equal(detector.contacts().length, 0);
  detector.free();
});

test("memory that grows leaves detectors and their answers", () => {
  const detector = two();
  detector.start.set(start);
  const contacts = detector.contacts(start, end);
  const before = tamis.module.HEAPF64.buffer;
  const large = tamis.detector({ loosePoints: [0], vertexCount: 4e6 });
  assert.notEqual(tamis.module.HEAPF64.buffer, before);
  assert.deepEqual([...contacts.at(0).vertices], [3, 0, 1, 2]);
  assert.equal(detector.start[9], 0.25);
  large.free();
  detector.free();
});

test("answers may be arguments, and views of memory that has grown are refused", () => {
  const detector = two();
  const { positions } = detector.truncate(0.1, start, end);
  assert.equal(detector.isFree(start, positions), true);
  refuses(() => detector.isFree(start, end, { minSeperation: 1 }), /no 'minSeperation': use minSeparation, atStart/, 4);
  // The shape's points are a view, and copying them makes the memory grow.
  const large = tamis.detector({ loosePoints: [0], vertexCount: 2e6 });
  const before = large.start;
  before.set([1, 2, 3]);
  const shapes = [];
  while (before.length > 0) shapes.push(tamis.shape({ loosePoints: [0], vertexCount: 2e6 }, large.start));
  const world = tamis.world();
  for (const shape of shapes) assert.deepEqual([...world.pointsAt(world.add(shape), 0).points.slice(0, 3)], [1, 2, 3]);
  refuses(() => world.move(0, { start: before, end: before }), /a view of memory that has grown/, 1);
  refuses(() => large.isFree(before), /start has 0 numbers: give 6000000/, 1);
  for (const each of [detector, large, world, ...shapes]) each.free();
});

test("options change the answer", () => {
  const count = (options, query) => {
    const detector = two(options);
    const { length } = detector.contacts(start, end, query);
    detector.free();
    return length;
  };
  refuses(() => count({ groups: [0, 0, 0, -1, -1, -1] }), /vertex 3 is in group -1/, 4);
  assert.equal(count({ groups: [0, 0, 0, 1, 1, 1], mayTouch: [1, 0, 0, 1] }), 0);
  assert.equal(count({ groups: [0, 0, 0, 1, 1, 1], radii: [0.1, 0.1] }) > 0, true);
  assert.equal(count({ rings: 2 }), 1);
  assert(count({ minSeparation: 0.25 }) >= 1);
  assert(count({}, { minSeparation: 2 }) > 1);
  assert.equal(count({ accepts: (kind, vertices) => kind !== "vertex-face" || vertices[0] !== 3 }), 0);
});

test("what the start's pairs count as is chosen", () => {
  const detector = tamis.detector({ faces: [0, 1, 2], loosePoints: [3] });
  const on = start.slice(0, 12).fill(0, 11);
  assert.equal(detector.contacts(on, on).length, 1);
  assert.equal(detector.contacts(on, on, { atStart: "ignore" }).length, 0);
  refuses(() => detector.contacts(on, on, { atStart: "fail" }), /3/, 3);
  detector.free();
});

test("what a function throws comes back, and a question can be ended", () => {
  const throws = two({ accepts: () => { throw new Error("no such pair"); } });
  assert.throws(() => throws.contacts(start, end), /no such pair/);
  throws.free();
  const cancelled = two({ isCancelled: () => true });
  refuses(() => cancelled.contacts(start, end), /./, 5);
  cancelled.free();
});

test("what is wrong is refused with a sentence", () => {
  refuses(() => tamis.detector({ faces: [0, 1, 7], vertexCount: 3 }), /7/, 2);
  refuses(() => tamis.detector({ faces: [0, 1] }), /faces has 2 numbers: give 3 for each triangle/, 1);
  refuses(() => tamis.detector({}), /./, 2);
  refuses(() => two({ groups: [0] }), /groups has 1 numbers: give 6/, 1);
  refuses(() => two({ groups: [0, 0, 0, 1, 1, 1], mayTouch: [1] }), /mayTouch has 1 numbers: give 2 x 2/, 1);
  refuses(() => two({ minSeparation: -1 }), /-1/, 4);
  const detector = two();
  refuses(() => detector.contacts(start.slice(3), end), /start has 15 numbers: give 18/, 1);
  refuses(() => detector.contacts(start, end.map(() => NaN)), /./, 3);
  refuses(() => detector.contacts(start, end, { atStart: "never" }), /atStart is 'never': use report/, 1);
  refuses(() => detector.safeStep(2, start, end), /2/, 4);
  detector.free();
  detector.free();
  for (const f of [() => detector.contacts(start, end), () => detector.start, () => detector.statistics()]) refuses(f, /has been freed/, 1);
});

test("statistics count what was decided", () => {
  const detector = two();
  detector.contacts(start, end);
  const { seconds, decidedByLanes, decidedByScalar, decidedByExact, memoryBytes } = detector.statistics();
  assert(seconds > 0 && memoryBytes > 0 && decidedByLanes + decidedByScalar + decidedByExact > 0);
  detector.free();
});

test("a detector is disposed of, and its memory is free again", () => {
  if (typeof Symbol.dispose !== "symbol") return;
  const before = tamis.module.HEAPU8.length;
  for (let i = 0; i < 2000; ++i) {
    const detector = tamis.detector({ loosePoints: [0], vertexCount: 10000 });
    detector[Symbol.dispose]();
  }
  assert.equal(tamis.module.HEAPU8.length, before);
});

test("two loads have two memories", async () => {
  const other = await load();
  assert.notEqual(other.module.HEAPU8.buffer, tamis.module.HEAPU8.buffer);
  const detector = other.detector({ faces });
  assert.equal(detector.contacts(start, end).length, 1);
  detector.free();
});
