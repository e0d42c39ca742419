// The contacts of all steps, or the intersections of a pose: a column for each property.
import type { PairKind } from "./header";
import type { SceneFile } from "./scene_file";

/** Returns the doubles whose bits, as integers, are the sum of those of `lower` and `width`. */
function upperEnds(lower: Float64Array, width: BigUint64Array): Float64Array {
  const bits = new BigUint64Array(lower.slice().buffer);
  for (let i = 0; i < bits.length; ++i) bits[i] += width[i];
  return new Float64Array(bits.buffer);
}

/** Adds the first weight to the stored ones: all weights add up to 1. */
const completed = (stored: number[]): number[] => [1 - stored.reduce((sum, w) => sum + w, 0), ...stored];

export class Contacts {
  readonly count: number;
  readonly kinds: PairKind[];
  readonly kind: Uint8Array;
  readonly toiLower: Float64Array;
  readonly toiUpper: Float64Array;
  /** The numbers of vertices, and of stored weights, of the kind of pair that has most. */
  private readonly vertexWidth: number;
  private readonly weightWidth: number;
  private readonly certainty: Uint8Array;
  private readonly fresh: Uint8Array | null;
  private readonly vertices: Int32Array;
  private readonly weights: Uint16Array;
  private readonly normals: Int16Array;

  constructor(file: SceneFile) {
    this.kinds = file.header.kinds;
    this.kind = file.planes("kind", 1);
    this.count = this.kind.length;
    this.certainty = file.planes("certainty", 1);
    this.fresh = "is_new" in file.header.columns ? file.planes("is_new", 1) : null;
    this.vertexWidth = Math.max(...this.kinds.map(({ first, second }) => first + second));
    this.weightWidth = this.vertexWidth - 2;
    this.vertices = new Int32Array(file.integers("vertices", this.vertexWidth).buffer);
    this.toiLower = new Float64Array(file.planes("toi_lower", 8).buffer);
    this.toiUpper = upperEnds(this.toiLower, new BigUint64Array(file.planes("toi_width", 8).buffer));
    this.weights = new Uint16Array(file.planes("weights", 2).buffer);
    this.normals = new Int16Array(file.planes("normals", 2).buffer);
  }

  isUnresolved(i: number): boolean {
    return this.certainty[i] === 1;
  }

  /** Whether an audit's frame before did not have the pair. */
  isNew(i: number): boolean {
    return this.fresh?.[i] === 1;
  }

  kindOf(i: number): PairKind {
    return this.kinds[this.kind[i]];
  }

  firstFeature(i: number): number[] {
    const at = this.vertexWidth * i;
    return [...this.vertices.subarray(at, at + this.kindOf(i).first)];
  }

  secondFeature(i: number): number[] {
    const { first, second } = this.kindOf(i);
    const at = this.vertexWidth * i + first;
    return [...this.vertices.subarray(at, at + second)];
  }

  has(i: number, vertex: number): boolean {
    const { first, second } = this.kindOf(i);
    for (let k = 0; k < first + second; ++k) if (this.vertex(i, k) === vertex) return true;
    return false;
  }

  /** The vertex in place k of contact i, without a copy. */
  vertex(i: number, k: number): number {
    return this.vertices[this.vertexWidth * i + k];
  }

  /** The stored weights, to 1/65535: u and v; for an edge and a face the edge's parameter, then u and v. */
  storedWeights(i: number): number[] {
    const at = this.weightWidth * i;
    return Array.from(this.weights.subarray(at, at + this.weightWidth), (w) => w / 65535);
  }

  /** The stored weight in place k, without a copy. */
  storedWeight(i: number, k: number): number {
    return this.weights[this.weightWidth * i + k] / 65535;
  }

  /** The weights of the first feature's vertices. */
  firstWeights(i: number): number[] {
    return completed(this.storedWeights(i).slice(0, this.kindOf(i).first - 1));
  }

  /** The weights of the second feature's vertices, which are stored after the first one's. */
  secondWeights(i: number): number[] {
    const { first, second } = this.kindOf(i);
    return completed(this.storedWeights(i).slice(first - 1, first + second - 2));
  }

  /** A unit vector, each component to 1/32767. */
  normal(i: number): [number, number, number] {
    return [this.normals[3 * i] / 32767, this.normals[3 * i + 1] / 32767, this.normals[3 * i + 2] / 32767];
  }
}
