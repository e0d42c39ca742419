// A planner's questions: many motions, and edges between configurations of a linkage.
import assert from "node:assert/strict";
import { test } from "node:test";
import { refuses, tamis } from "./scene.mjs";
import { bladeOverPlate } from "./worlds.mjs";

// The blade slides along z by a joint, down through the plate.
const sliding = { joints: [{ kind: "sliding", axis: [0, 0, 1], coordinate: 0 }], bodies: [{ body: 1, joint: 0 }] };

test("the first contact of each of many motions", () => {
  const world = bladeOverPlate();
  const links = [
    [0, 0, 1, 0, 0, 0, 0, 0, -1, 0, 0, 0], [0, 0, 1, 0, 0, 0, 0, 0, 3, 0, 0, 0], [0, 0, 1, 0, 0, 0, 0, 0, 1, 0, Math.PI / 2, 0],
  ].flat();
  const [down, up, turn] = world.earliestMany(1, 3, { links });
  assert(down.contact !== null && down.toiLower <= 0.5 && 0.5 <= down.toiUpper);
  assert.deepEqual(up, { toiLower: 1, toiUpper: 1, contact: null });
  assert.deepEqual([...turn.contact.bodies], [1, 0]);
  const { toiLower } = turn;
  assert.equal(world.earliest().toiLower, toiLower);
  refuses(() => world.earliestMany([1, 0], 3, { links }), /links has 36 numbers/, 1);
  refuses(() => world.earliestMany(5, 3, { links }), /./, 4);
  assert.equal(world.earliestMany(1, 0, {}).length, 0);
  world.free();
});

test("edges between configurations", () => {
  const world = bladeOverPlate();
  const linkage = tamis.linkage(sliding);
  assert.equal(linkage.dimension, 1);
  const [starts, ends] = [[2, 2], [-2, 3]];
  assert.deepEqual([...world.edgesAreFree(linkage, starts, ends)], [0, 1]);
  assert.deepEqual([...world.configurationsAreFree(linkage, starts)], [1, 1]);
  const [met, free] = world.lastValid(linkage, starts, ends, { startsAreFree: true });
  assert(!met.isFree && met.contact !== null && met.fraction > 0 && met.fraction < 1 && met.point.length === 3);
  assert.deepEqual([...met.contact.bodies], [...met.bodies]);
  assert.deepEqual({ ...free, bodies: [...free.bodies] }, {
    isFree: true, fraction: 1, fractionUpper: 1, overlapsAtStart: false, bodies: [-1, -1], point: null, contact: null,
  });
  const bad = world.firstBadEdge(linkage, [4, 3, 2, -2]);
  assert(bad.edge === 2 && bad.contact !== null);
  assert.equal(world.firstBadEdge(linkage, [4, 3, 2]).edge, null);
  const map = world.roadmap(linkage, [4, 3, 2, -2], [0, 1, 2, 3]);
  assert.deepEqual([[...map.configurationsAreFree], [...map.edgesAreFree]], [[1, 1, 1, 1], [1, 0]]);
  refuses(() => world.firstBadEdge(linkage, [4]), /./, 4);
  refuses(() => world.edgesAreFree(linkage, starts, [1]), /starts has 2 numbers, ends 1/, 9);
  refuses(() => world.edgesAreFree(linkage, starts, [1, NaN]), /./, 3);
  refuses(() => world.edgesAreFree(linkage, starts, ends, { atStart: "ignore" }), /at_start/, 4);
  refuses(() => world.roadmap(linkage, [4, 3], [0, 2]), /./, 4);
  linkage.free();
  refuses(() => world.edgesAreFree(linkage, starts, ends), /linkage has been freed/, 1);
  world.free();
});

test("linkages that cannot be", () => {
  const joint = (more) => () => tamis.linkage({ ...sliding, joints: [{ ...sliding.joints[0], ...more }] });
  refuses(joint({ kind: "rolling" }), /joint 0 is 'rolling': use fixed, turning, sliding/, 4);
  refuses(joint({ parent: 0 }), /./, 4);
  refuses(joint({ axis: [0, 0, 0] }), /./, 4);
  refuses(joint({ axis: [1] }), /axis has 1 numbers: give 3/, 9);
  refuses(joint({ parents: 0 }), /no 'parents': use parent/, 4);
  refuses(() => tamis.linkage({ ...sliding, bodies: [{ body: 1, joint: 5 }] }), /./, 4);
});
