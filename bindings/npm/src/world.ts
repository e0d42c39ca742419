import type { Contact, Earliest, EdgeAnswer, Intersection, NearPair, OfBodies, Rows, SafeStep } from "./answers.js";
import { Bodies, numbersOf } from "./bodies.js";
import type { Named } from "./bodies.js";
import { earliest, edgeAnswer } from "./layouts.js";
import type { Linkage } from "./linkage.js";
import { need, only, rowsOf, whole } from "./memory.js";
import type { Memory, Numbers } from "./memory.js";
import type { Module } from "./module.js";
import { motionsOf } from "./motions.js";
import type { Motions } from "./motions.js";
import { pathOptions } from "./options.js";
import type { EdgeOptions, PathOptions, WorldOptions } from "./options.js";

/** Whether two bodies that stay at a pose count, too; by default they do not. */
export interface RestOptions {
  includeStatic?: boolean;
}

/** Bodies, each with its own shape and motion, and the questions of a detector about them. */
export class World extends Bodies {
  /** @internal Tamis.world makes worlds. */
  constructor(module: Module, options: WorldOptions) {
    super(module, options);
  }

  /** All contacts, sorted by kind, then bodies and vertices. */
  contacts(options: PathOptions = {}): Rows<Contact & OfBodies> {
    return this.contactRows("contacts", (given) => [pathOptions(given, options)]);
  }
  /** The first contact of each pair of bodies that touches. */
  firstContacts(options: PathOptions = {}): Rows<Contact & OfBodies> {
    return this.contactRows("first_contacts", (given) => [pathOptions(given, options)]);
  }
  /** The first contact. */
  earliest(options: PathOptions = {}): Earliest<Contact & OfBodies> {
    return this.first("earliest", (given) => [pathOptions(given, options)]);
  }
  /** The first contact of each of `count` motions of these bodies, while all others move as they were told. For the first motion one entry a body, then for the second, ... */
  earliestMany(bodies: Named, count: number, motions: Motions, options: PathOptions = {}): Rows<Earliest<Contact & OfBodies>> {
    const named = numbersOf(bodies);
    return this.ask((given) => {
      const asked = [given.integers(named), named.length, motionsOf(given, whole(count, "count") * named.length, motions), pathOptions(given, options)];
      return this.table(earliest, count, (place, bytes) => this.call("world_earliest_many", ...asked, place, bytes));
    });
  }
  /** Is the motion of all bodies free of contacts? True is proven. */
  isFree(options: PathOptions = {}): boolean {
    return this.flag("is_free", (given) => [pathOptions(given, options)]);
  }
  /** How far all bodies may go while every pair keeps this fraction of its distance, 0 <= keep < 1; and the pair that ends it. */
  safeStep(keep = 0.1, options: PathOptions = {}): SafeStep<NearPair & OfBodies> {
    return this.safeStepBy((given) => [keep, pathOptions(given, options)]);
  }

  /** Pairs of features within `distance` plus both radii at t=0. */
  pairsWithin(distance: number, options: RestOptions = {}): Rows<NearPair & OfBodies> {
    return this.nearRows(() => [distance, withStatic(options)]);
  }
  /** Edges that pass through triangles at t=0, or touch them. */
  intersections(options: RestOptions = {}): Rows<Intersection & OfBodies> {
    return this.intersectionRows(() => [withStatic(options)]);
  }
  /** Is there any intersection? Ends at the first one. */
  hasIntersection(options: RestOptions = {}): boolean {
    return this.flag("has_intersection", () => [withStatic(options)]);
  }
  /** Do two bodies overlap at t=0: is there an intersection, or a vertex of one inside another? */
  hasOverlap(options: RestOptions = {}): boolean {
    return this.flag("has_overlap", () => [withStatic(options)]);
  }
  /** Is the whole surface of a body closed? Open parts contain nothing. */
  isClosed(body: number): boolean {
    return this.flag("is_closed", () => [whole(body, "body")]);
  }

  /** Which configurations of a linkage are free: 1 is proven. Nothing overlaps, and nothing touches. */
  configurationsAreFree(linkage: Linkage, configurations: Numbers, options: Omit<EdgeOptions, "startsAreFree"> = {}): Uint8Array {
    const count = rowsOf(configurations, linkage.dimension, "configurations", "configuration");
    return this.ask((given) => {
      const place = this.rows.room(count);
      this.call("world_configurations_are_free", this.lend(linkage), given.doubles(configurations), count, pathOptions(given, options), place);
      return this.rows.viewOfBytes(place, count);
    });
  }
  /** Which edges between configurations are free: 1 is proven. Nothing overlaps at their start, and nothing touches along them. */
  edgesAreFree(linkage: Linkage, starts: Numbers, ends: Numbers, options: EdgeOptions = {}): Uint8Array {
    return this.ask((given) => {
      const [numbers, count] = this.edges(given, linkage, starts, ends, options);
      const place = this.rows.room(count);
      this.call("world_edges_are_free", ...numbers, place);
      return this.rows.viewOfBytes(place, count);
    });
  }
  /** How far each edge is free, and the contact that ends it. */
  lastValid(linkage: Linkage, starts: Numbers, ends: Numbers, options: EdgeOptions = {}): Rows<EdgeAnswer> {
    return this.ask((given) => {
      const [numbers, count] = this.edges(given, linkage, starts, ends, options);
      return this.table(edgeAnswer, count, (place, bytes) => this.call("world_last_valid", ...numbers, place, bytes));
    });
  }
  /** The first edge of a trajectory that is not free; null: all are. */
  firstBadEdge(linkage: Linkage, waypoints: Numbers, options: EdgeOptions = {}): EdgeAnswer & { edge: number | null } {
    const count = rowsOf(waypoints, linkage.dimension, "waypoints", "configuration");
    return this.ask((given) => {
      const edge = given.room(4);
      const asked = [this.lend(linkage), given.doubles(waypoints), count, ...edgeOptions(given, options), edge];
      const answer = this.table(edgeAnswer, 1, (place, bytes) => this.call("world_first_bad_edge", ...asked, place, bytes)).at(0);
      return { edge: answer.isFree ? null : given.viewOfIntegers(edge, 1)[0], ...answer };
    });
  }
  /** Which part of a roadmap is free: 1 is proven. `edges`: the numbers of two configurations each. */
  roadmap(
    linkage: Linkage, configurations: Numbers, edges: Numbers, options: Omit<EdgeOptions, "startsAreFree"> = {},
  ): { configurationsAreFree: Uint8Array; edgesAreFree: Uint8Array } {
    const count = rowsOf(configurations, linkage.dimension, "configurations", "configuration");
    const edgeCount = rowsOf(edges, 2, "edges", "edge");
    return this.ask((given) => {
      const [free, freeEdges] = [this.rows.room(count), this.rows.room(edgeCount)];
      const asked = [given.doubles(configurations), count, given.integers(edges), edgeCount, pathOptions(given, options)];
      this.call("world_roadmap", this.lend(linkage), ...asked, free, freeEdges);
      return { configurationsAreFree: this.rows.viewOfBytes(free, count), edgesAreFree: this.rows.viewOfBytes(freeEdges, edgeCount) };
    });
  }

  private edges(given: Memory, linkage: Linkage, starts: Numbers, ends: Numbers, options: EdgeOptions): [numbers: number[], count: number] {
    need(starts.length === ends.length, `starts has ${starts.length} numbers, ends ${ends.length}: give as many`, 9);
    const count = rowsOf(starts, linkage.dimension, "starts", "configuration");
    return [[this.lend(linkage), given.doubles(starts), given.doubles(ends), count, ...edgeOptions(given, options)], count];
  }
}

function edgeOptions(given: Memory, { startsAreFree = false, ...options }: EdgeOptions): number[] {
  return [startsAreFree ? 1 : 0, pathOptions(given, options)];
}

function withStatic(options: RestOptions): number {
  only(options, "options of a question about t=0", "includeStatic");
  return options.includeStatic ? 1 : 0;
}
