// The page of one step: it shows the command's answer, and each control does what it says.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import type { ViewState } from "../src/store";
import { roundedDown } from "../src/numbers";
import { launch, open, picture, settled } from "./browser";
import { Folder, obj, sheet, type Row } from "./command";

const folder = new Folder();
let browser: Browser;
let rows: Row[];

before(async () => {
  // A wavy sheet falls through another; both are crumpled, so that contacts have different times.
  const write = (name: string, height: number): void => {
    const low = sheet(14, 0, 0.08, 0);
    const high = sheet(11, height, -0.11, low.vertices.length);
    folder.write(name, obj([...low.vertices, ...high.vertices], `${low.faces}\n${high.faces}`));
  };
  write("above.obj", 0.35);
  write("below.obj", -0.3);
  rows = folder.contacts("above.obj below.obj");
  folder.run("view above.obj below.obj --out step.html");
  browser = await launch();
});

after(() => {
  folder.remove();
});

const openStep = (hash = ""): ReturnType<typeof open> => open(browser, folder.file("step.html"), hash);

const state = (page: Page): Promise<ViewState> => page.evaluate(() => window.tamis!.session.store.now);

/** The selected pair as the page names it. */
const selectedVertices = (page: Page): Promise<number[]> =>
  page.evaluate(() => [...window.tamis!.session.pair!.first, ...window.tamis!.session.pair!.second]);

const key = (row: Pick<Row, "kind" | "vertices" | "toiLower" | "toiUpper">): string =>
  [row.kind, ...row.vertices, row.toiLower, row.toiUpper].join(" ");

// Bug: the page decodes a column wrongly, and shows other contacts than the command found.
void test("holds every contact with the doubles of the table", async () => {
  const { page, faults } = await openStep();
  const shown = await page.evaluate(() => {
    const { contacts } = window.tamis!.session.scene;
    return Array.from({ length: contacts.count }, (_, i) => ({
      kind: contacts.kindOf(i).name,
      vertices: [...contacts.firstFeature(i), ...contacts.secondFeature(i)],
      toiLower: contacts.toiLower[i],
      toiUpper: contacts.toiUpper[i],
      weights: contacts.storedWeights(i),
    }));
  });
  assert.deepEqual(shown.map(key), rows.map(key));
  for (const [i, row] of rows.entries()) {
    assert.ok(Math.abs(shown[i].weights[0] - row.u) < 1e-5);
    assert.ok(Math.abs(shown[i].weights[1] - row.v) < 1e-5);
  }
  assert.deepEqual(faults, []);
});

// Bug: the counts of the page and of the command differ.
void test("shows the counts of --json, and asks nothing of any server", async () => {
  const json = JSON.parse(folder.run("contacts above.obj below.obj --json")) as {
    contacts: Record<string, number>;
    toi_lower: number;
    stages: { name: string; vf: number; ee: number }[];
  };
  const { page, faults } = await openStep();
  const total = json.contacts.vf + json.contacts.ee;
  assert.equal(await page.getAttribute("#count", "data-count"), String(total));
  assert.equal(await page.getAttribute("#listed", "data-count"), String(total));
  assert.ok((await page.textContent("#answer"))?.includes(roundedDown(json.toi_lower, 6)));
  await page.keyboard.press("v");
  for (const stage of json.stages)
    assert.equal(await page.getAttribute(`[data-stage=${stage.name}]`, "data-pairs"), String(stage.vf + stage.ee));
  await picture(page, "step-sieve");
  assert.deepEqual(faults, []);
});

// Bug: the saved picture is empty, as WebGL has dropped what it drew, or has another size than the drawing.
void test("saves the drawing as a picture", async () => {
  const { page, faults } = await openStep();
  await settled(page);
  const saved = page.waitForEvent("download");
  await page.keyboard.press("k");
  const download = await saved;
  assert.equal(download.suggestedFilename(), "above.obj.png");
  const bytes = readFileSync(await download.path());
  const size = await page.evaluate(() => {
    const { width, height } = document.getElementById("scene-canvas") as HTMLCanvasElement;
    return [width, height];
  });
  assert.deepEqual([bytes.readUInt32BE(16), bytes.readUInt32BE(20)], size);
  const colours = await page.evaluate(async (data) => {
    const png = Uint8Array.from(atob(data), (c) => c.charCodeAt(0));
    const image = await createImageBitmap(new Blob([png]));
    const drawing = new OffscreenCanvas(image.width, image.height).getContext("2d")!;
    drawing.drawImage(image, 0, 0);
    return new Set(new Uint32Array(drawing.getImageData(0, 0, image.width, image.height).data.buffer)).size;
  }, bytes.toString("base64"));
  assert.ok(colours > 100, `${colours} colours`);
  assert.deepEqual(faults, []);
});

// Bug: the slider moves, but the mesh does not, or contacts do not light up.
void test("the slider moves the scene through the step", async () => {
  const { page } = await openStep();
  const canvas = page.locator("#scene-canvas");
  const at = async (time: number): Promise<Buffer> => {
    await page.locator("#time").fill(String(time));
    await settled(page);
    return canvas.screenshot();
  };
  const [start, middle, end] = [await at(0), await at(0.5), await at(1)];
  assert.equal((await state(page)).time, 1);
  assert.equal(await page.textContent("#readout"), "t = 1.0000");
  assert.ok(!start.equals(middle) && !middle.equals(end) && !start.equals(end));
});

// Bug: play does not advance, or runs past the end.
void test("plays through the step and begins again", async () => {
  const { page } = await openStep();
  await page.locator("#time").fill("0.98");
  await page.keyboard.press("Space");
  await page.waitForFunction(() => window.tamis!.session.store.now.time < 0.5, null, { timeout: 10000 });
  const { time, playing } = await state(page);
  assert.ok(playing && time >= 0);
  await page.keyboard.press("Space");
  assert.equal((await state(page)).playing, false);
});

// Bug: the brush chooses other contacts than those between its ends.
void test("the brush keeps the contacts between two times", async () => {
  const { page } = await openStep();
  const box = (await page.locator(".histogram").boundingBox())!;
  const y = box.y + box.height / 2;
  await page.mouse.move(box.x + 0.3 * box.width, y);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.45 * box.width, y);
  await page.mouse.move(box.x + 0.6 * box.width, y);
  await page.mouse.up();
  const [low, high] = (await state(page)).brush;
  assert.ok(Math.abs(low - 0.3) < 0.01 && Math.abs(high - 0.6) < 0.01);
  const kept = rows.filter(({ toiLower }) => toiLower >= low && toiLower <= high);
  assert.ok(kept.length > 0 && kept.length < rows.length);
  assert.equal(await page.getAttribute("#listed", "data-count"), String(kept.length));
  await picture(page, "step-brush");
});

// Bug: a filter forgets one of the four vertices, or a kind.
void test("filters by vertex, kind and object, and sorts", async () => {
  const { page } = await openStep();
  const listed = async (): Promise<number> => Number(await page.getAttribute("#listed", "data-count"));
  const vertex = rows[Math.floor(rows.length / 2)].vertices[2];
  await page.fill("#vertex", String(vertex));
  assert.equal(await listed(), rows.filter(({ vertices }) => vertices.includes(vertex)).length);
  await page.fill("#vertex", "");
  await page.selectOption("#kind", { label: "vertex-face" });
  assert.equal(await listed(), rows.filter(({ kind }) => kind === "vf").length);
  await page.selectOption("#kind", { label: "all kinds" });
  await page.fill("#object", "1");
  const ofSheet = 15 * 15;
  assert.equal(await listed(), rows.filter(({ vertices }) => vertices.some((v) => v >= ofSheet)).length);
  await page.fill("#object", "");
  await page.click(".head button >> nth=0");
  const last = rows.reduce((a, b) => (b.toiLower > a.toiLower ? b : a));
  assert.ok((await page.textContent(".row >> nth=0"))?.startsWith(last.toiLower.toFixed(5)));
});

// Bug: a click in the scene selects a neighbour, or nothing.
void test("a click on a contact in the scene selects that pair", async () => {
  const { page } = await openStep();
  const spot = await page.evaluate(() => {
    const { session, stage } = window.tamis!;
    // The page begins at the end of the step.
    const { end } = session.view.marks;
    const seen = [...session.rows].map((i) => {
      const k = 3 * (i - session.view.step.first);
      return { i, ...stage!.project([end[k], end[k + 1], end[k + 2]])! };
    });
    const lonely = seen.find((a) => seen.every((b) => a === b || Math.hypot(a.x - b.x, a.y - b.y) > 5));
    return lonely ?? null;
  });
  assert.ok(spot, "no contact stands alone");
  const box = (await page.locator("#scene-canvas").boundingBox())!;
  await page.mouse.click(box.x + spot.x, box.y + spot.y);
  assert.equal((await state(page)).selected, spot.i);
  assert.deepEqual(await selectedVertices(page), rows[spot.i].vertices);
});

// Bug: the pair's panel rounds the bracket, or shows another pair's.
void test("a click in the list selects the pair and shows its bracket in full", async () => {
  const { page } = await openStep();
  await page.click(".row >> nth=3");
  const { selected, isolated, time } = await state(page);
  assert.ok(isolated);
  assert.equal(time, rows[selected].toiUpper);
  assert.deepEqual(await selectedVertices(page), rows[selected].vertices);
  const facts = await page.textContent("#pair dl");
  assert.ok(facts?.includes(String(rows[selected].toiLower)) && facts.includes(String(rows[selected].toiUpper)));
  await page.click("#before");
  assert.ok((await state(page)).time < rows[selected].toiLower);
  await page.click("#after");
  assert.ok((await state(page)).time > rows[selected].toiUpper);
  await settled(page);
  await picture(page, "step-pair");
});

// Bug: "first contact" shows a contact that is not the first.
void test("first contact and what stops the step in one click each", async () => {
  const { page } = await openStep();
  const earlier = (a: Row, b: Row): Row => (b.toiLower < a.toiLower ? b : a);
  const first = rows.filter(({ status }) => status === "certified").reduce(earlier);
  const limiting = rows.reduce(earlier);
  await page.click("#first");
  assert.deepEqual(await selectedVertices(page), first.vertices);
  assert.equal((await state(page)).time, first.toiUpper);
  await settled(page);
  await picture(page, "step-first");
  await page.keyboard.press("Escape");
  assert.equal((await state(page)).selected, -1);
  await page.click("#stops");
  assert.deepEqual(await selectedVertices(page), limiting.vertices);
  assert.equal((await state(page)).time, limiting.toiLower);
  assert.ok((await page.textContent("#toast"))?.includes(String(limiting.toiLower)));
});

// Bug: a link shows another view than its sender's.
void test("the hash restores time, selection, filter and camera", async () => {
  const { page } = await openStep();
  await page.click(".row >> nth=5");
  await page.keyboard.press("e");
  await page.keyboard.press("Shift+ArrowLeft");
  await page.keyboard.press("1");
  await page.waitForTimeout(400);
  await page.waitForFunction(
    () => new URLSearchParams(location.hash.slice(1)).get("t") === String(window.tamis!.session.store.now.time),
  );
  const hash = await page.evaluate(() => location.hash);
  const sent = await state(page);
  const eye = (): Promise<number[]> => page.evaluate(() => window.tamis!.stage!.camera.camera.position.toArray());
  const a = await eye();
  await openStep(hash);
  const got = await state(page);
  for (const name of ["selected", "isolated", "time", "edges", "panel", "brush"] as const)
    assert.deepEqual(got[name], sent[name], name);
  const b = await eye();
  a.forEach((x, i) => {
    assert.ok(Math.abs(x - b[i]) < 1e-4, `eye ${a.join(" ")} against ${b.join(" ")}`);
  });
  // A hash that no page wrote must do no harm.
  const { faults } = await openStep("#t=x&selected=99999999&eye=1,2&brush=3,1&panel=no&step=-4");
  assert.equal((await state(page)).selected, -1);
  assert.deepEqual(faults, []);
});

// Bug: a key that the list names does nothing.
void test("every key of the list is taken, and ? shows them", async () => {
  const { page, faults } = await openStep();
  await page.keyboard.press("?");
  const names = await page.locator("#help kbd").allTextContents();
  assert.ok(names.length > 25);
  await picture(page, "step-keys");
  await page.keyboard.press("Escape");
  for (const pressed of ["e", "n", "p", "m", "g", "x", "t", "z"]) {
    const old = JSON.stringify(await state(page));
    await page.keyboard.press(pressed);
    assert.notEqual(JSON.stringify(await state(page)), old, pressed);
    await settled(page);
  }
  await picture(page, "step-everything");
  await page.keyboard.press("ArrowDown");
  const first = await state(page);
  await page.keyboard.press("ArrowDown");
  assert.notEqual((await state(page)).selected, first.selected);
  assert.deepEqual(faults, []);
});

// Bug: on a phone the panels hide the scene or each other; a theme has text in the colour of its background.
for (const colorScheme of ["light", "dark"] as const)
  void test(`fits a phone and follows the system's theme: ${colorScheme}`, async () => {
    const phone = { viewport: { width: 390, height: 844 }, colorScheme, hasTouch: true };
    const { page, faults } = await open(browser, folder.file("step.html"), "", phone);
    assert.equal((await state(page)).theme, colorScheme);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= 390, `the page is ${wide} pixels wide`);
    const scene = (await page.locator("#scene-canvas").boundingBox())!;
    assert.ok(scene.height > 400);
    await picture(page, `phone-${colorScheme}`);
    await page.tap("#first");
    await settled(page);
    await picture(page, `phone-${colorScheme}-first`);
    await page.tap("[data-tab=pair]");
    await page.tap("[data-tab=pair]");
    await settled(page);
    await picture(page, `phone-${colorScheme}-pair`);
    assert.deepEqual(faults, []);
    await page.close();
  });
