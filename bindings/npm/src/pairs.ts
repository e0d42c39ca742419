import { KINDS, VERTICES } from "./answers.js";
import type { Kind, NearPair, PairResult, Rows, SafeStep } from "./answers.js";
import { Handle } from "./handle.js";
import { nearPair, pairResult, safeStep } from "./layouts.js";
import { need, only, rowsOf, whole } from "./memory.js";
import type { Memory, Numbers } from "./memory.js";
import type { Module } from "./module.js";
import { pairOptions } from "./options.js";
import type { PairOptions } from "./options.js";

/** The kind of each pair, or one for all. */
export type Kinds = Kind | readonly Kind[];
/** Options of a list of pairs: instead of the separation that all have. */
export interface ListOptions {
  minSeparation?: number;
}

const SIZE = { pair: 20, step: 32, safeStep: 112 };

/** Pairs of features, for callers who have a broad phase of their own. */
export class Pairs extends Handle {
  /** @internal Tamis.pairs makes them. */
  constructor(module: Module, options: PairOptions) {
    super(module, "pairs");
    this.make("pairs_create", (given) => [pairOptions(this.kept, given, options)]);
  }

  /** Decides pairs of a vertex and a face: p a b c, twelve numbers each, at t=0 and at t=1. */
  vertexFace(start: Numbers, end: Numbers): Rows<PairResult> {
    return this.decided("vertex_face", 12, start, end);
  }
  /** Two edges: twelve numbers a pair. */
  edgeEdge(start: Numbers, end: Numbers): Rows<PairResult> {
    return this.decided("edge_edge", 12, start, end);
  }
  /** A vertex and an edge: nine numbers a pair. */
  vertexEdge(start: Numbers, end: Numbers): Rows<PairResult> {
    return this.decided("vertex_edge", 9, start, end);
  }
  /** Two vertices: six numbers a pair. */
  vertexVertex(start: Numbers, end: Numbers): Rows<PairResult> {
    return this.decided("vertex_vertex", 6, start, end);
  }

  /** Decides the pairs of a list, four vertices each: rows of the positions. Entries that a kind does not use are not read. */
  narrowPhase(kinds: Kinds, vertices: Numbers, start: Numbers, end: Numbers, options: ListOptions = {}): Rows<PairResult> {
    return this.ask((given) => {
      const asked = [...list(given, kinds, vertices), step(given, start, end, options)];
      return this.table(pairResult, asked[1], (place, bytes) => this.call("narrow_phase", ...asked, place, bytes));
    });
  }
  /** The distance of each pair of a list at these positions. */
  distancesOf(kinds: Kinds, vertices: Numbers, positions: Numbers): Rows<NearPair> {
    return this.ask((given) => {
      const asked = [...list(given, kinds, vertices), step(given, positions, null, {})];
      return this.table(nearPair, asked[1], (place, bytes) => this.call("distances_of", ...asked, place, bytes));
    });
  }
  /** How far one pair may go while it keeps this fraction of its distance, 0 <= keep < 1. */
  safeStep(kind: Kind, vertices: Numbers, start: Numbers, end: Numbers, keep = 0.1, options: ListOptions = {}): SafeStep<NearPair> {
    return this.ask((given) => {
      const [first, count] = list(given, kind, vertices);
      need(count === 1, `there are ${count} pairs: give one`);
      const asked = [first, step(given, start, end, options), keep], place = this.rows.struct(SIZE.safeStep, []);
      this.call("pair_safe_step", ...asked, place);
      return safeStep(nearPair).read(this.rows, place);
    });
  }


  private decided(name: string, width: number, start: Numbers, end: Numbers): Rows<PairResult> {
    const count = rowsOf(start, width, "start", "pair");
    need(end.length === start.length, `start has ${start.length} numbers, end ${end.length}: give as many`, 3);
    return this.ask((given) => {
      const asked = [count, given.doubles(start), given.doubles(end)];
      return this.table(pairResult, count, (place, bytes) => this.call(name, ...asked, place, bytes));
    });
  }
}

/** Writes a list; returns where it is, and how many pairs it has. */
function list(given: Memory, kinds: Kinds, vertices: Numbers): [place: number, count: number] {
  const [number, ...rest] = typeof kinds === "string" ? [kinds] : kinds;
  const width = rest.length === 0 && vertices.length === VERTICES[KINDS.indexOf(number)] ? vertices.length : 4;
  const count = rowsOf(vertices, width, "vertices", "pair");
  need(typeof kinds === "string" || kinds.length === count, `there are ${kinds.length} kinds and ${count} pairs: give as many`, 3);
  const place = given.room(SIZE.pair * count);
  for (let i = 0; i < count; ++i) {
    const kind = typeof kinds === "string" ? kinds : kinds[i];
    need(KINDS.includes(kind), `pair ${i} is '${kind}': use ${KINDS.join(", ")}`, 3);
    const row = Array.from({ length: width }, (_, j) => whole(vertices[width * i + j], `a vertex of pair ${i}`));
    given.fill(place + SIZE.pair * i, [KINDS.indexOf(kind), ...row], {});
  }
  return [place, count];
}

/** A step of positions with any number of rows. */
function step(given: Memory, start: Numbers, end: Numbers | null, options: ListOptions): number {
  only(options, "options of a list", "minSeparation");
  const count = rowsOf(start, 3, "start", "vertex");
  need(!end || end.length === start.length, `start has ${start.length} numbers, end ${end?.length}: give as many`, 3);
  return given.struct(SIZE.step, [count, given.doubles(start), end ? given.doubles(end) : 0, 0, 0, given.optional(options.minSeparation)]);
}
