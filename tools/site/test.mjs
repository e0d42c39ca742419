// Reads the site as its users do, from files, in Chromium: node test.mjs SITE [SCREENSHOTS]. Nothing is loaded from elsewhere, the
// search finds, both colour schemes differ, and no page is wider than a phone. Pictures go to the folder SCREENSHOTS, if given.
import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { join, relative, resolve } from "node:path";

const { chromium } = createRequire(new URL("../viewer/package.json", import.meta.url))("playwright-core");
const [site, screenshots] = process.argv.slice(2).map((folder) => resolve(folder));
const phone = { width: 390, height: 844 };
const desk = { width: 1280, height: 800 };
const browser = await chromium.launch({
  executablePath: process.env.TAMIS_CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox"],
});

/** Opens a page of the site in a window of its own; a request to a server fails the test. */
async function open(page, viewport, colorScheme = "light") {
  const tab = await browser.newPage({ viewport, colorScheme });
  tab.on("request", (request) => assert.match(request.url(), /^(file|data|blob):/, `${page} loads ${request.url()}`));
  tab.on("pageerror", (error) => assert.fail(`${page}: ${error}`));
  await tab.goto(`file://${join(site, page)}`);
  return tab;
}

async function shoot(tab, name) {
  if (screenshots) await tab.screenshot({ path: join(screenshots, `${name}.png`) });
}

const background = (tab) => tab.evaluate(() => getComputedStyle(document.body).backgroundColor);

async function testColours() {
  const [light, dark] = [await open("index.html", desk, "light"), await open("index.html", desk, "dark")];
  assert.notEqual(await background(light), await background(dark), "dark and light look the same");
  await shoot(light, "first-light");
  await shoot(dark, "first-dark");
}

async function testSearch(words, wanted) {
  const tab = await open("index.html", desk);
  await tab.fill(".sidebar-search", words);
  await tab.press(".sidebar-search", "Enter");
  await tab.waitForFunction(() => /finished/.test(document.querySelector(".search-summary")?.textContent));
  const found = await tab.$$eval("ul.search li a", (links) => links.map((link) => link.getAttribute("href")));
  assert.ok(
    found.some((href) => href.includes(wanted)),
    `a search for '${words}' finds ${found}, not ${wanted}`,
  );
  await shoot(tab, `search-${words.replaceAll(" ", "-")}`);
  await tab.close();
}

async function testPhone() {
  const tab = await open("index.html", phone);
  const pages = readdirSync(site, { recursive: true }).filter((name) => name.endsWith(".html"));
  for (const page of pages.filter((name) => !name.startsWith(join("docs", "looking") + "/"))) {
    await tab.goto(`file://${join(site, page)}`);
    const width = await tab.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(
      width <= phone.width,
      `${relative(site, join(site, page))} is ${width} wide on a phone of ${phone.width}`,
    );
  }
}

async function testPictures() {
  for (const [page, name] of [
    ["docs/cpp.html", "cpp"],
    ["docs/concepts.html", "concepts"],
    ["reference/cpp/detector.html", "reference-cpp"],
    ["reference/c/detector.html", "reference-c"],
    ["reference/python/detector.html", "reference-python"],
  ]) {
    await shoot(await open(page, desk), name);
    await shoot(await open(page, phone, "dark"), `${name}-phone`);
  }
  await shoot(await open("index.html", phone), "first-phone");
}

try {
  await testColours();
  await testSearch("safe_step", "reference/cpp/detector.html");
  await testSearch("robot", "docs/worlds.html");
  await testPhone();
  if (screenshots) await testPictures();
  console.log("the site reads well in Chromium");
} finally {
  await browser.close();
}
