// Pages of very many objects and contacts: what is drawn is bounded, and keys are answered.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { kMostMarks } from "../../src/session";
import { kDraftSegments } from "../../src/view3d/large";
import { answerTo, launch, open, picture } from "../browser";
import { Folder, obj } from "../command";

const folder = new Folder();
let browser: Browser;

before(async () => {
  browser = await launch();
});

after(() => {
  folder.remove();
});

/** Seconds are generous: the machine may be shared. Without drafts a key took twelve. */
const kLongestAnswer = 4000;

async function assertAnswers(page: Page, keys: string[]): Promise<void> {
  const times: string[] = [];
  for (const key of keys) {
    const time = await answerTo(page, key);
    times.push(`${key} ${time.toFixed(0)}`);
    assert.ok(time < kLongestAnswer, `${key}: ${time} ms`);
  }
  console.log(`keys, in ms: ${times.join(", ")}`);
}

/** Cubes in piles of twenty, whose members fall by different amounts. */
function piles(count: number): string {
  const points = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [(i & 1) - 0.5, ((i >> 1) & 1) - 0.5, (i >> 2) - 0.5]);
  const sides = "021 123 456 576 014 154 263 367 042 246 135 375".split(" ");
  const side = Math.ceil(Math.sqrt(count / 20));
  const bodies = Array.from({ length: count }, (_, i) => {
    const [level, pile] = [i % 20, Math.floor(i / 20)];
    const [x, y, z] = [1.6 * (pile % side), 1.6 * Math.floor(pile / side), 1.3 * level];
    const angle = 0.3 * Math.sin(i);
    const quaternion = [Math.cos(angle), 0.6 * Math.sin(angle), 0.8 * Math.sin(angle), 0];
    const fall = level === 0 ? 0 : 0.335 * level + 0.05 * Math.sin(7 * i);
    const poses = [z, z - fall].map((height) => ({ position: [x, y, height], quaternion }));
    return { name: `/World/Pile_${pile}/Box_${level}`, mesh: "cube", poses };
  });
  return JSON.stringify({ meshes: { cube: { points, faces: sides.map((f) => Array.from(f, Number)) } }, bodies });
}

// Bug: each mark, normal and feature of 300,000 contacts is drawn, so that a key waits for seconds.
void test("60,000 objects with 294,000 contacts: bounded marks and rows, and every key is answered", async () => {
  folder.write("piles.json", piles(60_000));
  folder.run("bodies piles.json --out piles.html", 1);
  const { page, faults } = await open(browser, folder.file("piles.html"));
  const listed = Number(await page.getAttribute("#listed", "data-count"));
  assert.ok(listed > 290_000, `${listed} contacts`);
  const drawn = await page.evaluate(() => window.tamis!.session.drawn.length);
  assert.ok(drawn <= kMostMarks && drawn > kMostMarks / 2, `${drawn} marks`);
  const said = (await page.textContent("#listed")) ?? "";
  assert.ok(said.endsWith(`; ${drawn.toLocaleString("en-US")} of them are drawn`), said);
  assert.ok((await page.locator(".row").count()) < 60);
  await assertAnswers(page, ["Shift+ArrowLeft", "e", "n", "p", "x", "z", "r", "f", "ArrowDown", "Escape", "[", "\\"]);
  const triangles = await page.evaluate(() => window.tamis!.stage!.cost.triangles);
  assert.ok(triangles <= 60_000 + 2 * 2 * kDraftSegments, `${triangles} triangles`);
  // A filter that leaves few draws all that are left.
  await page.fill("#object", "/World/Pile_7/Box_3");
  const few = await page.evaluate(() => [window.tamis!.session.rows.length, window.tamis!.session.drawn.length]);
  assert.ok(few[0] > 0 && few[0] === few[1], few.join(" "));
  await picture(page, "piles");
  assert.deepEqual(faults, []);
});

// Bug: drafts count triangles and marks alone, so that strands are drawn in full while anything moves.
void test("60,000 strands of ten rods each: every key is answered", async () => {
  const [strands, rods] = [60_000, 10];
  const vertices: number[][] = [];
  const lines: string[] = [];
  for (let i = 0; i < strands; ++i) {
    const [along, across] = [10.5 * Math.floor(i / 346), (i >> 1) % 173];
    for (let k = 0; k <= rods; ++k) {
      const [x, y] = [along + k, across + 0.3 * Math.sin(k + i)];
      vertices.push(i % 2 ? [y, x, 1 + 0.1 * Math.sin(i + k)] : [x, y, 0.1 * Math.cos(3 * i + k)]);
    }
    lines.push(`l ${Array.from({ length: rods + 1 }, (_, k) => i * (rods + 1) + k + 1).join(" ")}`);
  }
  folder.write("start.obj", obj(vertices, lines.join("\n")));
  const isUpper = (v: number): boolean => Math.floor(v / (rods + 1)) % 2 === 1;
  const fallen = vertices.map(([x, y, z], v) => [x, y, isUpper(v) ? z - 1.6 : z]);
  folder.write("end.obj", obj(fallen, lines.join("\n")));
  folder.run("view start.obj end.obj --out strands.html");
  const { page, faults } = await open(browser, folder.file("strands.html"));
  await assertAnswers(page, ["Shift+ArrowLeft", "n", "p", "z", "f", "Escape"]);
  const triangles = await page.evaluate(() => window.tamis!.stage!.cost.triangles);
  assert.ok(triangles <= 3 * 2 * kDraftSegments, `${triangles} triangles`);
  assert.deepEqual(faults, []);
});

// Bug: a large page says "Opening" until it is open, and looks as if nothing happened.
void test("a large page says what it does while it opens, and how much is done", async () => {
  const page = await browser.newPage();
  await page.addInitScript(() => {
    const seen: string[] = [];
    Object.assign(window, { seen });
    addEventListener("DOMContentLoaded", () => {
      new MutationObserver(() => {
        const bar = document.querySelector<HTMLProgressElement>("#opening progress");
        if (bar && !bar.hidden) seen.push(`${bar.value.toFixed(2)} ${bar.parentElement!.textContent}`);
      }).observe(document.body, { childList: true, subtree: true, characterData: true });
    });
  });
  await page.goto(`file://${folder.file("piles.html")}`);
  await page.waitForFunction(() => window.tamis);
  const seen = await page.evaluate(() => (window as unknown as { seen: string[] }).seen);
  for (const words of ["Reading 0.0 of ", "Unpacking 29", "720,000 triangles", "Sorting contacts", "Drawing"])
    assert.ok(
      seen.some((each) => each.includes(words)),
      `${words} in ${seen.join("; ")}`,
    );
  const parts = seen.map((each) => Number(each.split(" ")[0]));
  assert.deepEqual(parts, [...parts].sort());
  assert.equal(await page.locator("#opening").count(), 0);
  await page.close();
});
