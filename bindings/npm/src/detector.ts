import type { Contact, Earliest, Intersection, NearPair, Rows, SafeStep } from "./answers.js";
import type { Numbered } from "./handle.js";
import { contact, intersection, nearPair } from "./layouts.js";
import { need } from "./memory.js";
import type { Memory, Numbers } from "./memory.js";
import { withMesh } from "./mesh.js";
import type { Mesh, MeshInput } from "./mesh.js";
import type { Module } from "./module.js";
import { atStartOf, detectorOptions, pathOptions, queryOptions } from "./options.js";
import type { DetectorOptions, PathOptions, QueryOptions } from "./options.js";
import { Path } from "./path.js";
import { Questions } from "./questions.js";

/** Where each vertex is: three numbers a vertex. */
export type Positions = Numbers;
/** A step, by default from `start` to `end`, or a path. */
export type Motion = [start?: Positions, end?: Positions, options?: QueryOptions] | [path: Path, options?: PathOptions];

const STEP = 32;

/** Finds contacts of a mesh with itself, step after step. Free it when it is no longer needed: `using`, or `free()`. */
export class Detector extends Questions<Contact, NearPair, Intersection> {
  /** Rows of the positions. */
  readonly vertexCount: number;
  private places = { start: 0, end: 0 };

  /** @internal Tamis.detector makes detectors. */
  constructor(module: Module, mesh: Mesh | MeshInput, options: DetectorOptions) {
    super(module, "detector", { contact, near: nearPair, intersection });
    this.vertexCount = withMesh(module, mesh, (made) => {
      const { vertexCount } = made;
      this.make("detector_create", (given) => {
        this.places = { start: this.kept.room(24 * vertexCount), end: this.kept.room(24 * vertexCount) };
        return [made.placeFor(module), detectorOptions(this.kept, given, options, vertexCount)];
      });
      return vertexCount;
    });
  }

  /** The positions at t=0, in the module's memory: write into them, then call without positions. Read them anew after each question. */
  get start(): Float64Array {
    return this.positions("start");
  }
  /** The positions at t=1. */
  get end(): Float64Array {
    return this.positions("end");
  }

  /** All contacts, sorted by kind, then vertices. Without positions: of the step from `start` to `end`. */
  contacts(...motion: Motion): Rows<Contact> {
    return this.contactRows(...this.moved("contacts", motion));
  }
  /** The first contact: the motion is free before `toiLower`. Without a contact both times are 1. */
  earliest(...motion: Motion): Earliest<Contact> {
    return this.first(...this.moved("earliest", motion));
  }
  /** Is the whole motion free of contacts? True is proven. */
  isFree(...motion: Motion): boolean {
    return this.flag(...this.moved("is_free", motion));
  }

  /** How far the step may go while every pair keeps this fraction of its distance at t=0, 0 <= keep < 1; and the pair that ends it. */
  safeStep(keep = 0.1, start?: Positions, end?: Positions, options: QueryOptions = {}): SafeStep<NearPair> {
    return this.safeStepBy((given) => [this.step(given, start, end, options), keep]);
  }

  /** Positions to go to, each vertex as far as it may on its own line: every pair keeps the fraction `keep` of its distance. */
  truncate(
    keep = 0.1, start?: Positions, end?: Positions, options: QueryOptions & { stored?: "float64" | "float32" } = {},
  ): { positions: Float64Array; fractions: Float64Array; isFree: boolean } {
    const { stored = "float64", ...query } = options;
    need(["float64", "float32"].includes(stored), `stored is '${stored}': use float64 or float32`);
    return this.ask((given) => {
      const step = this.step(given, start, end, query);
      const [positions, fractions, free] = [this.rows.room(24 * this.vertexCount), this.rows.room(8 * this.vertexCount), given.room(4)];
      this.call("detector_truncate", step, keep, stored === "float32" ? 1 : 0, positions, fractions, free);
      return {
        positions: this.rows.viewOfDoubles(positions, 3 * this.vertexCount), fractions: this.rows.viewOfDoubles(fractions, this.vertexCount),
        isFree: given.viewOfIntegers(free, 1)[0] !== 0,
      };
    });
  }

  /** Pairs of features within `distance` plus both radii at the step's start. */
  pairsWithin(distance: number, start?: Positions): Rows<NearPair> {
    return this.nearRows((given) => [this.step(given, start), distance]);
  }
  /** Edges that pass through triangles at the step's start, or touch them. Decided exactly. */
  intersections(start?: Positions): Rows<Intersection> {
    return this.intersectionRows((given) => [this.step(given, start)]);
  }
  /** Is there any intersection? Ends at the first one. */
  hasIntersection(start?: Positions): boolean {
    return this.flag("has_intersection", (given) => [this.step(given, start)]);
  }

  private positions(name: "start" | "end"): Float64Array<ArrayBuffer> {
    this.placeFor(this.module);
    return this.kept.viewOfDoubles(this.places[name], 3 * this.vertexCount);
  }

  /** The question's name in C and its arguments. */
  private moved(question: string, motion: Motion): [name: string, numbers: Numbered] {
    const [first, second, third] = motion;
    if (!(first instanceof Path)) return [question, (given) => [this.step(given, first, second as Positions, third)]];
    return [`${question}_on_path`, (given) => [this.lend(first), pathOptions(given, (second as PathOptions) ?? {})]];
  }

  /** Writes the step; returns where it stands. */
  private step(given: Memory, start?: Positions, end?: Positions, options: QueryOptions = {}): number {
    const { minSeparation } = queryOptions(options);
    for (const [name, positions] of [["start", start], ["end", end]] as const) {
      if (!positions) continue;
      need(positions.length === 3 * this.vertexCount, `${name} has ${positions.length} numbers: give ${3 * this.vertexCount}, three a vertex`);
      this.positions(name).set(positions);
    }
    return given.struct(STEP, [this.vertexCount, this.places.start, this.places.end, 0, 0, given.optional(minSeparation), atStartOf(options)]);
  }
}
