// node example.js [TAMIS_JS]: the example of docs/c.md from JavaScript. Pointers are numbers: places in the module's memory.
const createTamis = require(process.argv[2] ?? './tamis.js');

createTamis().then(tamis => {
  // Arrays and structs in the module's memory. Sizes, counts and pointers of a struct have four bytes each.
  const put = (numbers, heap, bytes) => {
    const at = tamis._malloc(bytes * numbers.length);
    tamis[heap].set(numbers, at / bytes);
    return at;
  };
  const words = numbers => put(numbers, 'HEAPU32', 4), doubles = numbers => put(numbers, 'HEAPF64', 8);
  const word_at = at => tamis.HEAPU32[at / 4];
  const check = (status, message) => {
    if (status !== 0) throw new Error(tamis.UTF8ToString(message));
  };

  // Two triangles; the second one's corner 3 falls.
  const start = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, 1, 1, 0.5, 2, 0.5, 1, 2];
  const end = start.map((x, i) => i === 11 ? -1 : x);
  const input = words([32, 6, words([0, 1, 2, 3, 4, 5]), 2, 0, 0, 0, 0]);  // tamis_mesh_input
  const step = words([32, 6, doubles(start), doubles(end), 0, 0, 0, 0]);   // tamis_step
  const made = words([0]), count = words([0]), contact = words(new Array(22).fill(0));

  let status = tamis._tamis_mesh_create(input, made);
  const mesh = word_at(made);
  check(status, tamis._tamis_mesh_message(mesh));
  status = tamis._tamis_detector_create(mesh, 0, made);
  const detector = word_at(made);
  check(status, tamis._tamis_detector_message(detector));
  check(tamis._tamis_detector_contacts(detector, step, count), tamis._tamis_detector_message(detector));
  for (let i = 0; i < word_at(count); ++i) {
    tamis._tamis_detector_copy_contacts(detector, i, 1, contact, 88);
    const vertex = tamis.HEAP32[contact / 4 + 2], [lower, upper] = tamis.HEAPF64.subarray(contact / 8 + 3);
    console.log(`vertex ${vertex} meets the face in [${lower.toFixed(6)}, ${upper.toFixed(6)}]`);
  }
  tamis._tamis_detector_free(detector);
  tamis._tamis_mesh_free(mesh);
});
