// Pairs of features, alone and in lists; meshes; weights.
import assert from "node:assert/strict";
import { test } from "node:test";
import { brackets, near, refuses, start as corners, tamis } from "./scene.mjs";

const before = [0.2, 0.2, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 9, 9, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0];
const after = before.map((x, i) => (i === 2 || i === 14 ? -3 : x));

test("pairs of each kind", () => {
  const pairs = tamis.pairs();
  const [first, second] = pairs.vertexFace(before, after);
  assert(first.touches && first.certified && !second.touches && !second.certified);
  brackets(first, 0.25);
  near(first.u, 0.2, 1e-9);
  const [crossed] = pairs.edgeEdge([-1, 0, 1, 1, 0, 1, 0, -1, 0, 0, 1, 0], [-1, 0, -1, 1, 0, -1, 0, -1, 0, 0, 1, 0]);
  brackets(crossed, 0.5);
  near(crossed.v, 0.5, 1e-9);
  const [met] = pairs.vertexEdge([0, 0, 1, -1, 0, 0, 1, 0, 0], [0, 0, -1, -1, 0, 0, 1, 0, 0]);
  brackets(met, 0.5);
  const [points] = pairs.vertexVertex([0, 0, 1, 0, 0, 0], [0, 0, -3, 0, 0, 0]);
  brackets(points, 0.25);
  assert.equal(pairs.edgeEdge([], []).length, 0);
  refuses(() => pairs.vertexFace(before.map((x, i) => (i === 15 ? Infinity : x)), after), /pair 1/, 3);
  refuses(() => pairs.vertexFace(before, after.slice(12)), /start has 24 numbers, end 12/, 3);
  refuses(() => pairs.vertexFace([1], [1]), /start has 1 numbers: give 12 for each pair/, 1);
  pairs.free();
  refuses(() => tamis.pairs({ minSeparation: -1 }), /separation/, 4);
  refuses(() => tamis.pairs({ latest: 1.5 }), /./, 4);
  refuses(() => tamis.pairs({ last: 1 }), /no 'last'/, 4);
});

const start = [0.2, 0.2, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 9, 9, 1];
const end = start.map((x, i) => (i % 12 === 2 ? -3 : x));
const kinds = ["vertex-face", "vertex-face", "vertex-vertex"];
const vertices = [0, 1, 2, 3, 4, 1, 2, 3, 0, 4, -1, -1];

test("a list of pairs is decided, until the latest time", () => {
  const pairs = tamis.pairs();
  const touches = (...rest) => pairs.narrowPhase(kinds, vertices, start, end, ...rest).toArray().map((each) => each.touches);
  assert.deepEqual(touches(), [true, false, false]);
  assert.deepEqual(touches({ minSeparation: 100 }), [true, true, true]);
  assert.equal(pairs.narrowPhase([], [], start, end).length, 0);
  refuses(() => pairs.narrowPhase("vertex-face", [0, 1, 2, 5], start, end), /pair 0: vertex 5 is not a row of the step's 5 positions/, 3);
  refuses(() => pairs.narrowPhase("face-face", [0, 1, 2, 3], start, end), /pair 0 is 'face-face'/, 3);
  refuses(() => pairs.narrowPhase(kinds, [0, 1, 2, 3], start, end), /3 kinds and 1 pairs/, 3);
  refuses(() => pairs.narrowPhase("vertex-face", [0, 1, 2, 3], start, []), /start has 15 numbers, end 0/, 3);
  pairs.free();
  for (const [latest, expected] of [[0, false], [0.2, false], [0.3, true], [1, true]]) {
    const until = tamis.pairs({ latest });
    assert.equal(until.narrowPhase("vertex-face", [0, 1, 2, 3], start, end).at(0).touches, expected);
    until.free();
  }
  const cancelled = tamis.pairs({ isCancelled: () => true });
  refuses(() => cancelled.narrowPhase(kinds, vertices, start, end), /./, 5);
  cancelled.free();
});

test("distances of pairs, and how far one may go", () => {
  const pairs = tamis.pairs();
  const at = [...start.slice(0, 12), 0.2, 0.2, 4];
  const [face, points] = pairs.distancesOf(["vertex-face", "vertex-vertex"], [0, 1, 2, 3, 0, 4, 7, 7], at);
  assert.deepEqual([face.kind, face.distance, face.direction[2]], ["vertex-face", 1, 1]);
  assert.deepEqual([points.kind, points.distance, [...points.vertices]], ["vertex-vertex", 3, [0, 4]]);
  const safe = pairs.safeStep("vertex-face", [0, 1, 2, 3], start, end, 0.2);
  assert(safe.toiLower <= 0.2 && safe.toiLower > 0.19 && safe.pair.distance === 1);
  assert(pairs.safeStep("vertex-face", [0, 1, 2, 3], start, end, 0, { minSeparation: 0.5 }).toiLower <= 0.125);
  refuses(() => pairs.safeStep("vertex-face", [0, 1, 2, 3], start, end, 1), /./, 4);
  refuses(() => pairs.safeStep("vertex-face", vertices.slice(0, 8), start, end), /there are 2 pairs: give one/, 1);
  pairs.free();
});

test("a mesh serves detectors and shapes, and finds features", () => {
  const mesh = tamis.mesh({ faces: [0, 1, 2, 3, 4, 5], loosePoints: [6] });
  assert.equal(mesh.vertexCount, 7);
  assert.deepEqual([...mesh.edges], [0, 1, 0, 2, 1, 2, 3, 4, 3, 5, 4, 5]);
  assert.deepEqual([...mesh.points], [0, 1, 2, 3, 4, 5, 6]);
  assert.deepEqual(mesh.featuresOf("vertex-face", [3, 0, 1, 2]), [3, 0]);
  assert.deepEqual(mesh.featuresOf("edge-edge", [0, 2, 4, 5]), [1, 5]);
  assert.deepEqual([...mesh.findEdges([2, 0, 0, 5])], [1, -1]);
  assert.deepEqual([...mesh.findFaces([3, 4, 5, 0, 2, 1])], [1, -1]);
  refuses(() => mesh.featuresOf("edge-edge", [0, 5, 1, 2]), /./, 2);
  refuses(() => mesh.featuresOf("edge", [0, 5]), /'edge' with 2 vertices/, 1);
  refuses(() => mesh.findEdges([1]), /edges has 1 numbers: give 2/, 1);
  refuses(() => tamis.mesh({ faces: [0, 1, 2.5], vertexCount: 4 }), /number 2 of 3 is 2.5: give a whole number/, 1);
  const points = [...corners, 0, 0, 9];
  const [detector, shape] = [tamis.detector(mesh), tamis.shape(mesh, points)];
  mesh.free();
  assert.equal(detector.isFree(points, points), true);
  refuses(() => tamis.detector(mesh), /mesh has been freed/, 1);
  detector.free();
  shape.free();
});

test("weights of both points", () => {
  assert.deepEqual([...tamis.weightsOf({ kind: "vertex-face", u: 0.25, v: 0.25 })], [1, -0.5, -0.25, -0.25]);
  refuses(() => tamis.weightsOf({ kind: "face", u: 0, v: 0 }), /no kind 'face'/, 1);
});
