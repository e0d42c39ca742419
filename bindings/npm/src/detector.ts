import { contact, intersection, nearPair, Rows } from "./answers.js";
import type { Contact, Intersection, Kind, Layout, NearPair } from "./answers.js";
import { Memory, TamisError } from "./memory.js";
import type { Module } from "./module.js";

/** What moves: triangles, and loose edges and points. Numbers are rows of the positions. */
export interface MeshInput {
  /** Three vertices a triangle. */
  faces?: ArrayLike<number>;
  /** Two vertices an edge. */
  looseEdges?: ArrayLike<number>;
  loosePoints?: ArrayLike<number>;
  /** Rows of the positions; one more than the largest number, if it is not given. */
  vertexCount?: number;
}

/** Options of a detector. */
export interface DetectorOptions {
  /** Contact means a distance of at most this. */
  minSeparation?: number;
  /** The group of each vertex, in [0, groups), or -1 for a vertex of no face, edge or loose point. */
  groups?: ArrayLike<number>;
  /** For each pair of groups, row by row: 0 skips their pairs. */
  mayTouch?: ArrayLike<number>;
  /** Half of each group's thickness. */
  radii?: ArrayLike<number>;
  /** Skips pairs whose features are fewer edges apart along the mesh; 1. */
  rings?: number;
  /** False skips the pair. It must not query this detector. */
  accepts?: (kind: Kind, vertices: Int32Array) => boolean;
  /** Called again and again during a question: true ends it with an error. */
  isCancelled?: () => boolean;
}

/** Options of one question. */
export interface QueryOptions {
  /** Instead of the detector's. */
  minSeparation?: number;
  /** Pairs that touch at t=0: they are contacts, are ignored until they touch anew, or end the question with an error. */
  atStart?: "report" | "ignore" | "fail";
}

/** Where each vertex is: three numbers a vertex. */
export type Positions = ArrayLike<number>;

const KINDS: readonly Kind[] = ["vertex-face", "edge-edge", "vertex-edge", "vertex-vertex"];
const AT_START = { report: 0, ignore: 1, fail: 2 };
const SIZE = { meshInput: 32, options: 64, step: 32, safeStep: 112, statistics: 1280 };

/** Finds contacts of a mesh with itself, step after step. Free it when it is no longer needed: `using`, or `free()`. */
export class Detector {
  /** Rows of the positions. */
  readonly vertexCount: number;
  private readonly memory: Memory;
  private readonly functions: number[] = [];
  private readonly places: { start: number; end: number; step: number; separation: number; number: number; answer: number };
  /** Of the last answer. */
  private readonly rows: Memory;
  private handle = 0;
  private thrown: { error: unknown } | null = null;

  /** @internal Tamis.detector makes detectors. */
  constructor(private readonly module: Module, mesh: MeshInput, options: DetectorOptions) {
    this.memory = new Memory(module);
    this.rows = new Memory(module);
    this.vertexCount = mesh.vertexCount ?? countOf(mesh);
    try {
      this.places = {
        start: this.memory.room(24 * this.vertexCount), end: this.memory.room(24 * this.vertexCount), step: this.memory.room(SIZE.step),
        separation: this.memory.room(8), number: this.memory.room(16), answer: this.memory.room(SIZE.statistics),
      };
      this.make(mesh, options);
    } catch (error) {
      this.free();
      throw error;
    }
  }

  /** The positions at t=0, in the module's memory: write into them, then ask without positions. Read them anew after each question. */
  get start(): Float64Array {
    return this.memory.viewOfDoubles(this.live().places.start, 3 * this.vertexCount);
  }
  /** The positions at t=1. */
  get end(): Float64Array {
    return this.memory.viewOfDoubles(this.live().places.end, 3 * this.vertexCount);
  }

  /** All contacts of the step, sorted by kind, then vertices. Without positions: of those in `start` and `end`. */
  contacts(start?: Positions, end?: Positions, options: QueryOptions = {}): Rows<Contact> {
    return this.answered(contact, "contacts", this.step(start, end, options));
  }

  /** The first contact: the motion is free before `toiLower`. Without a contact both times are 1. */
  earliest(start?: Positions, end?: Positions, options: QueryOptions = {}): { toiLower: number; toiUpper: number; contact: Contact | null } {
    const { answer, number } = this.live().places;
    this.call("_tamis_detector_earliest", this.step(start, end, options), answer, answer + 8, number);
    const [toiLower, toiUpper] = this.memory.viewOfDoubles(answer, 2);
    const rows = this.copied(contact, "contacts");
    return { toiLower, toiUpper, contact: rows.length > 0 ? rows.at(0) : null };
  }

  /** Is the whole step free of contacts? True is proven. */
  isFree(start?: Positions, end?: Positions, options: QueryOptions = {}): boolean {
    return this.flag("_tamis_detector_is_free", this.step(start, end, options));
  }

  /** How far the step may go while every pair keeps this fraction of its distance at t=0, 0 <= keep < 1; and the pair that ends it. */
  safeStep(keep = 0.1, start?: Positions, end?: Positions, options: QueryOptions = {}): { toiLower: number; toiUpper: number; pair: NearPair | null } {
    const { answer } = this.live().places;
    this.module.HEAPU32[answer / 4] = SIZE.safeStep;
    const step = this.step(start, end, options);
    this.call("_tamis_detector_safe_step", step, keep, answer);
    const [toiLower, toiUpper] = this.memory.viewOfDoubles(answer + 8, 2);
    const hasPair = this.module.HEAP32[answer / 4 + 6] !== 0;
    return { toiLower, toiUpper, pair: hasPair ? nearPair.read(this.memory, answer + 32) : null };
  }

  /** Positions to go to, each vertex as far as it may on its own line: every pair keeps the fraction `keep` of its distance. */
  truncate(
    keep = 0.1, start?: Positions, end?: Positions, options: QueryOptions & { stored?: "float64" | "float32" } = {},
  ): { positions: Float64Array; fractions: Float64Array; isFree: boolean } {
    const step = this.step(start, end, options);
    const { number } = this.places;
    this.rows.free();
    const positions = this.rows.room(24 * this.vertexCount);
    const fractions = this.rows.room(8 * this.vertexCount);
    this.call("_tamis_detector_truncate", step, keep, options.stored === "float32" ? 1 : 0, positions, fractions, number);
    return {
      positions: this.memory.viewOfDoubles(positions, 3 * this.vertexCount),
      fractions: this.memory.viewOfDoubles(fractions, this.vertexCount), isFree: this.module.HEAP32[number / 4] !== 0,
    };
  }

  /** Pairs of features within `distance` plus both radii at the step's start. */
  pairsWithin(distance: number, start?: Positions): Rows<NearPair> {
    const step = this.step(start, start, {});
    this.call("_tamis_detector_pairs_within", step, distance, this.places.number);
    return this.copied(nearPair, "pairs_within");
  }

  /** Edges that pass through triangles at the step's start, or touch them. Decided exactly. */
  intersections(start?: Positions): Rows<Intersection> {
    return this.answered(intersection, "intersections", this.step(start, start, {}));
  }

  /** Is there any intersection? Ends at the first one. */
  hasIntersection(start?: Positions): boolean {
    return this.flag("_tamis_detector_has_intersection", this.step(start, start, {}));
  }

  /** The cost of the last question: seconds, pairs by how they were decided, bytes. */
  statistics(): { seconds: number; decidedByLanes: number; decidedByScalar: number; decidedByExact: number; memoryBytes: number } {
    const { answer } = this.live().places;
    this.module.HEAPU32[answer / 4] = SIZE.statistics;
    this.call("_tamis_detector_statistics", answer);
    const counts = new BigUint64Array(this.module.HEAPU8.buffer, answer + 64, 6);
    const [decidedByLanes, decidedByScalar, decidedByExact, , , memoryBytes] = Array.from(counts, Number);
    return { seconds: this.module.HEAPF64[answer / 8 + 2], decidedByLanes, decidedByScalar, decidedByExact, memoryBytes };
  }

  /** Frees the memory of the detector and of its answers. Freeing twice does nothing. */
  free(): void {
    if (this.handle !== 0) this.module._tamis_detector_free(this.handle);
    this.handle = 0;
    this.rows.free();
    this.memory.free();
    for (const place of this.functions.splice(0)) this.module.removeFunction(place);
  }

  private make(mesh: MeshInput, options: DetectorOptions): void {
    const { module } = this;
    const given = new Memory(module);
    const handle = given.room(4);
    const word = () => module.HEAPU32[handle / 4];
    try {
      const { faces = [], looseEdges = [], loosePoints = [] } = mesh;
      need(faces.length % 3 === 0, `there are ${faces.length} numbers of faces: give three for each`);
      need(looseEdges.length % 2 === 0, `there are ${looseEdges.length} numbers of loose edges: give two for each`);
      const input = given.struct(SIZE.meshInput, [
        this.vertexCount, given.integers(faces), faces.length / 3, given.integers(looseEdges), looseEdges.length / 2,
        given.integers(loosePoints), loosePoints.length,
      ]);
      const meshStatus = module._tamis_mesh_create(input, handle);
      const made = word();
      try {
        this.check(meshStatus, module._tamis_mesh_message(made));
        const status = module._tamis_detector_create(made, this.optionsOf(options, given), handle);
        this.handle = word();
        this.check(status, module._tamis_detector_message(this.handle));
      } finally {
        module._tamis_mesh_free(made);
      }
    } finally {
      given.free();
    }
  }

  private optionsOf(options: DetectorOptions, given: Memory): number {
    const { groups = [], mayTouch, radii } = options;
    need(groups.length === 0 || groups.length === this.vertexCount, `groups has ${groups.length} numbers: give ${this.vertexCount}, one a vertex`);
    const count = radii?.length ?? Math.max(0, ...Array.from(groups, (group) => group + 1));
    need(!mayTouch || mayTouch.length === count * count, `mayTouch has ${mayTouch?.length} numbers: give ${count} x ${count}, one for each pair of groups`);
    const touch = mayTouch ? given.room(mayTouch.length) : 0;
    if (mayTouch) this.module.HEAPU8.set(Array.from(mayTouch, (may) => (may ? 1 : 0)), touch);
    const at = given.struct(SIZE.options, [
      0, 1, 0, 0, 0, given.integers(groups), count, touch, this.filterOf(options.accepts), this.functionOf(options.isCancelled), 0,
      given.doubles(radii ?? []), options.rings ?? 0,
    ]);
    this.module.HEAPF64[at / 8 + 2] = options.minSeparation ?? 0;
    return at;
  }

  private filterOf(accepts: DetectorOptions["accepts"]): number {
    if (!accepts) return 0;
    const VERTICES = [4, 4, 3, 2];
    return this.add((_user, kind, place) => accepts(KINDS[kind], this.memory.viewOfIntegers(place, VERTICES[kind])), "iiii");
  }

  private functionOf(isCancelled: (() => boolean) | undefined): number {
    return isCancelled ? this.add(() => isCancelled(), "ii") : 0;
  }

  /** What a function throws waits until the question has ended: nothing is thrown through C. */
  private add(f: (...numbers: number[]) => boolean, signature: string): number {
    const place = this.module.addFunction((...numbers) => {
      try {
        return !this.thrown && f(...numbers) ? 1 : 0;
      } catch (error) {
        this.thrown = { error };
        return 0;
      }
    }, signature);
    this.functions.push(place);
    return place;
  }

  /** Writes the step; returns where it stands. */
  private step(start: Positions | undefined, end: Positions | undefined, options: QueryOptions): number {
    const { places, module } = this.live();
    const copy = (positions: Positions | undefined, place: number, name: string) => {
      if (!positions) return;
      need(positions.length === 3 * this.vertexCount, `${name} has ${positions.length} numbers: give ${3 * this.vertexCount}, three a vertex`);
      module.HEAPF64.set(positions, place / 8);
    };
    copy(start, places.start, "start");
    copy(end, places.end, "end");
    const { minSeparation, atStart = "report" } = options;
    need(atStart in AT_START, `atStart is '${atStart}': use report, ignore or fail`);
    if (minSeparation !== undefined) module.HEAPF64[places.separation / 8] = minSeparation;
    module.HEAP32.set([
      SIZE.step, this.vertexCount, places.start, places.end, 0, 0, minSeparation === undefined ? 0 : places.separation, AT_START[atStart],
    ], places.step / 4);
    return places.step;
  }

  private answered<Row>(layout: Layout<Row>, name: string, step: number): Rows<Row> {
    this.call(`_tamis_detector_${name}`, step, this.places.number);
    return this.copied(layout, name);
  }

  private flag(name: `_tamis_${string}`, step: number): boolean {
    this.call(name, step, this.places.number);
    return this.module.HEAP32[this.places.number / 4] !== 0;
  }

  /** The rows of the question just asked, whose count was written. */
  private copied<Row>(layout: Layout<Row>, name: string): Rows<Row> {
    const count = this.module.HEAPU32[this.places.number / 4];
    this.rows.free();
    const place = this.rows.room(layout.bytes * count);
    this.call(`_tamis_detector_copy_${name}`, 0, count, place, layout.bytes);
    return new Rows(count, (i) => layout.read(this.memory, place + layout.bytes * i));
  }

  private call(name: `_tamis_${string}`, ...numbers: number[]): void {
    const status = this.module[name](this.handle, ...numbers);
    const { thrown } = this;
    this.thrown = null;
    if (thrown) throw thrown.error;
    this.check(status, this.module._tamis_detector_message(this.handle));
  }

  private check(status: number, message: number): void {
    if (status === 0) return;
    throw new TamisError((message !== 0 && this.module.UTF8ToString(message)) || "out of memory: free detectors, or take a smaller mesh", status);
  }

  private live(): this {
    need(this.handle !== 0, "this detector has been freed: make a new one");
    return this;
  }
}

/** `using` frees the detector, where the engine knows it. */
if (typeof Symbol.dispose === "symbol") Object.defineProperty(Detector.prototype, Symbol.dispose, { value: Detector.prototype.free });
export interface Detector extends Disposable {}

function countOf({ faces = [], looseEdges = [], loosePoints = [] }: MeshInput): number {
  let largest = -1;
  for (const numbers of [faces, looseEdges, loosePoints])
    for (let i = 0; i < numbers.length; ++i) largest = Math.max(largest, numbers[i]);
  return largest + 1;
}

function need(holds: boolean, message: string): asserts holds {
  if (!holds) throw new TamisError(message, 1);
}
