// A viewer in a frame shows the scenes that the page around it sends.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { inflateSync } from "node:zlib";
import type { Browser, Frame, Page } from "playwright-core";
import type { FromViewer } from "../src/messages";
import { launch, picture } from "./browser";
import { Folder, obj, sheet } from "./command";

const folder = new Folder();
const viewer = join(process.cwd(), "dist", "viewer.html");
let browser: Browser;
let page: Page;
let frame: Frame;

/** The bytes of a scene, as a WebAssembly module would give them, in base64. */
function sceneOf(drop: number): string {
  const low = sheet(8, 0, 0.08, 0);
  const at = (height: number): string => {
    const high = sheet(6, height, -0.1, low.vertices.length);
    return obj([...low.vertices, ...high.vertices], `${low.faces}\n${high.faces}`);
  };
  folder.write("start.obj", at(0.4));
  folder.write("end.obj", at(0.4 - drop));
  folder.run("view start.obj end.obj --out scene.html");
  const [, text] = /id="scene">([^<]*)</.exec(readFileSync(folder.file("scene.html"), "utf8"))!;
  return inflateSync(Buffer.from(text, "base64")).toString("base64");
}

/** What the viewer has said since the last call, once it has said something of this kind. */
async function heard(kind: FromViewer["tamis"]): Promise<FromViewer[]> {
  interface Told {
    told: FromViewer[];
  }
  await page.waitForFunction((each) => (window as unknown as Told).told.some(({ tamis }) => tamis === each), kind);
  return page.evaluate(() => (window as unknown as Told).told.splice(0));
}

const send = (base64: string, keep: boolean): Promise<void> =>
  page.evaluate(
    ([text, kept]) => {
      const { buffer: bytes } = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
      window.frames[0].postMessage({ tamis: "scene", bytes, keep: kept }, "*", [bytes]);
    },
    [base64, keep] as const,
  );

const eye = (): Promise<number[]> =>
  frame.evaluate(() => window.tamis!.stage!.camera.viewpoint.eye.toArray().map((x) => Number(x.toPrecision(4))));

before(async () => {
  browser = await launch();
  page = await browser.newPage({ viewport: { width: 900, height: 600 }, reducedMotion: "reduce" });
  folder.write(
    "around.html",
    `<script>window.told = []; onmessage = ({ data }) => told.push(data);</script>
     <iframe src="file://${viewer}" style="width: 860px; height: 560px"></iframe>`,
  );
  await page.goto(`file://${folder.file("around.html")}`);
  assert.deepEqual(await heard("ready"), [{ tamis: "ready" }]);
  frame = page.frames()[1];
});

after(() => {
  folder.remove();
});

// Bug: the second scene shows the contacts of the first one, moves the camera, or keeps the first one's keys.
void test("shows a scene, then another one from the same place", async () => {
  await send(sceneOf(0.5), false);
  const [shown] = await heard("shown");
  const contacts = Number(await frame.getAttribute("#count", "data-count"));
  assert.deepEqual(shown, { tamis: "shown", contacts });
  await frame.locator("body").press("Shift+ArrowLeft");
  await frame.locator("body").press("e");
  const seenFrom = await eye();
  await send(sceneOf(0.9), true);
  await heard("shown");
  assert.ok(Number(await frame.getAttribute("#count", "data-count")) > contacts);
  assert.deepEqual(await eye(), seenFrom);
  await frame.locator("body").press("e");
  assert.equal(await frame.evaluate(() => window.tamis!.session.store.now.edges), false);
  await picture(page, "framed");
});

// Bug: bytes that are no scene leave an empty frame.
void test("says that bytes are no scene, and keeps the scene before", async () => {
  await send(Buffer.from("no scene at all").toString("base64"), true);
  const [failed] = await heard("failed");
  assert.ok(failed.tamis === "failed" && failed.words.length > 0);
  assert.ok(await frame.locator("#scene-canvas").isVisible());
  assert.equal(await frame.locator("#opening").isVisible(), false);
});

void test("says what the page around it does, and wears its theme", async () => {
  const tell = (message: object): Promise<void> =>
    page.evaluate((told) => {
      window.frames[0].postMessage(told, "*");
    }, message);
  await tell({ tamis: "says", words: "Looking for contacts", part: 0.3 });
  await frame.getByText("Looking for contacts").waitFor();
  assert.equal(await frame.locator("#opening progress").getAttribute("value"), "0.3");
  await tell({ tamis: "says", words: "" });
  await frame.getByText("Looking for contacts").waitFor({ state: "hidden" });
  await tell({ tamis: "theme", theme: "light" });
  await frame.locator(":root[data-theme=light]").waitFor({ state: "attached" });
  assert.equal(await frame.evaluate(() => window.tamis!.session.store.now.theme), "light");
});

// Bug: a file dropped on the scene is opened by the browser in its place.
void test("gives dropped files to the page around it", async () => {
  await frame.evaluate(() => {
    const dataTransfer = new DataTransfer();
    for (const name of ["start.ply", "end.ply"]) dataTransfer.items.add(new File(["ply"], name));
    for (const kind of ["dragover", "drop"])
      document.body.dispatchEvent(new DragEvent(kind, { bubbles: true, cancelable: true, dataTransfer }));
  });
  await page.waitForFunction(() => (window as unknown as { told: FromViewer[] }).told.length > 0);
  const names = await page.evaluate(() => {
    const [message] = (window as unknown as { told: FromViewer[] }).told;
    return message.tamis === "files" ? message.files.map(({ name }) => name) : [];
  });
  assert.deepEqual(names, ["start.ply", "end.ply"]);
});
