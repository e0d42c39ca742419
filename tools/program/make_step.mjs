// node make_step.mjs NAME START.ply END.ply: writes dist/step-NAME.js, a step of the first page, from two frames that `tamis scene`
// has written. Coordinates become floats on a grid of 2^-14 metres, which compress well. The frames of the page:
//   tamis scene cloth-ball --triangles 12000 --out cloth     (40 and 41)
//   tamis scene funnel --out funnel                          (60 and 61)
// Of the funnel's scene the page shows the cloth, the first object, without what would hide it.
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { deflateSync } from "node:zlib";

const kGrid = 2 ** -14;

const kFaceBytes = 13; // a count, and three integers

/** How many vertices the first object has: objects follow each other, and no face joins two. */
function firstObject(faces) {
  let size = 0;
  for (let known = 1; known > size; ) {
    size = known;
    for (let at = 0; at < faces.length; at += kFaceBytes) {
      const corners = [1, 5, 9].map((byte) => faces.readInt32LE(at + byte));
      if (Math.min(...corners) < size) known = Math.max(known, ...corners.map((corner) => corner + 1));
    }
  }
  return size;
}

/** A frame with floats in place of doubles; of one object, if `alone`. */
function withFloats(path, alone) {
  const file = readFileSync(path);
  const mark = "end_header\n";
  const headerEnd = file.indexOf(mark) + mark.length;
  const header = file.subarray(0, headerEnd).toString();
  const all = Number(/element vertex (\d+)/.exec(header)[1]);
  const allFaces = file.subarray(headerEnd + 24 * all);
  const vertices = alone ? firstObject(allFaces) : all;
  const faces = [];
  for (let at = 0; at < allFaces.length; at += kFaceBytes)
    if (allFaces.readInt32LE(at + 1) < vertices) faces.push(allFaces.subarray(at, at + kFaceBytes));
  const floats = Buffer.alloc(12 * vertices);
  for (let i = 0; i < 3 * vertices; ++i)
    floats.writeFloatLE(kGrid * Math.round(file.readDoubleLE(headerEnd + 8 * i) / kGrid), 4 * i);
  const newHeader = header
    .replace(/property double/g, "property float")
    .replace(/element vertex \d+/, `element vertex ${vertices}`)
    .replace(/element face \d+/, `element face ${faces.length}`);
  return Buffer.concat([Buffer.from(newHeader), floats, ...faces]);
}

const [name, ...paths] = process.argv.slice(2);
const out = join(dirname(fileURLToPath(import.meta.url)), "dist", `step-${name}.js`);
const texts = paths.map((path) => deflateSync(withFloats(path, name === "funnel"), { level: 9 }).toString("base64"));
writeFileSync(out, `(self.tamisSteps ??= {})[${JSON.stringify(name)}] = ${JSON.stringify(texts)};\n`);
