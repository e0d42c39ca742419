// Bundles src/ into one HTML file that refers to no other file or address: node build.mjs [OUT.html]
import { readFile, mkdir, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const folder = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2] ?? join(folder, "dist", "viewer.html");

const bundle = async (entry, options) => {
  const result = await build({
    entryPoints: [join(folder, "src", entry)],
    bundle: true,
    minify: true,
    write: false,
    charset: "ascii",
    legalComments: "none",
    ...options,
  });
  return result.outputFiles[0].text.trim();
};

const script = await bundle("main.ts", { format: "iife", target: "es2022" });
const style = await bundle("style.css", {});
if (script.includes("</script")) throw new Error("the bundle would end its own script element");
const page = (await readFile(join(folder, "src", "page.html"), "utf8"))
  .replace("/*STYLE*/", () => style)
  .replace("/*SCRIPT*/", () => script);
await mkdir(dirname(out), { recursive: true });
await writeFile(out, page);
