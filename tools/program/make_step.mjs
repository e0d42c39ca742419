// node make_step.mjs NAME START.ply END.ply: writes dist/step-NAME.js, a step of the first page, from two frames in
// binary PLY and doubles. Coordinates become floats on a grid of 2^-14 metres, which compress well. The frames of the page:
//   tamis scene cloth-ball --triangles 12000 --out cloth     (40 and 41)
//   node make_skirt.mjs skirt
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { deflateSync } from "node:zlib";

const kGrid = 2 ** -14;

/** A frame with floats in place of doubles. */
function withFloats(path) {
  const file = readFileSync(path);
  const mark = "end_header\n";
  const headerEnd = file.indexOf(mark) + mark.length;
  const header = file.subarray(0, headerEnd).toString();
  const vertices = Number(/element vertex (\d+)/.exec(header)[1]);
  const floats = Buffer.alloc(12 * vertices);
  for (let i = 0; i < 3 * vertices; ++i)
    floats.writeFloatLE(kGrid * Math.round(file.readDoubleLE(headerEnd + 8 * i) / kGrid), 4 * i);
  const newHeader = header.replace(/property double/g, "property float");
  return Buffer.concat([Buffer.from(newHeader), floats, file.subarray(headerEnd + 24 * vertices)]);
}

const [name, ...paths] = process.argv.slice(2);
const out = join(dirname(fileURLToPath(import.meta.url)), "dist", `step-${name}.js`);
const texts = paths.map((path) => deflateSync(withFloats(path), { level: 9 }).toString("base64"));
writeFileSync(out, `(self.tamisSteps ??= {})[${JSON.stringify(name)}] = ${JSON.stringify(texts)};\n`);
