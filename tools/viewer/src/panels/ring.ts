// A ring by which a contact is found from afar: around the selected one, else around the first one of the step.
import { el } from "../dom";
import { nounOf } from "../scene/header";
import { Pair } from "../scene/pair";
import type { Session } from "../session";
import type { Stage } from "../view3d/stage";

export class Ring {
  readonly element = el("div", { class: "ring", "aria-hidden": true });
  private first: Pair | null = null;

  constructor(session: Session, stage: Stage) {
    const label = el("span", {}, `first ${nounOf(session.scene.header)}`);
    this.element.append(label);
    session.store.follow(["step", "up"], () => {
      const { view, scene } = session;
      this.first = view.firstContact < 0 ? null : new Pair(scene, view.step, view.firstContact);
    });
    stage.drawn.push(() => {
      const { store } = session;
      const pair = session.pair ?? (store.now.marks ? this.first : null);
      this.element.dataset.first = String(pair === this.first && pair !== null);
      const place = pair && !store.now.isolated ? pair.firstPoint(store.now.time) : null;
      // From near, a selected pair itself is seen.
      const isNear = place !== null && pair !== this.first && pair!.size * stage.pixelsAt(place) >= 40;
      const seen = place && !isNear ? stage.project(place) : null;
      this.element.hidden = seen === null;
      if (seen) this.element.style.transform = `translate(${seen.x}px, ${seen.y}px)`;
    });
  }
}
