// Builds the viewer as one HTML file that refers to no other file or address: node build.mjs [OUT.html]
import { mkdir, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { folder, page } from "./bundle.mjs";

const out = process.argv[2] ?? join(folder, "dist", "viewer.html");
await mkdir(dirname(out), { recursive: true });
await writeFile(out, await page("page.html", "style.css", "main.ts"));
