import { KINDS, VERTICES } from "./answers.js";
import type { Kind } from "./answers.js";
import { need, only, whole } from "./memory.js";
import type { Memory, Numbers } from "./memory.js";

/** Options of lists of pairs, of worlds and of detectors. */
export interface Cancellable {
  /** Called again and again during a question: true ends it with an error. */
  isCancelled?: () => boolean;
}

/** Options of a world. */
export interface WorldOptions extends Cancellable {
  /** Contact means a distance of at most this. */
  minSeparation?: number;
  /** Skips pairs whose features are fewer edges apart along their mesh; 1. */
  rings?: number;
}

/** Options of a detector. */
export interface DetectorOptions extends WorldOptions {
  /** The group of each vertex, in [0, groups), or -1 for a vertex of no face, edge or loose point. */
  groups?: Numbers;
  /** For each pair of groups, row by row: 0 skips their pairs. */
  mayTouch?: Numbers;
  /** Half of each group's thickness. */
  radii?: Numbers;
  /** False skips the pair. It must not query this detector. */
  accepts?: (kind: Kind, vertices: Int32Array) => boolean;
}

/** Options of lists of pairs. */
export interface PairOptions extends Cancellable {
  minSeparation?: number;
  /** The latest time of interest, in [0, 1]: a pair that is apart until then counts as free. */
  latest?: number;
}

/** Options of one question. */
export interface QueryOptions {
  /** Instead of the detector's, or the world's. */
  minSeparation?: number;
  /** Pairs that touch at t=0: they are contacts, are ignored until they touch anew, or end the question with an error. */
  atStart?: "report" | "ignore" | "fail";
}

/** Options of one question about a path or a world, whose bodies may turn. */
export interface PathOptions extends QueryOptions {
  /** The widest bracket of a contact, a fraction of the step in (0, 1]; 1e-9. */
  tolerance?: number;
}

/** Options of a planner's question. */
export interface EdgeOptions {
  minSeparation?: number;
  tolerance?: number;
  /** The starts are known not to overlap: they are not tested. */
  startsAreFree?: boolean;
}

const AT_START = { report: 0, ignore: 1, fail: 2 };
const SIZE = { detector: 64, world: 40, pairs: 40, path: 32 };
const QUERY = ["minSeparation", "atStart"];

export function atStartOf({ atStart = "report" }: QueryOptions): number {
  need(atStart in AT_START, `atStart is '${atStart}': use report, ignore or fail`);
  return AT_START[atStart];
}

const cancelled = (given: Memory, { isCancelled }: Cancellable): number =>
  isCancelled ? given.callback(() => (isCancelled() ? 1 : 0), "ii", () => 1) : 0;

/** `kept` holds the functions as long as the detector, `given` the rest. */
export function detectorOptions(kept: Memory, given: Memory, options: DetectorOptions, vertexCount: number): number {
  only(options, "options of a detector", "minSeparation", "groups", "mayTouch", "radii", "rings", "accepts", "isCancelled");
  const { groups = [], mayTouch, radii, accepts, minSeparation = 0, rings = 0 } = options;
  need(groups.length === 0 || groups.length === vertexCount, `groups has ${groups.length} numbers: give ${vertexCount}, one a vertex`);
  const count = radii?.length ?? Array.from(groups).reduce((most, group) => Math.max(most, group + 1), 0);
  need(!mayTouch || mayTouch.length === count * count, `mayTouch has ${mayTouch?.length} numbers: give ${count} x ${count}, one for each pair of groups`);
  const touch = mayTouch ? given.room(mayTouch.length) : 0;
  if (mayTouch) given.viewOfBytes(touch, mayTouch.length).set(Array.from(mayTouch, (may) => (may ? 1 : 0)));
  const filter = accepts
    ? kept.callback((_user, kind, place) => (accepts(KINDS[kind], kept.viewOfIntegers(place, VERTICES[kind])) ? 1 : 0), "iiii", () => 0)
    : 0;
  return given.struct(
    SIZE.detector,
    [0, 1, 0, 0, 0, given.integers(groups), count, touch, filter, cancelled(kept, options), 0, given.doubles(radii ?? []), whole(rings, "rings")],
    { 16: [minSeparation] },
  );
}

export function worldOptions(kept: Memory, given: Memory, options: WorldOptions): number {
  only(options, "options of a world", "minSeparation", "rings", "isCancelled");
  const { minSeparation = 0, rings = 0 } = options;
  return given.struct(SIZE.world, [0, 1, whole(rings, "rings"), 0, 0, cancelled(kept, options)], { 16: [minSeparation] });
}

export function pairOptions(kept: Memory, given: Memory, options: PairOptions): number {
  only(options, "options of pairs", "minSeparation", "latest", "isCancelled");
  const { minSeparation = 0, latest } = options;
  return given.struct(SIZE.pairs, [0, 0, 0, 1, 0, given.optional(latest), cancelled(kept, options)], { 8: [minSeparation] });
}

export function queryOptions(options: QueryOptions): QueryOptions {
  only(options, "options of a question about a step", ...QUERY);
  return options;
}

/** `more` names what the question has beside these. */
export function pathOptions(given: Memory, options: PathOptions & Cancellable, ...more: string[]): number {
  only(options, "options of this question", ...QUERY, "tolerance", ...more);
  const { tolerance, minSeparation } = options;
  need(tolerance !== 0, "tolerance is 0: give a fraction of the step in (0, 1]", 4);
  return given.struct(SIZE.path, [0, 0, 0, given.optional(minSeparation), cancelled(given, options), 0, atStartOf(options)], { 8: [tolerance ?? 0] });
}
