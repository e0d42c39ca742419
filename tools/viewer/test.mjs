// Bundles the tests of a folder and runs them: node test.mjs [FOLDER [BEGINNING OF A NAME]], as in `node test.mjs test pose` or
// `node test.mjs test/timed`. Needs TAMIS_COMMAND, the command to test.
import { spawnSync } from "node:child_process";
import { readdir, rm } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const folder = dirname(fileURLToPath(import.meta.url));
// The bundles are below node_modules, so that they find the packages that they import.
const out = join(folder, "node_modules", ".tests", String(process.pid));
const [tests = "test", chosen = ""] = process.argv.slice(2);
const names = (await readdir(join(folder, tests))).filter(
  (name) => name.startsWith(chosen) && name.endsWith(".test.ts"),
);
await build({
  entryPoints: names.map((name) => join(folder, tests, name)),
  outdir: out,
  outExtension: { ".js": ".mjs" },
  bundle: true,
  platform: "node",
  format: "esm",
  target: "node18",
  packages: "external",
  logLevel: "warning",
});
const files = names.map((name) => join(out, name.replace(/\.ts$/, ".mjs")));
const { status } = spawnSync(process.execPath, ["--test", ...files], { stdio: "inherit" });
await rm(out, { recursive: true, force: true });
process.exit(status ?? 1);
