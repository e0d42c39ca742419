// No page says "proven" of what was not proven, whatever its panels, keys and steps.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { launch, open, picture } from "./browser";
import { Folder, obj, sheet } from "./command";

const folder = new Folder();
let browser: Browser;

before(async () => {
  // Two sheets that pass through each other for ever; beside them one that falls through another.
  const low = sheet(9, 0, 0.1, 0);
  const high = sheet(7, 0.02, -0.1, 0);
  const parts = (fall: number): { vertices: number[][]; faces: string }[] => [
    low,
    high,
    { ...low, vertices: low.vertices.map(([x, y, z]) => [x + 1.5, y, z]) },
    { ...high, vertices: high.vertices.map(([x, y, z]) => [x + 1.5, y, z + 0.9 - fall]) },
  ];
  for (let i = 0; i < 6; ++i) {
    const vertices: number[][] = [];
    const faces: string[] = [];
    for (const part of parts(0.3 * i)) {
      faces.push(part.faces.replace(/\d+/g, (v) => String(Number(v) + vertices.length)));
      vertices.push(...part.vertices);
    }
    folder.write(`f${i}.obj`, obj(vertices, faces.join("\n")));
  }
  folder.run("audit f0.obj f1.obj f2.obj f3.obj f4.obj f5.obj --out report.html", 1);
  browser = await launch();
});

after(() => {
  folder.remove();
});

/** All that the page shows as text, in elements that are seen and in drawings that have been drawn since. */
const saidBy = (page: Page, act: () => Promise<void>): Promise<string> =>
  page
    .evaluate(() => {
      const spoken: string[] = [];
      (window as unknown as { spoken: string[] }).spoken = spoken;
      const { fillText } = Object.getPrototypeOf(document.createElement("canvas").getContext("2d")!) as {
        fillText: (text: string, x: number, y: number) => void;
      };
      const prototype = CanvasRenderingContext2D.prototype;
      prototype.fillText = function (text: string, x: number, y: number): void {
        if (this.canvas.checkVisibility()) spoken.push(text);
        fillText.call(this, text, x, y);
      };
    })
    .then(act)
    .then(() =>
      page.evaluate(() => [document.body.innerText, ...(window as unknown as { spoken: string[] }).spoken].join("\n")),
    );

const intersectionOf = (page: Page): Promise<number> =>
  page.evaluate(() => {
    const { view, scene } = window.tamis!.session;
    return [...view.byTime].find((i) => scene.contacts.kindOf(i).name === "ef")!;
  });

// Bug: the panel of an intersection draws a gap, a bracket of one double, and "free, proven | touches in here".
void test("an intersection has a panel without times, and with no word of proof but that it is decided", async () => {
  const { page, faults } = await open(browser, folder.file("report.html"));
  const pair = await intersectionOf(page);
  const said = await saidBy(page, async () => {
    await page.evaluate((i) => {
      window.tamis!.session.select(i);
    }, pair);
    for (const pressed of ["1", "2", "3", "o", "t", "t"]) await page.keyboard.press(pressed);
  });
  const panel = (await page.locator("#pair").innerText()).toLowerCase();
  assert.ok(panel.includes("meets face") && panel.includes("decided exactly"), panel);
  for (const word of ["proven", "bracket", "gap", "free", "touches", "certified", "before"])
    assert.ok(!panel.includes(word), `${word}: ${panel}`);
  for (const word of ["free, proven", "touches in here", "gap along"]) assert.ok(!said.includes(word), said);
  assert.equal(await page.evaluate(() => window.tamis!.session.store.now.time), 1);
  await picture(page, "audit-intersection");
  assert.deepEqual(faults, []);
});

// Bug: the sieve of a page whose question has none says "100 % of all pairs are proven free ... 0 touch".
void test("a sieve is shown only where the counts of stages were kept", async () => {
  const { page } = await open(browser, folder.file("report.html"), "#panel=sieve");
  await page.keyboard.press("v");
  assert.equal(await page.locator("#sieve").isVisible(), false);
  const said = await saidBy(page, () => page.keyboard.press("t"));
  assert.ok(!said.includes("of all pairs"), said);
  assert.ok(!said.toLowerCase().includes("sieve"), said);
});

// Bug: of a frame with intersections alone "What stops this step" says "Free before 1, proven. This pair ends it."
void test("no intersection ends a step", async () => {
  const { page } = await open(browser, folder.file("report.html"), "#step=0");
  await page.keyboard.press("s");
  assert.equal(await page.textContent("#toast"), "Nothing stops this step: no step to this frame was asked about.");
  assert.equal(await page.evaluate(() => window.tamis!.session.store.now.selected), -1);
});

// Bug: "0 contacts" and "nothing was found" are said of what was not asked about.
for (const [option, absent] of [
  ["--no-contacts", /contact|proven|free before/i],
  ["--no-intersections", /\d intersection/i],
] as const)
  void test(`${option}: the page is silent of what was not asked about`, async () => {
    const frames = "f0.obj f1.obj f2.obj f3.obj f4.obj f5.obj";
    folder.run(`audit ${frames} ${option} --out half.html`, 1);
    const { page } = await open(browser, folder.file("half.html"));
    const steps = await page.evaluate(() => window.tamis!.session.scene.stepCount);
    for (let step = 0; step < steps; ++step) {
      await page.evaluate((i) => {
        window.tamis!.session.showStep(i);
      }, step);
      const answer = (await page.textContent("#answer")) ?? "";
      assert.ok(!absent.test(answer), answer);
    }
  });

// Bug: a frame that could not be used is shown as one without intersections.
void test("a frame that was not asked about is called so", async () => {
  folder.write("f4.obj", "v 1 2");
  folder.run("audit f3.obj f4.obj f5.obj --out problem.html", 1);
  const { page } = await open(browser, folder.file("problem.html"));
  const box = (await page.locator("#strip").boundingBox())!;
  await page.mouse.move(box.x + 0.5 * box.width, box.y + box.height / 2);
  const title = (await page.getAttribute("#strip", "title")) ?? "";
  assert.ok(title.startsWith("frame 1, f4.obj: not asked about: "), title);
});

// Bug: "free before ..., proven" of pairs that touch from the start, and were ignored.
void test("where pairs were ignored at the start, each proof says so", async () => {
  folder.run("view f2.obj f3.obj --at-start ignore --out ignored.html");
  const { page } = await open(browser, folder.file("ignored.html"));
  const said = await saidBy(page, async () => {
    for (const pressed of ["s", "t"]) await page.keyboard.press(pressed);
  });
  assert.ok((await page.textContent("#answer"))?.includes("proven, but for pairs that touch at the start"), said);
  assert.ok(said.includes("free, or ignored") && !said.includes("free, proven"), said);
  await page.keyboard.press("v");
  assert.ok((await page.textContent("#sieve"))?.includes("touch at the start and are ignored"));
});
