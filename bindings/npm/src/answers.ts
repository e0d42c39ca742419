import type { Memory } from "./memory.js";

/** A vertex and a face, two edges, a vertex and an edge, or two vertices. */
export type Kind = "vertex-face" | "edge-edge" | "vertex-edge" | "vertex-vertex";
const KINDS: readonly Kind[] = ["vertex-face", "edge-edge", "vertex-edge", "vertex-vertex"];

/** One pair of features that touches during the step. Arrays are views: copy what is to outlive the next question. */
export interface Contact {
  kind: Kind;
  /** Of the first feature, then of the second. */
  vertices: Int32Array;
  /** A fraction of the step: the pair is apart before. Proven. */
  toiLower: number;
  /** It touches at this time or before. */
  toiUpper: number;
  /** Weights. Vertex-face: point = (1-u-v) f0 + u f1 + v f2; edge-edge: u on the first edge, v on the second. */
  u: number;
  v: number;
  /** Unit vector. To part the features, move the first one along it, or the second one against it. */
  normal: Float64Array;
}

/** Two features that are near each other at the step's start. */
export interface NearPair {
  kind: Kind;
  vertices: Int32Array;
  distance: number;
  u: number;
  v: number;
  /** Unit vector from the second feature's closest point to the first's. */
  direction: Float64Array;
}

/** An edge that passes through a triangle, or touches it, at the step's start. */
export interface Intersection {
  edge: Int32Array;
  face: Int32Array;
  /** Bounds of the first common point's parameter, from edge[0] on. */
  sLower: number;
  sUpper: number;
  /** That point is (1-u-v) f0 + u f1 + v f2. */
  u: number;
  v: number;
}

/** The rows of an answer, in the module's memory: nothing is copied. The next question with the detector ends them. */
export class Rows<Row> implements Iterable<Row> {
  constructor(
    /** How many rows there are. */
    readonly length: number,
    private readonly get: (i: number) => Row,
  ) {}

  /** Row i, 0 <= i < length. */
  at(i: number): Row {
    if (!Number.isInteger(i) || i < 0 || i >= this.length) throw new RangeError(`there is no row ${i}: the answer has ${this.length}`);
    return this.get(i);
  }

  *[Symbol.iterator](): Iterator<Row> {
    for (let i = 0; i < this.length; ++i) yield this.get(i);
  }

  /** All rows, as an array. */
  toArray(): Row[] {
    return [...this];
  }
}

/** Of a contact, a near pair, an intersection: how many bytes it has, and how it is read. */
export interface Layout<Row> {
  bytes: number;
  read(memory: Memory, place: number): Row;
}

/** Entries that a kind does not use are -1. */
const used = (vertices: Int32Array) => vertices.subarray(0, vertices.indexOf(-1) < 0 ? 4 : vertices.indexOf(-1));

export const contact: Layout<Contact> = {
  bytes: 88,
  read(memory, place) {
    const [kind, , ...vertices] = memory.viewOfIntegers(place, 6);
    const numbers = memory.viewOfDoubles(place + 24, 7);
    return {
      kind: KINDS[kind], vertices: used(memory.viewOfIntegers(place + 8, vertices.length)), toiLower: numbers[0], toiUpper: numbers[1],
      u: numbers[2], v: numbers[3], normal: numbers.subarray(4),
    };
  },
};

export const nearPair: Layout<NearPair> = {
  bytes: 80,
  read(memory, place) {
    const numbers = memory.viewOfDoubles(place + 24, 6);
    return {
      kind: KINDS[memory.viewOfIntegers(place, 1)[0]], vertices: used(memory.viewOfIntegers(place + 4, 4)), distance: numbers[0],
      u: numbers[1], v: numbers[2], direction: numbers.subarray(3),
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
