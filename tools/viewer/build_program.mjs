// Builds the site's first page: node build_program.mjs [OUT.html]. Beside it lie the other files of tools/program/dist, and the viewer.
import { writeFile } from "node:fs/promises";
import { join } from "node:path";
import { bundle, folder, page } from "./bundle.mjs";

const out = process.argv[2] ?? join(folder, "..", "program", "dist", "index.html");
const worker = JSON.stringify(await bundle("program/worker.ts")).replaceAll("</", "<\\/");
await writeFile(
  out,
  await page("program/page.html", "program/style.css", "program/main.ts", `self.tamisWorker=${worker};`),
);
