// The mesh, its frames, and the contacts of each step between two frames; or a single frame with its intersections, as
// a step without motion.
import { Contacts } from "./contacts";
import { counted } from "../numbers";
import type { Say } from "../panels/opening";
import { endsOf, nounOf, type SceneHeader, type StepHeader } from "./header";
import { Objects } from "./objects";
import type { SceneFile } from "./scene_file";
import type { Up } from "../store";
import type { Vec3 } from "../vectors";

/** Coordinates of the drawing: the longest side of the box around all frames is 2, its middle the origin. */
const kGridCells = 2 ** 24 - 1;

export interface Step {
  index: number;
  header: StepHeader;
  /** Its contacts are first .. first + count. */
  first: number;
  count: number;
  /** Three coordinates a vertex, those of the drawing. */
  start: Float32Array;
  end: Float32Array;
}

export class Scene {
  /** The axis of the mesh that points up in the drawing. */
  up: Up = "y";
  readonly header: SceneHeader;
  readonly faces: Uint32Array;
  readonly rods: Uint32Array;
  readonly loosePoints: Uint32Array;
  /** -1: no feature uses the vertex. */
  readonly objectOfVertex: Int32Array;
  readonly objects: Objects;
  private readonly frames: Uint32Array[];
  private readonly centre: [number, number, number];
  private readonly firstOfStep: number[] = [0];

  private constructor(
    file: SceneFile,
    readonly contacts: Contacts,
  ) {
    this.header = file.header;
    this.faces = file.integers("faces", 3);
    this.rods = file.integers("rods", 2);
    this.loosePoints = file.integers("loose_points", 1);
    this.objectOfVertex = new Int32Array(file.integers("object_of_vertex", 1).buffer);
    this.objects = new Objects(this.objectOfVertex, this.header.mesh.names);
    this.frames = file.frames();
    this.centre = this.middle();
    this.up = this.guessUp();
    for (const step of this.header.steps) {
      this.firstOfStep.push(this.firstOfStep[this.firstOfStep.length - 1] + contactsOf(step));
    }
  }

  static async read(file: SceneFile, say: Say): Promise<Scene> {
    const { steps, mesh } = file.header;
    const pairs = steps.reduce((sum, step) => sum + contactsOf(step), 0);
    await say(`Unpacking ${counted(pairs, nounOf(file.header))}`, 0.4);
    const contacts = new Contacts(file);
    await say(`Unpacking ${counted(mesh.faces, "triangle")}`, 0.5);
    return new Scene(file, contacts);
  }

  get stepCount(): number {
    return this.header.steps.length;
  }

  /** The length of the mesh's unit in the drawing. */
  get unit(): number {
    return 2 / (kGridCells * this.header.grid.spacing);
  }

  step(index: number): Step {
    const first = this.firstOfStep[index];
    const [start, end] = this.positions(index);
    return { index, header: this.header.steps[index], first, count: this.firstOfStep[index + 1] - first, start, end };
  }

  /** A direction of the mesh in the drawing's coordinates: turned about x if z is up. */
  direction([x, y, z]: Vec3): Vec3 {
    return this.up === "y" ? [x, y, z] : [x, z, -y];
  }

  private positions(index: number): [Float32Array, Float32Array] {
    const [from, to] = endsOf(this.header, index).map((frame) => this.frames[frame]);
    const start = new Float32Array(from.length);
    const end = new Float32Array(from.length);
    const { scale } = this.header;
    // Without an array for each vertex, of which there may be millions.
    for (let axis = 0; axis < 3; ++axis) {
      const centre = this.centre[axis];
      const unit = this.direction([0, 1, 2].map((a) => (a === axis ? 1 : 0)) as Vec3);
      const place = unit.findIndex((x) => x !== 0);
      const factor = (2 * unit[place]) / kGridCells;
      for (let v = 0; v < from.length; v += 3) {
        const x = from[v + axis];
        start[v + place] = factor * (x - centre);
        end[v + place] = factor * (x + scale * (to[v + axis] - x) - centre);
      }
    }
    return [start, end];
  }

  /** The axis that points up: z if a floor (a flat object without motion) lies across z and none across y, else y. */
  private guessUp(): Up {
    const [first, second = first] = this.frames;
    const { numbers } = this.objects;
    const places = new Map(numbers.map((object, place) => [object, place]));
    const low = new Float64Array(3 * numbers.length).fill(Infinity);
    const high = new Float64Array(3 * numbers.length).fill(-Infinity);
    const moves = new Uint8Array(numbers.length);
    this.objectOfVertex.forEach((number, v) => {
      const object = places.get(number);
      if (object === undefined) return;
      for (let axis = 0; axis < 3; ++axis) {
        const x = first[3 * v + axis];
        low[3 * object + axis] = Math.min(low[3 * object + axis], x);
        high[3 * object + axis] = Math.max(high[3 * object + axis], x);
        if (second[3 * v + axis] !== x) moves[object] = 1;
      }
    });
    const isFloor = (object: number, axis: number): boolean => {
      const size = (of: number): number => high[3 * object + of] - low[3 * object + of];
      const other = axis === 2 ? 1 : 2;
      return !moves[object] && size(axis) < 1e-3 * Math.min(size(0), size(other));
    };
    const all = numbers.map((_, place) => place);
    return !all.some((object) => isFloor(object, 1)) && all.some((object) => isFloor(object, 2)) ? "z" : "y";
  }

  private middle(): [number, number, number] {
    const highest = [0, 0, 0];
    for (const frame of this.frames)
      for (let i = 0; i < frame.length; ++i) highest[i % 3] = Math.max(highest[i % 3], frame[i]);
    return [highest[0] / 2, highest[1] / 2, highest[2] / 2];
  }
}

export function contactsOf(step: StepHeader): number {
  return Object.entries(step.contacts).reduce((sum, [kind, count]) => (kind === "unresolved" ? sum : sum + count), 0);
}
