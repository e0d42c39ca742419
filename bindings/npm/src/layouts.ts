import { KINDS } from "./answers.js";
import type { Contact, Earliest, EdgeAnswer, Intersection, Layout, NearPair, OfBodies, PairResult, SafeStep, Touch } from "./answers.js";
import type { Memory } from "./memory.js";

/** Entries that a kind does not use are -1. */
const used = (vertices: Int32Array) => vertices.subarray(0, vertices.indexOf(-1) < 0 ? 4 : vertices.indexOf(-1));

/** The numbers that contacts and results end with. */
function touch(memory: Memory, place: number, certainty: number): Touch {
  const [toiLower, toiUpper, u, v] = memory.viewOfDoubles(place, 4);
  return { certified: certainty === 0, toiLower, toiUpper, u, v, normal: memory.viewOfDoubles(place + 32, 3) };
}

export const contact: Layout<Contact> = {
  bytes: 88,
  read(memory, place) {
    const [kind, certainty] = memory.viewOfIntegers(place, 2);
    return { kind: KINDS[kind], vertices: used(memory.viewOfIntegers(place + 8, 4)), ...touch(memory, place + 24, certainty) };
  },
};

export const pairResult: Layout<PairResult> = {
  bytes: 64,
  read(memory, place) {
    const [touches, certainty] = memory.viewOfIntegers(place, 2);
    return { touches: touches !== 0, ...touch(memory, place + 8, touches !== 0 ? certainty : 1) };
  },
};

export const nearPair: Layout<NearPair> = {
  bytes: 80,
  read(memory, place) {
    const [distance, u, v] = memory.viewOfDoubles(place + 24, 3);
    return {
      kind: KINDS[memory.viewOfIntegers(place, 1)[0]], vertices: used(memory.viewOfIntegers(place + 4, 4)), distance, u, v,
      direction: memory.viewOfDoubles(place + 48, 3),
    };
  },
};

export const intersection: Layout<Intersection> = {
  bytes: 64,
  read(memory, place) {
    const [sLower, sUpper, u, v] = memory.viewOfDoubles(place + 24, 4);
    return { edge: memory.viewOfIntegers(place, 2), face: memory.viewOfIntegers(place + 8, 3), sLower, sUpper, u, v };
  },
};

/** The same with the two bodies that all three end with. */
const ofBodies = <Row>({ bytes, read }: Layout<Row>): Layout<Row & OfBodies> => ({
  bytes, read: (memory, place) => ({ ...read(memory, place), bodies: memory.viewOfIntegers(place + bytes - 8, 2) }),
});
export const bodyContact = ofBodies(contact);
export const bodyNearPair = ofBodies(nearPair);
export const bodyIntersection = ofBodies(intersection);

/** A bracket, whether something ends it, and that. */
function ended<Row>(row: Layout<Row>, memory: Memory, place: number): [toiLower: number, toiUpper: number, row: Row | null] {
  const [toiLower, toiUpper] = memory.viewOfDoubles(place, 2);
  return [toiLower, toiUpper, memory.viewOfIntegers(place + 16, 1)[0] !== 0 ? row.read(memory, place + 24) : null];
}

export const earliest: Layout<Earliest<Contact & OfBodies>> = {
  bytes: 112,
  read(memory, place) {
    const [toiLower, toiUpper, contact] = ended(bodyContact, memory, place);
    return { toiLower, toiUpper, contact };
  },
};

export const safeStep = <Pair>(near: Layout<Pair>): Layout<SafeStep<Pair>> => ({
  bytes: 112,
  read(memory, place) {
    const [toiLower, toiUpper, pair] = ended(near, memory, place + 8);
    return { toiLower, toiUpper, pair };
  },
});

export const edgeAnswer: Layout<EdgeAnswer> = {
  bytes: 144,
  read(memory, place) {
    const [fraction, fractionUpper] = memory.viewOfDoubles(place, 2);
    const [overlaps, hasContact] = memory.viewOfIntegers(place + 16, 2);
    const bodies = memory.viewOfIntegers(place + 24, 2);
    return {
      isFree: bodies[0] < 0, fraction, fractionUpper, overlapsAtStart: overlaps !== 0, bodies,
      point: hasContact !== 0 ? memory.viewOfDoubles(place + 32, 3) : null, contact: hasContact !== 0 ? bodyContact.read(memory, place + 56) : null,
    };
  },
};
