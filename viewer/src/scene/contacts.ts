// The contacts of all steps, a column a property.
import type { PairKind } from "./header";
import type { SceneFile } from "./scene_file";

/** Doubles whose bits are those of `lower` plus `width`. */
function upperEnds(lower: Float64Array, width: BigUint64Array): Float64Array {
  const bits = new BigUint64Array(lower.slice().buffer);
  for (let i = 0; i < bits.length; ++i) bits[i] += width[i];
  return new Float64Array(bits.buffer);
}

export class Contacts {
  readonly count: number;
  readonly kinds: PairKind[];
  readonly kind: Uint8Array;
  readonly toiLower: Float64Array;
  readonly toiUpper: Float64Array;
  private readonly certainty: Uint8Array;
  private readonly vertices: Int32Array;
  private readonly weights: Uint16Array;
  private readonly normals: Int16Array;

  constructor(file: SceneFile) {
    this.kinds = file.header.kinds;
    this.kind = file.planes("kind", 1);
    this.count = this.kind.length;
    this.certainty = file.planes("certainty", 1);
    this.vertices = new Int32Array(file.integers("vertices", 4).buffer);
    this.toiLower = new Float64Array(file.planes("toi_lower", 8).buffer);
    this.toiUpper = upperEnds(this.toiLower, new BigUint64Array(file.planes("toi_width", 8).buffer));
    this.weights = new Uint16Array(file.planes("weights", 2).buffer);
    this.normals = new Int16Array(file.planes("normals", 2).buffer);
  }

  isUnresolved(i: number): boolean {
    return this.certainty[i] === 1;
  }

  kindOf(i: number): PairKind {
    return this.kinds[this.kind[i]];
  }

  firstFeature(i: number): number[] {
    return [...this.vertices.subarray(4 * i, 4 * i + this.kindOf(i).first)];
  }

  secondFeature(i: number): number[] {
    const { first, second } = this.kindOf(i);
    return [...this.vertices.subarray(4 * i + first, 4 * i + first + second)];
  }

  has(i: number, vertex: number): boolean {
    const { first, second } = this.kindOf(i);
    for (let k = 0; k < first + second; ++k) if (this.vertices[4 * i + k] === vertex) return true;
    return false;
  }

  /** The vertex in place k of contact i, without a copy. */
  vertex(i: number, k: number): number {
    return this.vertices[4 * i + k];
  }

  /** u and v, to 1/65535. */
  uv(i: number): [number, number] {
    return [this.weights[2 * i] / 65535, this.weights[2 * i + 1] / 65535];
  }

  /** Weights of the first feature's vertices. */
  firstWeights(i: number): number[] {
    const [u] = this.uv(i);
    return this.kindOf(i).first === 1 ? [1] : [1 - u, u];
  }

  /** Weights of the second feature's vertices: the pair's first free weight is u, its next one v. */
  secondWeights(i: number): number[] {
    const { first, second } = this.kindOf(i);
    const [u, v] = this.uv(i);
    if (second === 3) return [1 - u - v, u, v];
    if (second === 1) return [1];
    const w = first === 1 ? u : v;
    return [1 - w, w];
  }

  /** Unit up to 1/32767 a component. */
  normal(i: number): [number, number, number] {
    return [this.normals[3 * i] / 32767, this.normals[3 * i + 1] / 32767, this.normals[3 * i + 2] / 32767];
  }
}
