// Objects that follow from the state: the step that is shown, the listed contacts, the selected pair.
import { Pair } from "./scene/pair";
import { listed } from "./scene/filter";
import type { Scene } from "./scene/scene";
import { StepView } from "./scene/step_view";
import type { Key, Store } from "./store";
import { thinned } from "./view3d/large";

/** More marks hide each other, and a page with more does not answer. */
export const kMostMarks = 150_000;

export const kFilterKeys: Key[] = [
  "step",
  "up",
  "brush",
  "kind",
  "object",
  "vertex",
  "unresolvedOnly",
  "newOnly",
  "sort",
  "descending",
];

export class Session {
  view: StepView;
  /** The listed contacts, in the order of the list. */
  rows: Uint32Array = new Uint32Array();
  /** The listed contacts that are drawn: all, or at equal distances in the list as many as can be told apart. */
  drawn: Uint32Array = new Uint32Array();
  pair: Pair | null = null;

  constructor(
    readonly scene: Scene,
    readonly store: Store,
  ) {
    this.view = new StepView(scene, scene.step(store.now.step), null);
    store.follow(["step", "up"], () => {
      const { step, up } = store.now;
      if (this.view.step.index === step && scene.up === up) return;
      scene.up = up;
      this.view = new StepView(scene, scene.step(step), this.view.step.index === step ? this.view : null);
    });
    store.follow(kFilterKeys, () => {
      this.refilter();
    });
    store.follow(["step", "up", "selected"], () => {
      const { selected } = store.now;
      const { first, count } = this.view.step;
      const isHere = selected >= first && selected < first + count;
      this.pair = isHere ? new Pair(scene, this.view.step, selected) : null;
    });
  }

  /** Shows a step at its end, where all that was found in it is seen; only playing shows it from its start. */
  showStep(step: number, time = 1): void {
    const kept = Math.min(Math.max(step, 0), this.scene.stepCount - 1);
    if (kept !== this.store.now.step)
      this.store.set({ step: kept, selected: -1, isolated: false, brush: [0, 1], loop: [0, 1], time });
  }

  /** Selects a contact and shows it alone, at its time. */
  select(contact: number): void {
    if (contact < 0) return;
    const pair = new Pair(this.scene, this.view.step, contact);
    this.store.set({
      selected: contact,
      isolated: true,
      time: pair.toi,
      loop: [pair.before, pair.after],
      playing: false,
      panel: "pair",
      panelOpen: true,
    });
  }

  deselect(): void {
    this.store.set({ selected: -1, isolated: false, loop: [0, 1], panel: "contacts" });
  }

  /** Selects the next contact of the list (1) or the previous one (-1). */
  move(by: number): void {
    if (this.rows.length === 0) return;
    const place = this.rows.indexOf(this.store.now.selected);
    const next = place < 0 ? 0 : Math.min(Math.max(place + by, 0), this.rows.length - 1);
    this.select(this.rows[next]);
  }

  private refilter(): void {
    this.rows = listed(this.view, this.store.now);
    // In the order of contacts, so that a mark hides the same others however the list is sorted.
    this.drawn = thinned(this.rows, 1, kMostMarks).slice().sort();
  }
}
