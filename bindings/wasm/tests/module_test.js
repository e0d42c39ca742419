// node module_test.js TAMIS_JS HEADERS: calls the C interface from JavaScript.
const assert = require('node:assert');
const fs = require('node:fs');

const [path, headers] = process.argv.slice(2);
const createTamis = require(path);
const OK = 0, INVALID_MESH = 2, OUT_OF_MEMORY = 7;

const tests = {
  'every function that a header declares can be called': m => {
    const text = fs.readdirSync(headers).map(name => fs.readFileSync(`${headers}/${name}`, 'utf8')).join('');
    const declared = [...text.matchAll(/^TAMIS_API [^(]*\b(tamis_\w+)\(/gm)].map(match => match[1]);
    assert(declared.length > 60);
    for (const name of declared) assert.strictEqual(typeof m['_' + name], 'function', name);
  },
  'a point that falls through a triangle touches it': m => {
    const scene = makeScene(m);
    assert.strictEqual(scene.contacts(-1), OK);
    assert.strictEqual(scene.count(), 1);
    const contact = m._malloc(88);
    assert.strictEqual(m._tamis_detector_copy_contacts(scene.detector, 0, 1, contact, 88), OK);
    assert.deepStrictEqual([...m.HEAP32.subarray(contact / 4, contact / 4 + 6)], [0, 0, 3, 0, 1, 2]);
    const [lower, upper, u, v, ...normal] = m.HEAPF64.subarray(contact / 8 + 3, contact / 8 + 10);
    assert(lower <= 0.5 && 0.5 <= upper && upper - lower < 1e-9, `${lower} ${upper}`);
    assert.deepStrictEqual([u, v], [0.25, 0.25]);
    assert.deepStrictEqual(normal.map(Math.abs), [0, 0, 1]);
    assert.strictEqual(scene.contacts(0.5), OK);
    assert.strictEqual(scene.count(), 0);
  },
  'a filter in JavaScript skips a pair': m => {
    let calls = 0;
    const accepts = m.addFunction(() => { ++calls; return 0; }, 'iiii');
    const scene = makeScene(m, accepts);
    assert.strictEqual(scene.contacts(-1), OK);
    assert.strictEqual(scene.count(), 0);
    assert(calls > 0);
  },
  'a wrong mesh is refused with a sentence': m => {
    const [status, mesh] = makeMesh(m, [0, 1, 7]);
    assert.strictEqual(status, INVALID_MESH);
    assert.match(m.UTF8ToString(m._tamis_mesh_message(mesh)), /7/);
  },
  'a detector without memory says so, and answers once there is some': m => {
    const scene = makeScene(m);
    const grow = WebAssembly.Memory.prototype.grow;
    WebAssembly.Memory.prototype.grow = () => { throw new RangeError('no memory'); };
    const taken = [];
    for (let size = 1 << 20; size >= 8; size /= 2)
      for (let piece; (piece = m._malloc(size)) !== 0;) taken.push(piece);
    assert.strictEqual(scene.contacts(-1), OUT_OF_MEMORY);
    assert.match(m.UTF8ToString(m._tamis_detector_message(scene.detector)), /^(out of memory.*)?$/);
    const [status] = makeMesh(m, [0, 1, 2], scene.room);
    assert.strictEqual(status, OUT_OF_MEMORY);
    taken.forEach(m._free);
    assert.strictEqual(scene.contacts(-1), OK);
    assert.strictEqual(scene.count(), 1);
    WebAssembly.Memory.prototype.grow = grow;
  },
};

/// Counts of 32 bits: as a C struct the numbers of `words`, four bytes each.
function struct(m, words, at = m._malloc(4 * words.length)) {
  m.HEAPU32.set(words, at / 4);
  return at;
}
function doubles(m, numbers) {
  const at = m._malloc(8 * numbers.length);
  m.HEAPF64.set(numbers, at / 8);
  return at;
}

/// A mesh of four vertices: one face, and a loose point. `room` for the arguments, where malloc has none.
function makeMesh(m, face, room = m._malloc(64)) {
  const faces = struct(m, face, room), points = struct(m, [3], room + 12), handle = room + 16;
  const status = m._tamis_mesh_create(struct(m, [32, 4, faces, 1, 0, 0, points, 1], room + 24), handle);
  return [status, m.HEAPU32[handle / 4]];
}

/// A point above a triangle, which goes to some height.
function makeScene(m, accepts = 0) {
  const [, mesh] = makeMesh(m, [0, 1, 2]), handle = m._malloc(4), number = m._malloc(4);
  const size = 64, options = struct(m, new Array(size / 4).fill(0));
  m.HEAPU32[options / 4] = size;
  m.HEAPU32[options / 4 + 9] = accepts;
  assert.strictEqual(m._tamis_detector_create(mesh, options, handle), OK);
  const detector = m.HEAPU32[handle / 4];
  const start = doubles(m, [0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, 1]);
  const end = doubles(m, [0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, 1]);
  const step = struct(m, [32, 4, start, end, 0, 0, 0, 0]);
  return {
    detector,
    room: m._malloc(64),
    contacts(height) {
      m.HEAPF64[end / 8 + 11] = height;
      return m._tamis_detector_contacts(detector, step, number);
    },
    count: () => m.HEAPU32[number / 4],
  };
}

async function refusesOldEngines() {
  const validate = WebAssembly.validate;
  for (const [part, sentence] of [[253, /128-bit SIMD.*newer/], [64, /exceptions.*newer/]]) {
    WebAssembly.validate = code => !code.includes(part) && validate(code);
    await assert.rejects(async () => createTamis(), sentence);
  }
  WebAssembly.validate = validate;
}

async function main() {
  await refusesOldEngines();
  console.log('an engine without SIMD, or without exceptions, is refused with a sentence');
  for (const [name, test] of Object.entries(tests)) {
    test(await createTamis());
    console.log(name);
  }
}
main().catch(error => {
  console.error(error);
  process.exit(1);
});
