// The data to draw and list one step.
import { isIntersection } from "./proofs";
import type { Scene, Step } from "./scene";
import type { MarkData } from "../view3d/marks";

/** A time larger than any in the step, for vertices without contact. */
const kNever = 2;

export class StepView {
  readonly marks: MarkData;
  /** For each vertex the first time of its contacts. */
  readonly firstTouch: Float32Array;
  /** The contacts, sorted by time of impact. */
  readonly byTime: Uint32Array;

  /** `turned`: a view of the same step, with another axis upward; null if there is none. */
  constructor(
    readonly scene: Scene,
    readonly step: Step,
    turned: StepView | null,
  ) {
    this.marks = this.place();
    this.firstTouch = turned?.firstTouch ?? this.touches();
    this.byTime = turned?.byTime ?? this.sorted();
  }

  /** The first certified contact or intersection, a new one if there is one; -1 if there are none. */
  get firstContact(): number {
    const { contacts } = this.scene;
    const certain = this.byTime.filter((i) => !contacts.isUnresolved(i));
    return [certain.find((i) => contacts.isNew(i)), certain[0], this.byTime[0]].find((i) => i !== undefined) ?? -1;
  }

  /** The contact with the earliest bracket; -1 if there are none. Intersections end no step. */
  get limiting(): number {
    return this.byTime.find((i) => !isIntersection(this.scene.contacts, i)) ?? -1;
  }

  private sorted(): Uint32Array {
    const { toiLower } = this.scene.contacts;
    const contacts = new Uint32Array(this.step.count).map((_, i) => this.step.first + i);
    return contacts.sort((a, b) => toiLower[a] - toiLower[b] || a - b);
  }

  private place(): MarkData {
    const { scene, step } = this;
    const { contacts } = scene;
    const start = new Float32Array(3 * step.count);
    const end = new Float32Array(3 * step.count);
    const toi = new Float32Array(step.count);
    const unresolved = new Float32Array(step.count);
    for (let k = 0; k < step.count; ++k) {
      const i = step.first + k;
      // The first feature is a vertex or an edge.
      const isEdge = contacts.kindOf(i).first === 2;
      const along = isEdge ? contacts.storedWeight(i, 0) : 0;
      const a = 3 * contacts.vertex(i, 0);
      const b = isEdge ? 3 * contacts.vertex(i, 1) : a;
      for (let axis = 0; axis < 3; ++axis) {
        start[3 * k + axis] = (1 - along) * step.start[a + axis] + along * step.start[b + axis];
        end[3 * k + axis] = (1 - along) * step.end[a + axis] + along * step.end[b + axis];
      }
      toi[k] = contacts.toiLower[i];
      unresolved[k] = contacts.isUnresolved(i) ? 1 : 0;
    }
    return { start, end, toi, unresolved };
  }

  private touches(): Float32Array {
    const { scene, step } = this;
    const { contacts } = scene;
    const first = new Float32Array(scene.header.mesh.vertices).fill(kNever);
    for (let i = step.first; i < step.first + step.count; ++i) {
      const { first: a, second: b } = contacts.kindOf(i);
      for (let k = 0; k < a + b; ++k) {
        const v = contacts.vertex(i, k);
        first[v] = Math.min(first[v], contacts.toiLower[i]);
      }
    }
    return first;
  }
}
