// The data to draw and list one step.
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

  constructor(
    readonly scene: Scene,
    readonly step: Step,
  ) {
    this.marks = this.place();
    this.firstTouch = this.touches();
    const { toiLower } = scene.contacts;
    this.byTime = new Uint32Array(step.count).map((_, i) => step.first + i);
    this.byTime.sort((a, b) => toiLower[a] - toiLower[b] || a - b);
  }

  /** The first certified contact, or if there is none the first of all; -1 if there are none. */
  get firstContact(): number {
    const certain = this.byTime.find((i) => !this.scene.contacts.isUnresolved(i));
    return certain ?? this.limiting;
  }

  /** The contact with the earliest bracket, before which no pair touches; -1 if there are none. */
  get limiting(): number {
    return this.byTime.length > 0 ? this.byTime[0] : -1;
  }

  private place(): MarkData {
    const { scene, step } = this;
    const { contacts } = scene;
    const start = new Float32Array(3 * step.count);
    const end = new Float32Array(3 * step.count);
    const toi = new Float32Array(step.count);
    const flags = new Float32Array(step.count);
    for (let k = 0; k < step.count; ++k) {
      const i = step.first + k;
      const weights = contacts.firstWeights(i);
      for (let w = 0; w < weights.length; ++w) {
        const v = 3 * contacts.vertex(i, w);
        for (let axis = 0; axis < 3; ++axis) {
          start[3 * k + axis] += weights[w] * step.start[v + axis];
          end[3 * k + axis] += weights[w] * step.end[v + axis];
        }
      }
      toi[k] = contacts.toiLower[i];
      flags[k] = contacts.isUnresolved(i) ? 1 : 0;
    }
    return { start, end, toi, flags };
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
