// Builds the site's first page into a folder: node build_program.mjs [FOLDER [MODULE FOLDER]]. The module, which emscripten makes
// (tools/program), stands in module.js: with its folder that is made, else the committed one is taken.
import { copyFile, mkdir, readdir, readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { deflateSync } from "node:zlib";
import { bundle, folder, page } from "./bundle.mjs";

const program = join(folder, "..", "program");
const [out = join(program, "dist"), module] = process.argv.slice(2);
await mkdir(out, { recursive: true });

const worker = await bundle("program/worker.ts");
const before = `self.tamisWorker=${JSON.stringify(worker).replaceAll("</", "<\\/")};`;
await writeFile(
  join(out, "index.html"),
  await page("program/page.html", "program/style.css", "program/main.ts", before),
);
await copyFile(join(folder, "dist", "viewer.html"), join(out, "viewer.html"));
for (const name of await readdir(join(program, "steps")))
  await copyFile(join(program, "steps", name), join(out, `step-${name}`));
if (module) {
  const script = await readFile(join(module, "program.js"), "utf8");
  const wasm = deflateSync(await readFile(join(module, "program.wasm")), { level: 9 }).toString("base64");
  await writeFile(join(out, "module.js"), `self.tamisModule = ${JSON.stringify({ script, wasm })};\n`);
} else if (out !== join(program, "dist")) {
  await copyFile(join(program, "dist", "module.js"), join(out, "module.js"));
}
