// Curved motion: each kind of path, the questions about it, poses and chains, and refusals.
import assert from "node:assert/strict";
import { test } from "node:test";
import { brackets, end, near, refuses, start, tamis, two } from "./scene.mjs";

const HALF_TURN = [0, 0, Math.PI];
const STILL = [0, 0, 0, 0, 0, 0];
// A wall at x = 0; a blade that turns about z from one side to the other, free at the start and at the end.
const rest = [0, 1, -1, 0, 3, -1, 0, 2, 2, 1.9, -0.1, -2, 2.1, 0.1, -2, 2, 0, 0.5];
const bodyOfVertex = [0, 0, 0, 1, 1, 1];
const turning = () => tamis.rigidPath({ rest, bodyOfVertex, chains: [[], tamis.turnedChain(STILL, HALF_TURN, [0, 0, 0])] });

test("a blade that turns meets the wall", () => {
  const detector = two();
  const path = turning();
  const contacts = detector.contacts(path).toArray();
  assert(contacts.length > 0);
  for (const contact of contacts) assert(contact.certified && contact.toiUpper - contact.toiLower <= 1e-9);
  const first = Math.min(...contacts.map(({ toiLower }) => toiLower));
  const found = detector.earliest(path);
  assert(found.toiLower === first && 0.4 < first && found.toiUpper < 0.5 && found.contact !== null);
  assert.equal(detector.isFree(path), false);
  assert(detector.earliest(path, { minSeparation: 0.25, tolerance: 1e-3 }).toiLower < first);
  const all = detector.contacts(path, { minSeparation: 3 }).length;
  assert(detector.contacts(path, { minSeparation: 3, atStart: "ignore" }).length < all);
  refuses(() => detector.contacts(path, { minSeparation: 3, atStart: "fail" }), /./, 3);
  const last = path.pointsAt(1);
  near(last[9], -1.9), near(last[10], 0.1), near(last[3], 0);
  assert.equal(detector.isFree(rest, last), true);
  path.free();
  refuses(() => detector.contacts(path), /path has been freed/, 1);
  detector.free();
});

test("pairs on a path are decided one by one", () => {
  const path = turning();
  const [slow, fast] = path.edgeEdge([0, 1, 3, 5, 0, 1, 4, 5]);
  assert(slow.touches && fast.touches && fast.toiLower < slow.toiLower);
  const [face] = path.vertexFace([5, 0, 1, 2]);
  assert(face.touches && face.certified);
  brackets(face, 0.5);
  assert.equal(path.vertexEdge([4, 0, 1], { minSeparation: 0.5 }).at(0).touches, false);
  assert.equal(path.vertexVertex([0, 5], { minSeparation: 0.5 }).at(0).touches, false);
  assert.equal(path.vertexVertex([]).length, 0);
  refuses(() => path.edgeEdge([0, 1, 3, 6]), /6/, 9);
  refuses(() => path.edgeEdge([0, 1, 3]), /vertices has 3 numbers: give 4 for each pair/, 1);
  refuses(() => path.edgeEdge([0, 1, 3, 4], { atStart: "ignore" }), /leave it 0/, 4);
  refuses(() => path.edgeEdge([0, 1, 3, 4], { tolerance: 2 }), /./, 4);
  refuses(() => path.edgeEdge([0, 1, 3, 4], { tolerance: 0 }), /tolerance is 0/, 4);
  refuses(() => path.edgeEdge([0, 1, 3, 4], { isCancelled: () => true }), /./, 5);
  path.free();
});

test("splines go through their points", () => {
  const detector = two();
  const straight = tamis.bezierPath([...start, ...end], 6);
  brackets(detector.earliest(straight), 0.5);
  const there = tamis.catmullRomPath([...start, ...end, ...start], 6);
  assert.deepEqual(there.pointsAt(0.5), end);
  assert(detector.earliest(there).toiUpper < 0.5);
  refuses(() => there.pointsAt(1.5), /./, 1);
  refuses(() => tamis.catmullRomPath(start, 6), /at least 2/, 9);
  refuses(() => tamis.bezierPath([...start, 1], 6), /frames has 19 numbers: give 18 for each frame/, 1);
  const short = tamis.bezierPath(start.slice(3), 5);
  refuses(() => detector.contacts(short), /./, 9);
  for (const each of [straight, there, short, detector]) each.free();
});

test("a body may deform while it moves", () => {
  const detector = two();
  const path = tamis.rigidPath({ rest: start, restEnd: end, bodyOfVertex, chains: [[], []] });
  brackets(detector.earliest(path), 0.5);
  path.free();
  detector.free();
});

/** The turning blade, as functions. */
function turned(error, broken = () => {}) {
  return tamis.functionPath({
    vertexCount: 6,
    pointsAt(time, vertices, points, errors) {
      broken(time);
      const [c, s] = [Math.cos(time * Math.PI), Math.sin(time * Math.PI)];
      vertices.forEach((vertex, i) => {
        const [x, y, z] = rest.slice(3 * vertex);
        points.set(bodyOfVertex[vertex] ? [c * x - s * y, s * x + c * y, z] : [x, y, z], 3 * i);
      });
      errors.fill(error);
    },
    deviations(from, to, vertices, deviations) {
      deviations.set(Array.from(vertices, (vertex) => (bodyOfVertex[vertex] * 2.2 * (Math.PI * (to - from)) ** 2) / 8));
    },
  });
}

test("functions tell where everything is", () => {
  const detector = two();
  const [path, rigid] = [turned(1e-14), turning()];
  near(detector.earliest(path).toiLower, detector.earliest(rigid).toiLower, 1e-8);
  near(path.pointsAt(1)[9], -1.9);
  const bad = [turned(-1), turned(NaN)];
  for (const each of bad) refuses(() => detector.isFree(each), /give a bound >= 0/, 9);
  const throwing = turned(1e-14, (time) => { if (time > 0) throw new Error("no such time"); });
  assert.throws(() => detector.isFree(throwing), /no such time/);
  assert.throws(() => throwing.pointsAt(1), /no such time/);
  assert.equal(detector.isFree(path), false);
  const leaving = turned(1e-14, () => leaving.free());
  refuses(() => detector.isFree(leaving), /path is still answering/, 6);
  assert.equal(leaving.vertexCount, 6);
  leaving.free();
  const silent = tamis.functionPath({ vertexCount: 6, pointsAt() {}, deviations() {} });
  refuses(() => detector.isFree(silent), /./, 9);
  refuses(() => tamis.functionPath({ vertexCount: -1, pointsAt() {}, deviations() {} }), /./, 9);
  for (const each of [path, rigid, ...bad, throwing, silent, detector]) each.free();
});

test("poses and chains are those of engines", () => {
  const quarter = Math.PI / 2;
  const half = Math.SQRT1_2;
  const pose = tamis.poseOf([half, 0, 0, Math.fround(half)], [1, 2, 3]);
  assert.deepEqual([...pose.slice(0, 3)], [1, 2, 3]);
  near(pose[5], quarter, 1e-7);
  const end = tamis.poseOf([0, -1, 0, 1, 0, 0, 0, 0, 1], [0, 0, 0]);
  near(end[5], quarter);
  assert.deepEqual([...tamis.poseOf([0, 0, 1], [1, 2, 3])], [1, 2, 3, 0, 0, 1]);
  const chain = tamis.chainBetween(STILL, end, [1, 0, 0]);
  near(chain[0], 1), near(chain[7], 1), near(chain[12], -1);
  near(tamis.poseAt(chain, 1)[5], quarter);
  assert.deepEqual([...tamis.poseAt([], 0)], STILL);
  assert.deepEqual([...tamis.interpolatedChain(STILL, end)], [...STILL, ...end]);
  near(tamis.nlerpDeviation(STILL, STILL), 0);
  assert(0.03 < tamis.nlerpDeviation(STILL, end) && tamis.nlerpDeviation(STILL, end) < 0.04);
  refuses(() => tamis.poseOf([2, 0, 0, 0], [0, 0, 0]), /off by more than rounding/, 9);
  refuses(() => tamis.poseOf([1, 0], [0, 0, 0]), /rotation has 2 numbers/, 9);
  refuses(() => tamis.poseAt(chain, 2), /time is 2/, 9);
  refuses(() => tamis.chainBetween(STILL, [0]), /end has 1 numbers: give 6/, 9);
  refuses(() => tamis.turnedChain(STILL, [0, 0, NaN], [0, 0, 0]), /not finite/, 9);
});

test("paths of wrong sizes are refused", () => {
  const chains = [[], []];
  refuses(() => tamis.rigidPath({ rest, bodyOfVertex, chains: [[]] }), /body 1/, 9);
  refuses(() => tamis.rigidPath({ rest, bodyOfVertex: [0], chains }), /bodyOfVertex has 1 numbers, rest 6 vertices/, 9);
  refuses(() => tamis.rigidPath({ rest, bodyOfVertex, chains: [[], [1]] }), /chain 1 has 1 numbers: give 12/, 1);
  refuses(() => tamis.rigidPath({ rest, bodyOfVertex, chains, ends: rest }), /a rigid path have no 'ends'/, 4);
});
