// One contact's pair of features and its motion.
import { cross, dot, length, mix, subtract, times, unit, weighted, type Vec3 } from "../vectors";
import { isIntersection } from "./proofs";
import type { Scene, Step } from "./scene";

export class Pair {
  readonly first: number[];
  readonly second: number[];
  readonly toiLower: number;
  readonly toiUpper: number;
  readonly normal: Vec3;
  /** The longest edge of the features, or of points how far they move; in the drawing's unit. */
  readonly size: number;
  /** A pair without a time of its own: an edge passes through a face in a frame. */
  readonly isIntersection: boolean;
  /** Times at which the pair is visibly apart before the contact, and visibly past it. */
  readonly before: number;
  readonly after: number;
  private readonly firstWeights: number[];
  private readonly secondWeights: number[];

  constructor(
    scene: Scene,
    private readonly step: Step,
    readonly index: number,
  ) {
    const { contacts } = scene;
    this.first = contacts.firstFeature(index);
    this.second = contacts.secondFeature(index);
    this.toiLower = contacts.toiLower[index];
    this.toiUpper = contacts.toiUpper[index];
    this.firstWeights = contacts.firstWeights(index);
    this.secondWeights = contacts.secondWeights(index);
    this.normal = scene.direction(contacts.normal(index));
    this.size = this.extent();
    this.isIntersection = isIntersection(contacts, index);
    const reach = this.isIntersection ? 0 : this.visibleTime();
    this.before = Math.max(0, this.toi - reach);
    this.after = Math.min(1, this.toi + reach);
  }

  get toi(): number {
    return this.toiUpper;
  }

  at(vertex: number, time: number): Vec3 {
    const place = (positions: Float32Array): Vec3 => [
      positions[3 * vertex],
      positions[3 * vertex + 1],
      positions[3 * vertex + 2],
    ];
    return mix(place(this.step.start), place(this.step.end), time);
  }

  firstPoint(time: number): Vec3 {
    return weighted(
      this.first.map((v) => this.at(v, time)),
      this.firstWeights,
    );
  }

  secondPoint(time: number): Vec3 {
    return weighted(
      this.second.map((v) => this.at(v, time)),
      this.secondWeights,
    );
  }

  /** The distance along the normal from the second contact point to the first; it changes sign as they pass. */
  gap(time: number): number {
    return dot(this.normal, subtract(this.firstPoint(time), this.secondPoint(time)));
  }

  /** The velocity of the first contact point relative to the second's. */
  get relativeVelocity(): Vec3 {
    const apart = (time: number): Vec3 => subtract(this.firstPoint(time), this.secondPoint(time));
    return subtract(apart(1), apart(0));
  }

  /** A unit vector in the plane of contact, along an edge if there is one. */
  get tangent(): Vec3 {
    const edges = [...this.edgesOf(this.second), ...this.edgesOf(this.first)].map(([a, b]) =>
      subtract(this.at(b, this.toi), this.at(a, this.toi)),
    );
    for (const edge of [...edges, [1, 0, 0] as Vec3, [0, 1, 0] as Vec3]) {
      const inPlane = subtract(edge, times(dot(edge, this.normal), this.normal));
      if (length(inPlane) > 1e-3 * Math.max(length(edge), 1e-12)) return unit(inPlane);
    }
    return unit(cross(this.normal, [0, 0, 1]));
  }

  edgesOf(feature: number[]): [number, number][] {
    if (feature.length === 3)
      return [
        [feature[0], feature[1]],
        [feature[1], feature[2]],
        [feature[2], feature[0]],
      ];
    return feature.length === 2 ? [[feature[0], feature[1]]] : [];
  }

  private extent(): number {
    const edges = [...this.edgesOf(this.first), ...this.edgesOf(this.second)];
    const lengths = edges.map(([a, b]) => length(subtract(this.at(a, this.toi), this.at(b, this.toi))));
    const longest = Math.max(0, ...lengths);
    if (longest > 0) return longest;
    const moved = [...this.first, ...this.second].map((v) => length(subtract(this.at(v, 1), this.at(v, 0))));
    return Math.max(1e-6, ...moved);
  }

  /** The time in which the contact points move by a third of the pair's size relative to each other; at most 1. */
  private visibleTime(): number {
    const speed = length(this.relativeVelocity);
    return speed > 0 ? Math.min((0.35 * this.size) / speed, 1) : 1;
  }
}
