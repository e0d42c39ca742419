import type { Memory } from "./memory.js";

/** A vertex and a face, two edges, a vertex and an edge, or two vertices. */
export type Kind = "vertex-face" | "edge-edge" | "vertex-edge" | "vertex-vertex";
export const KINDS: readonly Kind[] = ["vertex-face", "edge-edge", "vertex-edge", "vertex-vertex"];
/** How many vertices a pair of each kind has. */
export const VERTICES = [4, 4, 3, 2];

/** When and where a pair touches. Arrays are views: copy a row that must outlive the next question. */
export interface Touch {
  /** False, only on curves: arithmetic could not decide, so the pair is kept. */
  certified: boolean;
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

/** One pair of features that touches during the step. */
export interface Contact extends Touch {
  kind: Kind;
  /** Of the first feature, then of the second. */
  vertices: Int32Array;
}

/** Whether a listed pair touches. If it does not, the rest has no meaning. */
export interface PairResult extends Touch {
  /** False: proven free. */
  touches: boolean;
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

/** In a world: the body of the first feature, then of the second. Vertices are numbered in the bodies' own meshes. */
export interface OfBodies {
  bodies: Int32Array;
}

/** The first contact. The motion is free before `toiLower`: proven. Without a contact both times are 1. */
export interface Earliest<Contact> {
  toiLower: number;
  toiUpper: number;
  contact: Contact | null;
}

/** How far all may go: every pair keeps its fraction until `toiLower`. The pair ends it; null: the whole step may go. */
export interface SafeStep<Pair> {
  toiLower: number;
  toiUpper: number;
  pair: Pair | null;
}

/** How far an edge between configurations is free. */
export interface EdgeAnswer {
  isFree: boolean;
  /** The edge is free before this fraction: proven. 0 if its start overlaps. */
  fraction: number;
  fractionUpper: number;
  overlapsAtStart: boolean;
  /** Which touch or overlap first; -1 if the edge is free. */
  bodies: Int32Array;
  /** Where the contact is, in the world's frame. */
  point: Float64Array | null;
  contact: (Contact & OfBodies) | null;
}

/** The rows of an answer, in the module's memory: nothing is copied. The next question to its owner ends them. */
export class Rows<Row> implements Iterable<Row> {
  /** @internal */
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

/** Of a struct of C: how many bytes it has, and how it is read. */
export interface Layout<Row> {
  bytes: number;
  read(memory: Memory, place: number): Row;
}
