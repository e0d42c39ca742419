// What is drawn of large scenes: a coarse surface while anything moves, and the whole in slices once nothing does.
import { LineSegments, Mesh, Points } from "three";
import type { BufferGeometry, Camera, InstancedBufferGeometry, Object3D, Scene, WebGLRenderer } from "three";

/** Pictures that cost more than this are drawn in slices, smaller ones at once. The unit is one vertex of a triangle. */
const kLarge = 400_000;
/** Prices of one vertex where the processor draws, measured: a point covers pixels, a segment is blended. */
const kPointPrice = 2;
const kSegmentPrice = 6;
/** A draft has at most so many triangles, points and segments. */
const kDraftTriangles = 60_000;
export const kDraftPoints = 10_000;
export const kDraftSegments = 2_000;
/** A slice has at most so many vertices, a multiple of 2 and 3: some twentieth of a second where the processor draws. */
const kSlice = 59_994;
/** So many segments are one object of the scene, so that they can be drawn in slices. */
export const kSegmentSlice = 2_500;

type Numbers = Uint32Array | Float32Array | Uint8Array;

/** Returns rows of `width` numbers at equal distances: `most` of them, or all if there are fewer. */
export function thinned<Rows extends Numbers>(rows: Rows, width: number, most: number): Rows {
  const count = rows.length / width;
  if (count <= most) return rows;
  const kept = new (rows.constructor as new (length: number) => Rows)(width * most);
  for (let i = 0; i < most; ++i) {
    const from = width * Math.floor((i * count) / most);
    for (let k = 0; k < width; ++k) kept[width * i + k] = rows[from + k];
  }
  return kept;
}

/**
 * Fewer triangles of about the same surface: vertices that share a cell of a grid become one of them. If that leaves
 * little, as of a cloud of small objects, or too much, some triangles are taken in place of all.
 */
export function coarse(faces: Uint32Array, objects: Int32Array, positions: Float32Array): Uint32Array {
  if (faces.length <= 3 * kDraftTriangles) return faces;
  const kCells = 80;
  const first = new Map<number, number>();
  const joined = new Uint32Array(objects.length);
  for (let v = 0; v < joined.length; ++v) {
    let cell = objects[v];
    for (let axis = 0; axis < 3; ++axis)
      cell = cell * kCells + Math.floor((positions[3 * v + axis] + 1) * (kCells / 2));
    const known = first.get(cell);
    if (known === undefined) first.set(cell, v);
    joined[v] = known ?? v;
  }
  const left = new Uint32Array(faces.length);
  let count = 0;
  for (let f = 0; f < faces.length; f += 3) {
    const a = joined[faces[f]];
    const b = joined[faces[f + 1]];
    const c = joined[faces[f + 2]];
    if (a === b || b === c || c === a) continue;
    left[count++] = a;
    left[count++] = b;
    left[count++] = c;
  }
  const isEnough = count > 3 * 0.2 * kDraftTriangles;
  return thinned<Uint32Array>(isEnough ? left.subarray(0, count) : faces, 3, kDraftTriangles);
}

/** Returns whether drawing the scene takes noticeable time where the processor draws. */
export function isLarge(world: Object3D): boolean {
  const price = ({ object, isInstanced }: Leaf): number =>
    isInstanced ? kSegmentPrice : object instanceof Points ? kPointPrice : 1;
  return leavesOf(world).reduce((sum, leaf) => sum + leaf.count * price(leaf), 0) > kLarge;
}

/** An object of the scene that is drawn, and how many vertices are processed for it. */
interface Leaf {
  object: Object3D & { geometry: BufferGeometry };
  count: number;
  isInstanced: boolean;
}

function leavesOf(object: Object3D): Leaf[] {
  if (!object.visible) return [];
  const isDrawn = object instanceof Mesh || object instanceof Points || object instanceof LineSegments;
  if (!isDrawn) return object.children.flatMap(leavesOf);
  const geometry = object.geometry as BufferGeometry;
  const { instanceCount } = geometry as InstancedBufferGeometry;
  const isInstanced = "instanceCount" in geometry;
  const count = geometry.index?.count ?? (geometry.attributes.position as { count: number } | undefined)?.count ?? 0;
  const leaf = {
    object: object as unknown as Leaf["object"],
    count: isInstanced ? count * instanceCount : count,
    isInstanced,
  };
  return leaf.count > 0 ? [leaf] : [];
}

/** Draws a scene in slices, each when the one before is finished, and may be stopped between them. */
export class Slices {
  private stopped = false;

  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly world: Scene,
    private readonly camera: Camera,
  ) {}

  stop(): void {
    this.stopped = true;
  }

  /** Returns whether the picture was finished. */
  async draw(): Promise<boolean> {
    const leaves = leavesOf(this.world).sort((a, b) => orderOf(a) - orderOf(b));
    this.renderer.clear();
    for (const leaf of leaves)
      for (let from = 0; from < leaf.count; from += leaf.isInstanced ? leaf.count : kSlice) {
        this.drawOne(leaves, leaf, from);
        await this.finished();
        if (this.stopped) return false;
      }
    return true;
  }

  private drawOne(leaves: Leaf[], { object, isInstanced }: Leaf, from: number): void {
    for (const leaf of leaves) leaf.object.visible = leaf.object === object;
    if (!isInstanced) object.geometry.setDrawRange(from, kSlice);
    this.renderer.autoClear = false;
    this.renderer.render(this.world, this.camera);
    this.renderer.autoClear = true;
    if (!isInstanced) object.geometry.setDrawRange(0, Infinity);
    for (const leaf of leaves) leaf.object.visible = true;
  }

  /** Waits until the drawing is done: what is asked for meanwhile would wait behind it. */
  private async finished(): Promise<void> {
    const gl = this.renderer.getContext() as WebGL2RenderingContext;
    const done = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    do await new Promise((later) => setTimeout(later, 4));
    while (done && !this.stopped && gl.getSyncParameter(done, gl.SYNC_STATUS) !== gl.SIGNALED);
    gl.deleteSync(done);
  }
}

/** As three.js draws: opaque objects first, then by their render order. */
function orderOf({ object }: Leaf): number {
  const { transparent } = (object as unknown as { material: { transparent: boolean } }).material;
  return (transparent ? 1000 : 0) + object.renderOrder;
}
