// Unusual meshes and browsers: each page opens, or says why not.
import assert from "node:assert/strict";
import { readFileSync, statSync, writeFileSync } from "node:fs";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import { launch, open, picture } from "./browser";
import { Folder, obj, part, sheet } from "./command";

const folder = new Folder();
let browser: Browser;

before(async () => {
  browser = await launch();
});

after(() => {
  folder.remove();
});

/** Writes a step of vertices that fall by `fall`, and opens its page. */
async function openStep(
  name: string,
  vertices: number[][],
  rest: string,
  fall: (v: number) => number,
): Promise<{ answer: string; faults: string[]; frames: number }> {
  folder.write("start.obj", obj(vertices, rest));
  const end = vertices.map(([x, y, z], v) => [x, y, z - fall(v)]);
  folder.write("end.obj", obj(end, rest));
  folder.run(`view start.obj end.obj --out ${name}.html`);
  const { page, faults } = await open(browser, folder.file(`${name}.html`));
  const answer = (await page.textContent("#answer")) ?? "";
  const frames = await page.evaluate(() => window.tamis!.stage!.cost.frames);
  await picture(page, name);
  return { answer, faults, frames };
}

// Bug: a scene without contacts divides by their number.
void test("one triangle, no contact", async () => {
  const corners = [
    [0, 0, 0],
    [1, 0, 0],
    [0, 1, 0],
  ];
  const { answer, faults, frames } = await openStep("one-triangle", corners, "f 1 2 3", () => 0.5);
  assert.ok(answer.startsWith("1 triangle, no contact") && answer.includes("free, proven"), answer);
  assert.ok(frames > 0);
  assert.deepEqual(faults, []);
});

// Bug: the page expects a surface, which a mesh without triangles does not have.
void test("only rods", async () => {
  const ends = [
    [-1, 0, 0],
    [1, 0.1, 0],
    [0.1, -1, 1],
    [0, 1, 1],
  ];
  const { answer, faults } = await openStep("only-rods", ends, "l 1 2\nl 3 4", (v) => (v < 2 ? 0 : 2));
  assert.ok(answer.includes("1 contact"), answer);
  assert.deepEqual(faults, []);
});

void test("only points, none of which moves", async () => {
  const points = [
    [0, 0, 0],
    [1, 1, 1],
  ];
  const { answer, faults } = await openStep("only-points", points, "p 1\np 2", () => 0);
  assert.ok(answer.includes("no contact"), answer);
  assert.deepEqual(faults, []);
});

// Bug: of a point that meets a rod the sieve says that all pairs are proven free, and of pairs that no question was asked
// about, too.
void test("the sieve counts what loose points meet, and does not call neighbours free", async () => {
  const points = [
    [0, 0, 0],
    [1, 0, 0],
    [0.5, 0, 1],
    [3, 3, 3],
  ];
  folder.write("start.obj", obj(points, "l 1 2\np 3 4"));
  folder.write(
    "end.obj",
    obj(
      points.map(([x, y, z], v) => [x, y, v === 2 ? -1 : z]),
      "l 1 2\np 3 4",
    ),
  );
  folder.run("view start.obj end.obj --out sieve.html");
  const { page, faults } = await open(browser, folder.file("sieve.html"));
  await page.keyboard.press("v");
  const pairs = (stage: string) => page.getAttribute(`[data-stage="${stage}"]`, "data-pairs");
  assert.equal(await pairs("all pairs"), "3");
  assert.equal(await pairs("solve"), "1");
  assert.equal(
    await page.getAttribute('[data-stage="contacts"]', "title"),
    "0 vertex-face, 0 edge-edge, 1 vertex-edge, 0 vertex-vertex",
  );
  assert.ok((await page.textContent("#sieve"))?.includes("66.6 % of all pairs are proven free, or not asked about"));
  assert.deepEqual(faults, []);
});

// Bug: positions are quantised over the box of all vertices, unused ones included.
void test("huge coordinates, and a vertex that nothing uses far away", async () => {
  const corners = [
    [1e300, 0, 0],
    [1.1e300, 0, 0],
    [1e300, 1e299, 0],
    [1.02e300, 3e298, 1e299],
    [-1e308, 1e308, 0],
  ];
  const { answer, faults } = await openStep("huge", corners, "f 1 2 3\np 4", (v) => (v === 3 ? 2e299 : 0));
  assert.ok(answer.includes("1 contact"), answer);
  assert.deepEqual(faults, []);
});

// Bug: code that is fast for a thousand contacts takes minutes for a million, or calls a function with a million
// arguments.
void test(`${part} million contacts open`, async () => {
  const n = 1000 * Math.sqrt(part);
  const lines: string[] = [];
  const vertices: number[][] = [];
  for (const layer of [0, 1])
    for (let i = 0; i < n; ++i) {
      const x = i / n;
      // Slightly tilted, so that contacts have different times.
      vertices.push(layer ? [x, 0, 1] : [0, x, 0], layer ? [x, 1, 1.2] : [1, x, 0.3]);
      lines.push(`l ${vertices.length - 1} ${vertices.length}`);
    }
  folder.write("start.obj", obj(vertices, lines.join("\n")));
  const fallen = vertices.map(([x, y, z], v) => [x, y, v < 2 * n ? z : z - 2]);
  folder.write("end.obj", obj(fallen, lines.join("\n")));
  folder.run("view start.obj end.obj --out million.html");
  assert.ok(statSync(folder.file("million.html")).size < 60e6);
  const { page, faults } = await open(browser, folder.file("million.html"));
  assert.equal(await page.getAttribute("#count", "data-count"), String(n * n));
  await page.click("#first");
  assert.ok(await page.evaluate(() => window.tamis!.session.pair !== null));
  await picture(page, "million");
  assert.deepEqual(faults, []);
});

// Bug: a blank page where the browser cannot draw.
void test("a browser without WebGL 2 is told so, and still lists the contacts", async () => {
  const blind = await launch("--disable-3d-apis");
  const { page } = await open(blind, folder.file("only-rods.html"));
  assert.ok((await page.textContent("#no-webgl"))?.includes("no WebGL 2"));
  assert.equal(await page.locator(".row").count(), 1);
  await page.click("#first");
  assert.ok((await page.textContent("#pair h2"))?.includes("edge 0 1"));
  await picture(page, "no-webgl");
});

// Bug: a page cut short while it was copied stays on "Opening".
void test("a damaged page says that it cannot be shown", async () => {
  const text = await import("node:fs/promises").then((fs) => fs.readFile(folder.file("only-rods.html"), "utf8"));
  const damaged = text.replace(/(id="scene">[\w+/\s]{200})[\w+/=\s]*/, "$1");
  assert.notEqual(damaged, text);
  folder.write("damaged.html", damaged);
  const { page } = await open(browser, folder.file("damaged.html"));
  assert.ok((await page.textContent("#unreadable"))?.startsWith("This page cannot be shown"));
});

// Bug: of a page cut within its data, or within its script, nothing but "Opening" is ever seen.
for (const part of [0.02, 0.33, 0.8, 0.999])
  void test(`a page cut to ${100 * part} % of its size says so`, async () => {
    const wavy = sheet(60, 0, 0.1, 0);
    folder.write("sheet.obj", obj(wavy.vertices, wavy.faces));
    folder.run("view sheet.obj --out long.html");
    const whole = readFileSync(folder.file("long.html"));
    writeFileSync(folder.file("cut.html"), whole.subarray(0, part * whole.length));
    const { page } = await open(browser, folder.file("cut.html"));
    const says = await page.textContent("body");
    assert.ok(says?.trim().startsWith("This page cannot be shown: the file is cut short."), says ?? "");
  });

// Bug: "1 contacts"; a button that screen readers call "black right-pointing triangle"; no mark at the first contact.
void test("what is seen first has a name: one contact, the first contact, the play button, long names", async () => {
  const long = "a-name-".repeat(20);
  const at = (z: number): string =>
    obj(
      [
        [0, 0, 0],
        [1, 0, 0],
        [0, 1, 0],
        [0.2, 0.2, z],
      ],
      "f 1 2 3\np 4",
    );
  for (const [i, z] of [2, 1, -1].entries()) folder.write(`${long}${i}.obj`, at(z));
  folder.run(`view ${long}0.obj ${long}1.obj ${long}2.obj --out named.html`);
  const { page, faults } = await open(browser, folder.file("named.html"), "#step=1");
  assert.equal(await page.getAttribute("#play", "aria-label"), "Play");
  assert.ok((await page.getAttribute("#step-readout", "title"))?.endsWith(", 1 contact"));
  assert.ok(await page.locator(".ring").isVisible());
  assert.equal(await page.locator(".ring").innerText(), "first contact");
  const [card, side] = await Promise.all([".head-card", ".side"].map((name) => page.locator(name).boundingBox()));
  assert.ok(card!.x + card!.width <= side!.x, "the name flows behind the panel");
  const wide = await page.evaluate(() => document.querySelector("h1")!.scrollWidth);
  assert.ok(wide <= card!.width, `${wide}`);
  assert.equal(await page.getAttribute(".names", "title"), `${long}1.obj → ${long}2.obj`);
  await page.keyboard.press("Space");
  assert.equal(await page.getAttribute("#play", "aria-label"), "Pause");
  await picture(page, "long-names");
  assert.deepEqual(faults, []);
});

// Bug: bodies are called by numbers, which are cut, and no filter takes their names.
void test("names of objects are listed, filtered by, and shown in full", async () => {
  const names = ["/World/Robot/Arm/Link_07_left", "/World/Table/Plate"];
  const bodies = {
    meshes: {
      plate: {
        points: [
          [-1, -1, 0],
          [2, -1, 0],
          [-1, 2, 0],
        ],
        faces: [[0, 1, 2]],
      },
      tip: { points: [[0.25, 0.25, 0]], loose_points: [0] },
    },
    bodies: [
      { name: names[1], mesh: "plate" },
      { name: names[0], mesh: "tip", poses: [{ position: [0, 0, 1] }, { position: [0, 0, -1] }] },
    ],
  };
  folder.write("named.json", JSON.stringify(bodies));
  folder.run("bodies named.json --out bodies.html", 1);
  const { page, faults } = await open(browser, folder.file("bodies.html"));
  assert.deepEqual(await page.locator(".row .objects bdi").allTextContents(), names);
  await page.fill("#object", "link_07");
  assert.equal(await page.getAttribute("#listed", "data-count"), "1");
  await page.fill("#object", "chair");
  assert.equal(await page.getAttribute("#listed", "data-count"), "0");
  await page.fill("#object", "");
  await page.click(".row");
  assert.ok((await page.textContent("#pair dl"))?.includes(names.join(", ")));
  await picture(page, "named-objects");
  assert.deepEqual(faults, []);
});
