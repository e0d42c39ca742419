import { load } from "tamis";

const tamis = await load();
// a wall at x = 0, and a blade that turns about z from one side to the other: both ends alone tell nothing
const rest = [0, 1, -1, 0, 3, -1, 0, 2, 2, 1.9, -0.1, -2, 2.1, 0.1, -2, 2, 0, 0.5];
const turn = tamis.turnedChain([0, 0, 0, 0, 0, 0], [0, 0, Math.PI], [0, 0, 0]);
const path = tamis.rigidPath({ rest, bodyOfVertex: [0, 0, 0, 1, 1, 1], chains: [[], turn] });
const detector = tamis.detector({ faces: [0, 1, 2, 3, 4, 5] });
console.log(`straight: ${detector.isFree(rest, path.pointsAt(1)) ? "free" : "not free"}`);
const { toiLower, contact } = detector.earliest(path);
console.log(`on its curve: ${contact.kind} at ${toiLower.toFixed(6)}`);
for (const each of [path, detector]) each.free();
