// Worlds of bodies: answers, and refusals, which change nothing.
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "tamis";
import { brackets, near, refuses, tamis } from "./scene.mjs";

const QUARTER = Math.PI / 2;
const platePoints = [-5, -5, 0, 5, -5, 0, 0, 5, 0];
export const bladePoints = [0, 0, 0, 2, 0, 0, 1, 0.5, 0];
const shapeOf = (points) => tamis.shape({ faces: [0, 1, 2] }, points);
const turning = (x, height, angle) => [x, 0, height, 0, 0, 0, x, 0, height, 0, angle, 0];

/** The plate is body 0, the blade body 1: it turns a quarter about y, and its tip goes down to the plate. */
export function bladeOverPlate(options) {
  const [plate, blade] = [shapeOf(platePoints), shapeOf(bladePoints)];
  const world = tamis.world(options);
  assert.equal(world.add(plate), 0);
  assert.equal(world.add(blade, { links: turning(0, 1, QUARTER) }), 1);
  plate.free();
  blade.free();
  return world;
}

test("a blade turns into a plate", () => {
  const world = bladeOverPlate();
  const contacts = world.contacts().toArray();
  assert(contacts.length > 0);
  for (const { bodies, toiLower, toiUpper } of contacts) assert(bodies[0] !== bodies[1] && toiUpper - toiLower <= 1e-9);
  const first = Math.min(...contacts.map(({ toiLower }) => toiLower));
  assert.equal(world.firstContacts().length, 1);
  const [one] = world.firstContacts();
  assert.equal(one.toiLower, first);
  assert.deepEqual([...one.bodies], [1, 0]);
  const { toiLower, contact } = world.earliest();
  near(toiLower, 1 / 3, 1e-6);
  assert.equal(contact.kind, "vertex-face");
  assert.deepEqual([...contact.vertices.slice(0, 2), ...contact.bodies], [1, 0, 1, 0]);
  assert.equal(world.isFree(), false);
  assert(world.earliest({ minSeparation: 0.5, tolerance: 1e-3 }).toiLower < first - 0.1);
  assert(world.statistics().memoryBytes > 0);
  const safe = world.safeStep(0.5);
  assert(0 < safe.toiLower && safe.toiLower < first && safe.pair.bodies[0] === 1);
  refuses(() => world.setRadius(1, -1), /./, 4);
  world.setRadius(1, 0.5);
  assert(world.earliest().toiLower < first - 0.1);
  world.free();
  refuses(() => world.contacts(), /world has been freed/, 1);
});

test("what is near at t=0, and what passes through", () => {
  const world = bladeOverPlate();
  const pairs = world.pairsWithin(1.05).toArray();
  assert.equal(pairs.length, 3);
  for (const { distance, bodies } of pairs) assert.deepEqual([distance, ...bodies], [1, 1, 0]);
  assert.equal(world.intersections().length, 0);
  world.move(1, { poses: [0, 0, 1, 0, QUARTER, 0] });  // two that stay
  assert.equal(world.hasIntersection(), false);
  assert.equal(world.hasOverlap(), false);
  assert.equal(world.hasIntersection({ includeStatic: true }), true);
  assert.equal(world.hasOverlap({ includeStatic: true }), true);
  assert.equal(world.isClosed(1), false);
  world.move([1], { links: [0, 0, 1, 0, QUARTER, 0, 0, 0, 2.5, 0, QUARTER, 0] });
  const [crossing] = world.intersections();
  assert.deepEqual([...crossing.bodies], [1, 0]);
  assert.equal(world.hasIntersection(), true);
  refuses(() => world.pairsWithin(NaN), /./, 4);
  refuses(() => world.pairsWithin(1, { withStatic: true }), /no 'withStatic': use includeStatic/, 4);
  refuses(() => world.isClosed(99), /no body 99/, 4);
  refuses(() => world.isClosed(0.5), /body is 0.5: give a whole number/, 1);
  world.free();
});

test("where vertices are, also while contacts are read", () => {
  const world = bladeOverPlate();
  const { points, error } = world.pointsAt(1, 1);
  assert(0 < error && error < 1e-14);
  near(points[3], 0, 1e-14), near(points[4], 0, 0), near(points[5], -1, 1e-14);
  assert.deepEqual(world.pointsAt(0, 0.5), { points: Float64Array.from(platePoints), error: 0 });
  for (const { bodies, vertices, toiLower } of world.contacts()) {
    if (vertices.length !== 4 || bodies[0] !== 1 || vertices[0] !== 1) continue;
    near(world.pointsAt(bodies[0], toiLower).points[3 * vertices[0] + 2], 0, 1e-6);
  }
  refuses(() => world.pointsAt(1, 1.5), /./, 4);
  refuses(() => world.pointsAt(2, 1), /no body 2/, 4);
  world.free();
});

test("a body deforms, and another is removed", () => {
  const world = bladeOverPlate();
  const blade = shapeOf(bladePoints);
  world.remove(1);
  const motion = { start: [0, 0, 3, 2, 0, 3, 1, 0.5, 3], end: [0, 0, -1, 2, 0, 3, 1, 0.5, 3] };
  const soft = world.add(blade, motion);
  assert.equal(soft, 2);
  const found = world.earliest();
  brackets(found, 0.75);
  assert.equal(found.contact.bodies[0], soft);
  const { toiLower, pair } = world.safeStep(0.5);
  near(toiLower, 0.375, 1e-6);
  assert.deepEqual([...pair.bodies, pair.distance], [soft, 0, 3]);
  refuses(() => world.move(soft, { start: [0, 0, 0], end: [0, 0, 0] }), /give one point a vertex/, 3);
  refuses(() => world.move(soft, { start: motion.start }), /end/, 1);
  refuses(() => world.pointsAt(1, 0), /body 1 has been removed/, 4);
  blade.free();
  refuses(() => world.add(blade), /shape has been freed/, 1);
  world.free();
});

test("many bodies in one call; each third meets the ground", () => {
  const count = 300;
  const world = tamis.world();
  const [ground, blade] = [shapeOf([-1e4, -1e4, 0, 1e5, -1e4, 0, 0, 1e5, 0]), shapeOf(bladePoints)];
  world.add(ground);
  const bodies = world.addMany(blade, count);
  assert.deepEqual([bodies[0], bodies[count - 1]], [1, count]);
  world.move(bodies, { links: Array.from(bodies, (_, i) => turning(3 * i, 1, i % 3 === 0 ? 0.55 : 0.5)).flat() });
  const contacts = world.contacts().toArray();
  assert.equal(contacts.length, count / 3);
  for (const { bodies: [first, second] } of contacts) assert.deepEqual([(first - 1) % 3, second], [0, 0]);
  world.setEnabled(bodies, false);
  assert.equal(world.isFree(), true);
  world.setEnabled(bodies[3], true);
  assert.equal(world.contacts().length, 1);
  world.remove(bodies);
  assert.equal(world.isFree(), true);
  for (const each of [world, ground, blade]) each.free();
});

test("what is refused changes nothing", () => {
  const world = bladeOverPlate();
  const blade = shapeOf(bladePoints);
  const all = world.contacts().length;
  assert(all > 0);
  const poses = [0, 0, 50, 0, 0, 0, 0, 0, NaN, 0, 0, 0];
  refuses(() => world.move([1, 0], { poses }), /body 0 is not finite/, 3);
  refuses(() => world.addMany(blade, 2, { poses }), /./, 3);
  refuses(() => world.move([1, 7], { poses: [...poses.slice(0, 6), ...poses.slice(0, 6)] }), /./, 4);
  refuses(() => world.move([1, 1], {}), /body 1 is named twice/, 4);
  refuses(() => world.move(1, { links: turning(0, 1, 5000) }), /turns by 5000 radians/, 3);
  refuses(() => world.move(1, { poses: poses.slice(0, 6), links: turning(0, 1, 0) }), /more than one of/, 1);
  refuses(() => world.move(1, { poses }), /poses has 12 numbers: give 6 for each of 1 bodies/, 9);
  refuses(() => world.move(1, { links: [1] }), /links has 1 numbers: give 12/, 1);
  refuses(() => world.move(1, { pose: [] }), /motions have no 'pose': use poses/, 4);
  refuses(() => world.move(1.5, {}), /give a whole number/, 1);
  refuses(() => world.remove([1, 7]), /./, 4);
  refuses(() => world.setEnabled([1, 7], false), /no body 7/, 4);
  refuses(() => world.setMayTouch([1, 1], true), /./, 4);
  refuses(() => world.setMayTouch([1], true), /bodies has 1 numbers: give 2 for each pair/, 1);
  assert.equal(world.contacts().length, all);
  world.setMayTouch([1, 0], false);
  assert.equal(world.contacts().length, 0);
  world.setMayTouch([1, 0], true);
  assert.equal(world.contacts().length, all);
  blade.free();
  world.free();
});

test("what cannot be made", async () => {
  refuses(() => shapeOf([0, 0, 0, 1, 0, 0, 0, NaN, 0]), /vertex 2/, 2);
  refuses(() => shapeOf([0]), /points has 1 numbers: give 9/, 2);
  refuses(() => tamis.world({ minSeparation: -1 }), /min_separation/, 4);
  refuses(() => tamis.world({ separation: 1 }), /no 'separation': use minSeparation/, 4);
  const other = (await load()).shape({ faces: [0, 1, 2] }, bladePoints);
  const world = tamis.world();
  refuses(() => world.add(other), /shape is of another load\(\)/, 1);
  other.free();
  world.free();
});

test("an answer ends with the next question, and says so", () => {
  const world = bladeOverPlate();
  const contacts = world.contacts();
  world.isFree();
  refuses(() => contacts.at(0), /a later question has ended this answer/, 1);
  world.free();
});

test("a question can be ended, and asks nobody meanwhile", () => {
  let asked = 0;
  const world = bladeOverPlate({ isCancelled: () => ++asked > 0 });
  refuses(() => world.contacts(), /./, 5);
  world.free();
  const busy = bladeOverPlate({ isCancelled: () => busy.isFree() });
  refuses(() => busy.contacts(), /still answering/, 6);
  busy.free();
});
