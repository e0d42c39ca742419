import type { Contact, Intersection, NearPair, OfBodies } from "./answers.js";
import { bodyContact, bodyIntersection, bodyNearPair } from "./layouts.js";
import { rowsOf, whole, within } from "./memory.js";
import type { Numbers } from "./memory.js";
import type { Module } from "./module.js";
import { motionsOf } from "./motions.js";
import type { Motions } from "./motions.js";
import { worldOptions } from "./options.js";
import type { WorldOptions } from "./options.js";
import { Questions } from "./questions.js";
import type { Shape } from "./shape.js";

/** One body by its number, or many. */
export type Named = number | Numbers;
export const numbersOf = (bodies: Named): Numbers => (typeof bodies === "number" ? [bodies] : bodies);

/** Which bodies a world has, how they move, and which may touch. A refused call changes nothing. */
export abstract class Bodies extends Questions<Contact & OfBodies, NearPair & OfBodies, Intersection & OfBodies> {
  private readonly vertexCounts = new Map<number, number>();

  /** @internal */
  protected constructor(module: Module, options: WorldOptions) {
    super(module, "world", { contact: bodyContact, near: bodyNearPair, intersection: bodyIntersection });
    this.make("world_create", (given) => [worldOptions(this.kept, given, options)]);
  }

  /** Adds a body; returns its number: 0, 1, 2, ... */
  add(shape: Shape, motion: Motions = {}): number {
    return this.addMany(shape, 1, motion)[0];
  }
  /** Adds so many bodies of one shape. Returns their numbers. */
  addMany(shape: Shape, count: number, motions: Motions = {}): Int32Array {
    return within(this.module, (given) => {
      const told = motionsOf(given, whole(count, "count"), motions), place = given.room(4 * count);
      this.call("world_add", shape.placeFor(this.module), told, place);
      const bodies = given.viewOfIntegers(place, count).slice();
      for (const body of bodies) this.vertexCounts.set(body, shape.vertexCount);
      return bodies;
    });
  }
  /** Tells one body, or many, each named once, their motion from now on. */
  move(bodies: Named, motions: Motions): void {
    const named = numbersOf(bodies);
    within(this.module, (given) => this.call("world_move", given.integers(named), motionsOf(given, named.length, motions)));
  }
  /** Removes bodies. Their numbers are not given again. */
  remove(bodies: Named): void {
    this.change("remove", numbersOf(bodies));
    for (const body of Array.from(numbersOf(bodies))) this.vertexCounts.delete(body);
  }
  /** Bodies that are off take no part in any question. */
  setEnabled(bodies: Named, isEnabled: boolean): void {
    this.change("set_enabled", numbersOf(bodies), isEnabled ? 1 : 0);
  }
  /** Half of the thickness of these bodies. */
  setRadius(bodies: Named, radius: number): void {
    this.change("set_radius", numbersOf(bodies), radius);
  }
  /** May these pairs of bodies touch? Two numbers a pair. False leaves a pair out of every answer. */
  setMayTouch(pairs: Numbers, mayTouch: boolean): void {
    this.change("set_may_touch", pairs, mayTouch ? 1 : 0, 2);
  }

  /** Where a body's vertices are at a time in [0, 1], on the curves that questions are about; no coordinate is off by more than `error`. */
  pointsAt(body: number, time: number): { points: Float64Array; error: number } {
    return within(this.module, (given) => {
      const count = this.vertexCounts.get(body) ?? 0;
      const [points, error] = [given.room(24 * count), given.room(8)];
      this.call("world_points_at", whole(body, "body"), time, count, points, error);
      return { points: given.viewOfDoubles(points, 3 * count).slice(), error: given.viewOfDoubles(error, 1)[0] };
    });
  }

  private change(name: string, bodies: Numbers, value?: number, width = 1): void {
    const count = rowsOf(bodies, width, "bodies", "pair");
    within(this.module, (given) => this.call(`world_${name}`, given.integers(bodies), count, ...(value === undefined ? [] : [value])));
  }
}
