// From where a page shows a step at first.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import { launch, open, picture } from "./browser";
import { Folder, obj, sheet } from "./command";

const folder = new Folder();
let browser: Browser;

before(async () => {
  browser = await launch();
});

after(() => {
  folder.remove();
});

/** Opens a step of two objects, whose second falls by `fall` in y; returns the direction to the eye. */
async function eyeOf(name: string, first: number[][], second: number[][], rest: string, fall: number) {
  folder.write("start.obj", obj([...first, ...second], rest));
  folder.write("end.obj", obj([...first, ...second.map(([x, y, z]) => [x, y - fall, z])], rest));
  folder.run(`view start.obj end.obj --out ${name}.html`);
  const { page, faults } = await open(browser, folder.file(`${name}.html`));
  await picture(page, name);
  assert.deepEqual(faults, []);
  return page.evaluate(() => {
    const { eye, target } = window.tamis!.stage!.camera.viewpoint;
    return eye.sub(target).normalize().toArray();
  });
}

/** A small tetrahedron that stands on y = 0, with its tip at `height`. */
const tetrahedron = (height: number): number[][] => [
  [0.45, 0, 0.45],
  [0.55, 0, 0.45],
  [0.5, 0, 0.55],
  [0.5, height, 0.5],
];
const flat = sheet(10, 0, 0, 4);
const plate = (y: number): number[][] => flat.vertices.map(([x, z]) => [x, y, z]);
const kTetrahedron = "f 1 2 3\nf 1 2 4\nf 2 3 4\nf 3 1 4";

// Bug: a plate that falls on something hides it.
void test("what touches below a plate is seen from the side", async () => {
  const [, height] = await eyeOf("under-plate", tetrahedron(0.4), plate(0.45), `${kTetrahedron}\n${flat.faces}`, 0.2);
  assert.ok(height < 0.2, `the eye is ${height} above the plate`);
});

// Bug: the camera stands elsewhere though nothing hides what touches.
void test("what touches on top of a plate is seen from above and the side, as usual", async () => {
  const upside = tetrahedron(0.4).map(([x, y, z]) => [x, 0.4 - y, z]);
  const fallen = upside.map(([x, y, z]) => [x, y - 0.55, z]);
  const [x, y, z] = await eyeOf("on-plate", fallen, plate(-0.7), `${kTetrahedron}\n${flat.faces}`, -0.3);
  const long = Math.hypot(0.5, 0.42, 0.9);
  for (const [is, usual] of [
    [x, 0.5],
    [y, 0.42],
    [z, 0.9],
  ])
    assert.ok(Math.abs(is - usual / long) < 1e-6, `${x} ${y} ${z}`);
});
