// node in_browser.mjs FOLDER: serves a folder, opens its page in Chromium, and expects the worker's answer in it.
import { createServer } from "node:http";
import { existsSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { extname, join } from "node:path";

const { chromium } = createRequire(new URL("../../../tools/viewer/", import.meta.url))("playwright-core");
const executablePath = process.env.TAMIS_CHROMIUM ?? "/usr/bin/chromium";
if (!existsSync(executablePath)) {
  console.log(`skipped: no Chromium in ${executablePath}`);
  process.exit(77);
}
const types = { ".html": "text/html", ".js": "text/javascript" };
const server = createServer(({ url }, response) => {
  const file = join(process.argv[2], url === "/" ? "index.html" : url.slice(1));
  if (!existsSync(file)) return response.writeHead(404).end();
  response.writeHead(200, { "content-type": types[extname(file)] ?? "application/octet-stream" }).end(readFileSync(file));
});
await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
const browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
const page = await browser.newPage();
await page.goto(`http://127.0.0.1:${server.address().port}/`);
await page.waitForFunction(() => document.body.textContent.trim() !== "");
const text = await page.textContent("body");
await browser.close();
server.close();
if (text !== "vertex 3 meets the face at 0.500000") throw new Error(`the page says: ${text}`);
console.log("the bundled page asks its worker, and shows the contact");
