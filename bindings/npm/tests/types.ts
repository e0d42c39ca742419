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
