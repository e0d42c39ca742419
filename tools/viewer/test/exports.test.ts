// Files for other programs: the motion as glTF, contacts for ParaView.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { validateBytes } from "gltf-validator";
import { AnimationMixer, Vector3, type Mesh, type Points } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { Folder, obj, sheet, type Row } from "./command";

const folder = new Folder();
let rows: Row[];
let start: number[][];
let end: number[][];

before(() => {
  const low = sheet(9, 0, 0.08, 0);
  const high = sheet(7, 0.4, -0.11, low.vertices.length);
  // With a rod and a loose point, far from the origin, where floats are coarse.
  const extra = [
    [0.3, 0.3, 0.5],
    [0.6, 0.7, 0.6],
    [0.5, 0.5, 0.9],
  ];
  const first = low.vertices.length + high.vertices.length + 1;
  start = [...low.vertices, ...high.vertices, ...extra].map(([x, y, z]) => [x + 1000, y, z]);
  end = start.map(([x, y, z], v) => (v < low.vertices.length ? [x, y, z] : [x, y, z - 0.8]));
  const rest = `${low.faces}\n${high.faces}\nl ${first} ${first + 1}\np ${first + 2}`;
  folder.write("start.obj", obj(start, rest));
  folder.write("end.obj", obj(end, rest));
  rows = folder.contacts("start.obj end.obj");
});

after(() => {
  folder.remove();
});

interface Gltf {
  nodes: { name: string; translation: number[]; extras?: { columns: string[]; rows: (string | number)[][] } }[];
  meshes: { primitives: { mode: number; attributes: Record<string, number>; targets: Record<string, number>[] }[] }[];
  accessors: { bufferView: number; count: number }[];
  bufferViews: { byteOffset: number; byteLength: number }[];
  animations: { channels: unknown[] }[];
}

function readGlb(name: string): { gltf: Gltf; points: (accessor: number) => Float32Array } {
  const bytes = readFileSync(folder.file(name));
  const length = bytes.readUInt32LE(12);
  const gltf = JSON.parse(bytes.toString("utf8", 20, 20 + length)) as Gltf;
  const points = (accessor: number): Float32Array => {
    const { byteOffset, byteLength } = gltf.bufferViews[gltf.accessors[accessor].bufferView];
    const from = 28 + length + byteOffset;
    return new Float32Array(bytes.buffer.slice(bytes.byteOffset + from, bytes.byteOffset + from + byteLength));
  };
  return { gltf, points };
}

// Bug: a viewer refuses the file, or reads something else.
void test("glTF is what the Khronos validator accepts", async () => {
  for (const verb of ["view", "contacts"]) {
    folder.run(`${verb} start.obj end.obj --out step.glb`);
    const report = await validateBytes(new Uint8Array(readFileSync(folder.file("step.glb"))));
    assert.deepEqual(report.issues.messages, []);
    assert.equal(report.info.animationCount, 1);
    assert.equal(report.info.hasMorphTargets, true);
  }
});

// Bug: the morph target is not the motion of the question, or contacts have other places.
void test("glTF moves every vertex from the start to the end, and holds every contact", () => {
  folder.run("view start.obj end.obj --out step.glb");
  const { gltf, points } = readGlb("step.glb");
  assert.deepEqual(
    gltf.meshes[0].primitives.map(({ mode }) => mode),
    [4, 1, 0],
  );
  const { attributes, targets } = gltf.meshes[0].primitives[0];
  const [from, way] = [points(attributes.POSITION), points(targets[0].POSITION)];
  const { translation } = gltf.nodes[0];
  start.forEach((place, v) => {
    for (let axis = 0; axis < 3; ++axis) {
      const x = from[3 * v + axis] + translation[axis];
      assert.ok(Math.abs(x - place[axis]) < 1e-6);
      assert.ok(Math.abs(x + way[3 * v + axis] - end[v][axis]) < 1e-6);
    }
  });
  const { columns, rows: found } = gltf.nodes[1].extras!;
  const held = found.map((row) => Object.fromEntries(columns.map((column, i) => [column, row[i]])));
  assert.deepEqual(
    held.map(({ kind, v0, v1, v2, v3, toi_lower, toi_upper }) => [kind, v0, v1, v2, v3, toi_lower, toi_upper]),
    rows.map(({ kind, vertices, toiLower, toiUpper }) => [kind, ...vertices, toiLower, toiUpper]),
  );
});

// Bug: a valid file that shows nothing: no animation moves it, or it has extras that readers drop.
void test("three.js loads the glTF, and its animation plays the motion", async () => {
  folder.run("view start.obj end.obj --out step.glb");
  const bytes = readFileSync(folder.file("step.glb"));
  const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  const loaded = await new GLTFLoader().parseAsync(buffer, "");
  const surface = loaded.scene.getObjectByName("mesh")!.getObjectByProperty("type", "Mesh") as Mesh;
  const contacts = loaded.scene.getObjectByName("contacts")!;
  assert.equal((contacts.userData.rows as unknown[]).length, rows.length);
  assert.deepEqual((contacts.getObjectByProperty("type", "Points") as Points).morphTargetInfluences, [0]);

  const mixer = new AnimationMixer(loaded.scene);
  mixer.clipAction(loaded.animations[0]).play();
  loaded.scene.updateMatrixWorld(true);
  for (const time of [0, 0.25, 0.5]) {
    mixer.setTime(time);
    start.forEach((place, v) => {
      if (v >= surface.geometry.getAttribute("position").count) return;
      const shown = surface.localToWorld(surface.getVertexPosition(v, new Vector3())).toArray();
      shown.forEach((x, axis) => {
        assert.ok(Math.abs(x - (1 - time) * place[axis] - time * end[v][axis]) < 1e-4);
      });
    });
  }
});

const numbersOf = (xml: string, name: string): number[] => {
  const text = new RegExp(`Name="${name}"[^>]*>([^<]*)<`).exec(xml)?.[1];
  assert.ok(text !== undefined, `no array ${name}`);
  return text.trim().split(/\s+/).map(Number);
};

// Bug: an array has another order than the points, or digits are lost.
void test("vtp and vtu hold the contacts' numbers, and points on their features", () => {
  for (const name of ["contacts.vtp", "contacts.vtu"]) {
    folder.run(`contacts start.obj end.obj --out ${name}`);
    const xml = readFileSync(folder.file(name), "utf8");
    assert.deepEqual(
      numbersOf(xml, "toi_lower"),
      rows.map(({ toiLower }) => toiLower),
    );
    assert.deepEqual(
      numbersOf(xml, "toi_upper"),
      rows.map(({ toiUpper }) => toiUpper),
    );
    assert.deepEqual(
      numbersOf(xml, "vertices"),
      rows.flatMap(({ vertices }) => vertices),
    );
    assert.equal(numbersOf(xml, "offsets").length, rows.length);
    const points = numbersOf(xml, "points");
    rows.forEach(({ kind, vertices: [v], toiUpper: t }, i) => {
      if (kind !== "vf") return;
      for (let axis = 0; axis < 3; ++axis)
        assert.ok(Math.abs(points[3 * i + axis] - ((1 - t) * start[v][axis] + t * end[v][axis])) < 1e-9);
    });
  }
});
