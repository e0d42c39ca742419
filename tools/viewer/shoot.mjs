// Takes a picture of a page after pressing keys: node shoot.mjs PAGE.html OUT.png [WIDTHxHEIGHT] [dark|light] [KEY...]
// With the key k the picture is that which the page saves: the drawing alone.
import { resolve } from "node:path";
import { chromium } from "playwright-core";

const [page, out, size = "1280x720", colorScheme = "dark", ...keys] = process.argv.slice(2);
const [width, height] = size.split("x").map(Number);
const browser = await chromium.launch({
  executablePath: process.env.TAMIS_CHROMIUM ?? "/usr/bin/chromium",
  args: ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-sandbox"],
});
const tab = await browser.newPage({ viewport: { width, height }, colorScheme, reducedMotion: "reduce" });
const [file, hash = ""] = page.split("#");
await tab.goto(`file://${resolve(file)}${hash && `#${hash}`}`);
await tab.waitForFunction(() => window.tamis);
for (const key of keys.filter((each) => each !== "k")) {
  await tab.keyboard.press(key);
  await tab.waitForTimeout(300);
}
// Hides the message at the start, which would cover the picture.
await tab.waitForTimeout(1000);
await tab.waitForFunction(() => !window.tamis.stage?.isBusy, null, { timeout: 120000 });
await tab.evaluate(() => document.getElementById("toast").remove());
if (keys.includes("k")) {
  const saved = tab.waitForEvent("download");
  await tab.keyboard.press("k");
  await (await saved).saveAs(out);
} else {
  await tab.screenshot({ path: out });
}
await browser.close();
