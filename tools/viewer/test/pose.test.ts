// The page of a single frame: it shows intersections, and has no time.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import { launch, open, picture, settled } from "./browser";
import { Folder, obj, sheet } from "./command";

const folder = new Folder();
let browser: Browser;

before(async () => {
  // Two wavy sheets at nearly the same height.
  const low = sheet(9, 0, 0.1, 0);
  const high = sheet(7, 0.02, -0.1, low.vertices.length);
  folder.write("pose.obj", obj([...low.vertices, ...high.vertices], `${low.faces}\n${high.faces}`));
  folder.write("one.obj", obj(low.vertices, low.faces));
  browser = await launch();
});

after(() => {
  folder.remove();
});

// Bug: the five vertices of an edge and a face are read as the four of a contact.
void test("holds the intersections of the table, at their places", async () => {
  folder.run("view pose.obj --out rows.csv");
  const [, ...rows] = readFileSync(folder.file("rows.csv"), "utf8").trim().split("\n");
  const lines = rows.map((row) => row.split(",").slice(0, 5).join(","));
  folder.run("view pose.obj --out pose.html");
  const { page, faults } = await open(browser, folder.file("pose.html"));
  const shown = await page.evaluate(() => {
    const { scene, view } = window.tamis!.session;
    const { contacts } = scene;
    return Array.from({ length: contacts.count }, (_, i) => {
      window.tamis!.session.select(i);
      const pair = window.tamis!.session.pair!;
      const apart = pair.firstPoint(0).map((x, axis) => x - pair.secondPoint(0)[axis]);
      const mark = [...view.marks.start.subarray(3 * i, 3 * i + 3)].map((x, axis) => x - pair.firstPoint(0)[axis]);
      return { vertices: [...pair.first, ...pair.second], off: Math.max(...[...apart, ...mark].map(Math.abs)) };
    });
  });
  assert.ok(lines.length > 10);
  assert.deepEqual(
    shown.map(({ vertices }) => vertices.join(",")),
    lines,
  );
  // Weights are stored with sixteen bits.
  for (const { off } of shown) assert.ok(off < 1e-4, `${off}`);
  assert.equal(await page.getAttribute("#count", "data-count"), String(lines.length));
  assert.deepEqual(faults, []);
});

// Bug: the page shows times and a motion, which a single frame does not have.
void test("says what it shows, and shows no time", async () => {
  folder.run("view pose.obj --out pose.html");
  const { page, faults } = await open(browser, folder.file("pose.html"));
  assert.ok((await page.textContent("#answer"))?.includes("edges that pass through triangles"));
  assert.equal(await page.textContent("h1"), "Tamis pose.obj");
  for (const absent of [".dock", "#stops", ".row > :first-child"])
    assert.equal(await page.locator(absent).first().isVisible(), false, absent);
  await picture(page, "pose");
  await page.click("#first");
  assert.ok((await page.textContent("#pair h2"))?.startsWith("edge "));
  assert.ok((await page.textContent("#pair h2"))?.includes("meets face "));
  assert.equal(await page.locator(".gap").isVisible(), false);
  await settled(page);
  await picture(page, "pose-pair");
  await page.keyboard.press("v");
  assert.ok((await page.textContent(".sieve-title"))?.endsWith("intersections"));
  await picture(page, "pose-sieve");
  for (const pressed of ["s", " ", "o", "1", "ArrowLeft", "PageDown", "n", "p", "e"])
    await page.keyboard.press(pressed);
  await settled(page);
  assert.deepEqual(faults, []);
});

void test("a frame without intersections is proven so", async () => {
  folder.run("view one.obj --out one.html");
  const { page, faults } = await open(browser, folder.file("one.html"));
  const answer = (await page.textContent("#answer")) ?? "";
  assert.ok(
    answer.includes(
      "no intersection: no edge passes through or touches a triangle that shares no vertex with it, proven.",
    ),
    answer,
  );
  await picture(page, "pose-free");
  assert.deepEqual(faults, []);
});
