// One HTML page of src/: its script and style stand in it, and it needs nothing from elsewhere.
import { readFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

export const folder = dirname(fileURLToPath(import.meta.url));

/** The minified text of src/ENTRY and of what it imports. */
export async function bundle(entry, options = {}) {
  const result = await build({
    entryPoints: [join(folder, "src", entry)],
    bundle: true,
    minify: true,
    write: false,
    charset: "ascii",
    legalComments: "none",
    ...(entry.endsWith(".ts") ? { format: "iife", target: "es2022" } : {}),
    ...options,
  });
  return result.outputFiles[0].text.trim();
}

/** The page whose parts these are, below src/. `before`: a script that runs first. */
export async function page(html, style, script, before = "") {
  const text = before + (await bundle(script));
  if (text.includes("</script")) throw new Error("the bundle would end its own script element");
  const css = await bundle(style);
  return (await readFile(join(folder, "src", html), "utf8"))
    .replace("/*STYLE*/", () => css)
    .replace("/*SCRIPT*/", () => text);
}
