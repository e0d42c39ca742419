// node pack.mjs FOLDER: fills FOLDER with the package of npm: compiles src by the viewer's TypeScript, and writes module.js of
// tools/program/dist/module.js, which scripts/program_module.sh makes.
import { spawnSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, "../..");
const folder = process.argv[2];
const tsc = join(root, "tools/viewer/node_modules/typescript/bin/tsc");
if (!existsSync(tsc)) {
  console.error("skipped: no TypeScript here: run npm ci in tools/viewer");
  process.exit(77);
}
mkdirSync(folder, { recursive: true });
if (spawnSync(process.execPath, [tsc, "-p", here, "--outDir", folder], { stdio: "inherit" }).status !== 0) process.exit(1);

const held = readFileSync(join(root, "tools/program/dist/module.js"), "utf8");
const { script, wasm } = JSON.parse(held.slice(held.indexOf("{"), held.lastIndexOf("}") + 1));
const { version } = JSON.parse(readFileSync(join(here, "package.json"), "utf8"));
// The module tests whether it runs in Node, and would then take Node's own functions. It needs none: the bytes are given.
writeFileSync(
  join(folder, "module.js"),
  `// The C interface of Tamis as emscripten compiles it, and its bytes: deflated, in base64.
const wasm = "${wasm}";
const create = ((process, require, module, exports, define) => {
${script}
return createTamis;
})();
let bytes;
async function inflated() {
  const packed = Uint8Array.from(atob(wasm), (c) => c.charCodeAt(0));
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();
}
export const version = "${version}";
export async function createModule() {
  return create({ wasmBinary: await (bytes ??= inflated()) });
}
`,
);
for (const name of ["package.json", "README.md", "examples"]) cpSync(join(here, name), join(folder, name), { recursive: true });
for (const name of ["hello.mjs", "bodies.mjs", "curve.mjs"]) cpSync(join(root, "examples", name), join(folder, "examples", name));
cpSync(join(here, "src/module.d.ts"), join(folder, "module.d.ts"));
cpSync(join(root, "LICENSE"), join(folder, "LICENSE"));
cpSync(join(root, "packaging/debian/copyright"), join(folder, "LICENCES"));
