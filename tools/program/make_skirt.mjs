// node make_skirt.mjs FOLDER: writes start.ply and end.ply, a step of the first page: a pleated skirt, and a leg that kicks. Then
//   node make_step.mjs skirt FOLDER/start.ply FOLDER/end.ply
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const kTurn = 2 * Math.PI;

/** A grid of `rows` by `around` points that closes around, its faces numbered from `first`. */
function tube(rows, around, first, place) {
  const points = [],
    faces = [];
  for (let i = 0; i < rows; ++i)
    for (let j = 0; j < around; ++j) {
      points.push(place(i / (rows - 1), (kTurn * j) / around));
      if (i === rows - 1) continue;
      const [a, b] = [first + i * around + j, first + i * around + ((j + 1) % around)];
      faces.push([a, b, b + around], [a, b + around, a + around]);
    }
  return { points, faces };
}

/** A thigh and a calf below a hip at `side`, turned forwards by `angle`. */
const leg = (side, angle) => (down, turn) => {
  const radius = (0.095 - 0.045 * down) * Math.sqrt(Math.max(0.02, 1 - (2 * Math.abs(down - 0.5)) ** 12));
  const [x, y, z] = [side + radius * Math.cos(turn), -0.8 * down, radius * Math.sin(turn)];
  return [x, y * Math.cos(angle) + z * Math.sin(angle), z * Math.cos(angle) - y * Math.sin(angle)];
};

/** Pleats that overhang as a meander does. They turn with the hips, the hem last; `kick` lifts the front. */
const skirt = (spin, kick) => (down, turn) => {
  const pleats = 18 * turn + 0.9 * Math.sin(3 * turn) + 2 * down;
  const fold = Math.min(1, 2 * down);
  const angle = turn + fold * (0.032 + 0.016 * kick) * Math.sin(2 * pleats) + spin * (1 - 0.6 * down);
  const front = Math.exp(-2.5 * (1 - Math.sin(angle)));
  const lift = kick * front * down ** 1.5;
  const radius = 0.2 + 0.2 * down ** 1.2 + fold * (0.02 + 0.02 * down) * Math.cos(pleats) + 0.35 * lift;
  return [radius * Math.cos(angle), 0.12 - 0.62 * down + 0.45 * lift, radius * Math.sin(angle) + 0.2 * lift];
};

function frame(spin, kick) {
  const parts = [];
  let first = 0;
  for (const [rows, around, place] of [
    [30, 324, skirt(spin, kick)],
    [20, 24, leg(0.1, 0)],
    [20, 24, leg(-0.1, 1.8 * kick)],
  ]) {
    parts.push(tube(rows, around, first, place));
    first += rows * around;
  }
  const [points, faces] = [parts.flatMap((p) => p.points), parts.flatMap((p) => p.faces)];
  const header = `ply\nformat binary_little_endian 1.0\nelement vertex ${points.length}
property double x\nproperty double y\nproperty double z\nelement face ${faces.length}
property list uchar int vertex_indices\nend_header\n`;
  const body = Buffer.alloc(24 * points.length + 13 * faces.length);
  let at = 0;
  for (const x of points.flat()) at = body.writeDoubleLE(x, at);
  for (const face of faces) {
    at = body.writeUInt8(3, at);
    for (const corner of face) at = body.writeInt32LE(corner, at);
  }
  return Buffer.concat([Buffer.from(header), body]);
}

const folder = process.argv[2];
mkdirSync(folder, { recursive: true });
writeFileSync(join(folder, "start.ply"), frame(0, 0.2));
writeFileSync(join(folder, "end.ply"), frame(0.1, 0.4));
