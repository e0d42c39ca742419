// The page of an audit: a strip of all frames, and the pairs in each.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import { launch, open, picture, settled } from "./browser";
import { Folder, obj, sheet } from "./command";

const folder = new Folder();
const kFrames = 12;
/** The frames in which the falling sheet passes through the other one. */
const kThrough = [6, 7, 8];
let browser: Browser;

before(async () => {
  const low = sheet(9, 0, 0.1, 0);
  for (let i = 0; i < kFrames; ++i) {
    const high = sheet(7, kThrough.includes(i) ? 0.02 : 1 - 0.01 * i, -0.1, low.vertices.length);
    folder.write(`f${i}.obj`, obj([...low.vertices, ...high.vertices], `${low.faces}\n${high.faces}`));
  }
  folder.run("audit . --out report.html --out-frames frames.csv", 1);
  browser = await launch();
});

after(() => {
  folder.remove();
});

interface Found {
  frame: number;
  intersections: number;
  contacts: number;
}

const badFrames = (): Found[] =>
  (
    JSON.parse(folder.run("audit . --json", 1)) as {
      bad_frames: { frame: number; intersections: number; contacts: Record<string, number> }[];
    }
  ).bad_frames.map(({ frame, intersections, contacts }) => ({
    frame,
    intersections,
    contacts: Object.values(contacts).reduce((sum, n) => sum + n, 0),
  }));

// Bug: the page shows other pairs, or other frames, than the command found.
void test("each frame has the pairs that the command found, at their places", async () => {
  const { page, faults } = await open(browser, folder.file("report.html"));
  const shown = await page.evaluate(() => {
    const { session } = window.tamis!;
    const { scene } = session;
    const strip = scene.header.strip!;
    return strip.steps.map((step, frame) => {
      session.showStep(step);
      const { first, count } = session.view.step;
      const kinds = Array.from({ length: count }, (_, k) => scene.contacts.kindOf(first + k).name);
      let off = 0;
      kinds.forEach((_, k) => {
        session.select(first + k);
        const pair = session.pair!;
        const apart = pair.firstPoint(pair.toi).map((x, axis) => Math.abs(x - pair.secondPoint(pair.toi)[axis]));
        off = Math.max(off, ...apart);
      });
      const intersections = kinds.filter((kind) => kind === "ef").length;
      return { frame, intersections, contacts: count - intersections, off };
    });
  });
  assert.equal(shown.length, kFrames);
  const bad = shown.filter(({ intersections, contacts }) => intersections + contacts > 0);
  assert.deepEqual(
    bad.map(({ frame, intersections, contacts }) => ({ frame, intersections, contacts })),
    badFrames(),
  );
  assert.deepEqual(
    shown.filter(({ intersections }) => intersections > 0).map(({ frame }) => frame),
    kThrough,
  );
  // Weights are stored with sixteen bits, positions with twenty-four.
  for (const { off } of shown) assert.ok(off < 1e-3, `${off}`);
  assert.deepEqual(faults, []);
});

// Bug: a click in the strip goes nowhere, or to another frame.
void test("opens at the first bad frame, and the strip leads to the others", async () => {
  const { page, faults } = await open(browser, folder.file("report.html"));
  const readout = async (): Promise<string | null> => page.textContent("#step-readout");
  assert.equal(await readout(), `frame ${kThrough[0]} / ${kFrames}`);
  assert.ok((await page.textContent("#answer"))?.includes("intersections, "));
  await settled(page);
  await picture(page, "audit");
  const time = (): Promise<number> => page.evaluate(() => window.tamis!.session.store.now.time);
  await page.click("#next-bad");
  assert.equal(await readout(), `frame ${kThrough[1]} / ${kFrames}`);
  assert.equal(await time(), 1);
  const box = (await page.locator("#strip").boundingBox())!;
  await page.mouse.click(box.x + (2.5 / kFrames) * box.width, box.y + box.height / 2);
  assert.equal(await readout(), `frame 2 / ${kFrames}`);
  assert.ok((await page.textContent("#answer"))?.includes("nothing was found"));
  await page.keyboard.press("PageDown");
  assert.equal(await readout(), `frame 3 / ${kFrames}`);
  // Bug: one key shows the frame that the numbers are about, another one the frame before it.
  assert.equal(await time(), 1);
  await page.keyboard.press("PageUp");
  assert.equal(await time(), 1);
  await page.keyboard.press("PageDown");
  assert.equal(await page.locator('[data-tab="sieve"]').count(), 0);
  for (const pressed of ["s", "f", "1", "n", "p", "e", "v"]) await page.keyboard.press(pressed);
  await settled(page);
  assert.deepEqual(faults, []);
});

// Bug: pairs that are there from the first frame on bury those of an accident, as the first bad frame is always 0.
void test("pairs that the frame before does not have are told apart, and found first", async () => {
  const still = sheet(6, 0.02, -0.1, 0);
  for (let i = 0; i < kFrames; ++i) {
    const text = readFileSync(folder.file(`f${i}.obj`), "utf8");
    const count = text.split("\n").filter((line) => line.startsWith("v ")).length;
    // Two more sheets, which pass through each other in every frame.
    const more = [0, 0.01].map((z, k) => {
      const vertices = still.vertices.map(([x, y, w]) => [x + 3, y, (k ? -1 : 1) * w + z]);
      const first = count + k * still.vertices.length;
      return obj(
        vertices,
        still.faces.replace(/\d+/g, (v) => String(Number(v) + first)),
      );
    });
    folder.write(`p${i}.obj`, text + more.join(""));
  }
  const names = Array.from({ length: kFrames }, (_, i) => `p${i}.obj`).join(" ");
  folder.run(`audit ${names} --out permanent.html`, 1);
  const { page, faults } = await open(browser, folder.file("permanent.html"));
  const { first_new: first, first_bad: bad } = JSON.parse(folder.run(`audit ${names} --json`, 1)) as {
    first_new: { frame: number; new: number };
    first_bad: { frame: number };
  };
  assert.equal(bad.frame, 0);
  assert.equal(first.frame, kThrough[0]);
  assert.equal(await page.textContent("#step-readout"), `frame ${first.frame} / ${kFrames}`);
  assert.ok((await page.textContent("#answer"))?.includes(`${first.new} new since the frame before`));
  await page.keyboard.press("w");
  assert.equal(await page.getAttribute("#listed", "data-count"), String(first.new));
  await picture(page, "audit-new");
  await page.click("#next-new");
  assert.equal(await page.textContent("#step-readout"), `frame ${kThrough[2] + 1} / ${kFrames}`);
  assert.deepEqual(faults, []);
});
