// A program that TypeScript accepts: each mark expects the mistake of the line after it.
import { load, TamisError } from "tamis";
import type { Contact, Rows } from "tamis";

const tamis = await load();
using detector = tamis.detector({ faces: new Int32Array([0, 1, 2]) }, { accepts: (kind, vertices) => kind === "edge-edge" || vertices[0] > 0 });
const start = new Float64Array(9);
const contacts: Rows<Contact> = detector.contacts(start, [...start], { atStart: "ignore" });
for (const { toiLower, normal } of contacts) console.log(toiLower + normal[0]);
const { contact } = detector.earliest();
// @ts-expect-error: there may be none
console.log(contact.u);
// @ts-expect-error: a name that no option has
detector.contacts(start, start, { atStart: "never" });
// @ts-expect-error: detectors are made by tamis.detector
new (await import("tamis")).Detector();
console.log(new TamisError("", 1).status, detector.safeStep().pair?.distance);

const shape = tamis.shape({ faces: [0, 1, 2] }, start);
using world = tamis.world({ minSeparation: 1e-3 });
const body: number = world.add(shape, { poses: tamis.poseOf([1, 0, 0, 0], [0, 0, 0]) });
const path = tamis.functionPath({ vertexCount: 3, pointsAt: (time, _vertices, points, errors) => { points.fill(time); errors.fill(0); }, deviations() {} });
detector.contacts(path, { tolerance: 1e-6 });
for (const { bodies, certified } of world.contacts({ tolerance: 1e-6 })) console.log(bodies[0] === body && certified);
const linkage = tamis.linkage({ joints: [{ kind: "turning", axis: [0, 0, 1] }], bodies: [{ body, joint: 0 }] });
const free: Uint8Array = world.edgesAreFree(linkage, [0], [1], { startsAreFree: true });
console.log(free, world.lastValid(linkage, [0], [1]).at(0).point?.[0], tamis.pairs().vertexFace(start, start).at(0).touches);
// @ts-expect-error: a step has no tolerance
detector.contacts(start, start, { tolerance: 1e-6 });
// @ts-expect-error: a name that no motion has
world.add(shape, { pose: [0, 0, 0, 0, 0, 0] });
// @ts-expect-error: a detector's contacts have no bodies
console.log(detector.contacts(start, start).at(0).bodies);
