import { load } from "tamis";

const tamis = await load();
// two triangles; the second one's corner 3 falls
const detector = tamis.detector({ faces: [0, 1, 2, 3, 4, 5] });
const start = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, 1, 1, 0.5, 2, 0.5, 1, 2];
const end = start.map((x, i) => (i === 11 ? -1 : x));
for (const { vertices, toiLower, toiUpper } of detector.contacts(start, end))
  console.log(`vertex ${vertices[0]} meets the face in [${toiLower.toFixed(6)}, ${toiUpper.toFixed(6)}]`);
detector.free();
