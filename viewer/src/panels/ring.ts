// A ring around the selected contact, by which it is found from afar.
import { el } from "../dom";
import type { Session } from "../session";
import type { Stage } from "../view3d/stage";

export class Ring {
  readonly element = el("div", { class: "ring", "aria-hidden": true });

  constructor(session: Session, stage: Stage) {
    stage.drawn.push(() => {
      const { pair, store } = session;
      const place = pair && !store.now.isolated ? pair.firstPoint(store.now.time) : null;
      // From near, the pair itself is seen.
      const isFar = place !== null && pair !== null && pair.size * stage.pixelsAt(place) < 40;
      const seen = isFar ? stage.project(place) : null;
      this.element.hidden = seen === null;
      if (seen) this.element.style.transform = `translate(${seen.x}px, ${seen.y}px)`;
    });
  }
}
