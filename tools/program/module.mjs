// node module.mjs pack FOLDER: puts tamis.js and tamis.wasm of a folder into dist/module.js, the wasm compressed, in base64.
// node module.mjs same FOLDER: fails unless dist/module.js holds these bytes. (Compressed ones depend on the version of Node.)
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { deflateSync, inflateSync } from "node:zlib";

const [verb, folder] = process.argv.slice(2);
const file = join(dirname(fileURLToPath(import.meta.url)), "dist", "module.js");
const script = readFileSync(join(folder, "tamis.js"), "utf8");
const wasm = readFileSync(join(folder, "tamis.wasm"));
const before = "self.tamisModule = ";

if (verb === "pack") {
  const packed = { script, wasm: deflateSync(wasm, { level: 9 }).toString("base64") };
  writeFileSync(file, `${before}${JSON.stringify(packed)};\n`);
} else {
  const held = JSON.parse(readFileSync(file, "utf8").slice(before.length, -2));
  if (held.script !== script || !inflateSync(Buffer.from(held.wasm, "base64")).equals(wasm)) {
    console.error("tools/program/dist/module.js is not what the sources give: scripts/program_module.sh");
    process.exit(1);
  }
}
