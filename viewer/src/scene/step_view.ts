// One step made ready to be drawn and listed.
import type { Scene, Step } from "./scene";
import type { MarkData } from "../view3d/marks";

/** Larger than any time: in no contact. */
const kNever = 2;

export class StepView {
  readonly marks: MarkData;
  /** For each vertex the first time of a contact it takes part in. */
  readonly firstTouch: Float32Array;
  /** Contacts by their time of impact. */
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

  /** The first contact that is certain, or the first of all. */
  get firstContact(): number {
    const certain = this.byTime.find((i) => !this.scene.contacts.isUnresolved(i));
    return certain ?? this.limiting;
  }

  /** Before its bracket nothing touches; -1 if the step is free. */
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
