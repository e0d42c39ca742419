// The dock below the scene: play, the slider of time under the histogram, and the frames of a sequence.
import { button, Drawing, el, themed } from "../dom";
import { kStepsTitle } from "../scene/proofs";
import { contactsOf } from "../scene/scene";
import { counted, timeText } from "../numbers";
import type { Session } from "../session";
import { auditStrip } from "./audit_strip";
import { Histogram } from "./histogram";

export class Timeline {
  readonly element: HTMLElement;
  private readonly slider = el("input", {
    type: "range",
    id: "time",
    min: 0,
    max: 1,
    step: "any",
    "aria-label": "Time in the step",
  });
  private readonly readout = el("output", { class: "readout", id: "readout" });
  private readonly play: HTMLButtonElement;

  constructor(private readonly session: Session) {
    const { store } = session;
    this.play = button(
      "▶",
      "Play (Space)",
      () => {
        togglePlay(session);
      },
      { class: "play", id: "play" },
    );
    const step = el("div", { class: "lane" }, new Histogram(session).element, this.slider);
    this.element = el("section", { class: "dock", "aria-label": "Time" });
    if (session.scene.header.strip) this.element.append(...auditStrip(session, session.scene.header.strip));
    else if (session.scene.stepCount > 1) this.element.append(...sequence(session));
    this.element.append(this.play, step, this.readout);
    this.slider.addEventListener("input", () => {
      store.set({ time: Number(this.slider.value), playing: false });
    });
    store.follow(["time", "playing"], () => {
      this.refresh();
    });
  }

  private refresh(): void {
    const { time, playing } = this.session.store.now;
    this.slider.value = String(time);
    this.play.textContent = playing ? "❚❚" : "▶";
    this.play.setAttribute("aria-label", playing ? "Pause" : "Play");
    this.readout.textContent = `t = ${timeText(time)}`;
  }
}

export function togglePlay({ store }: Session): void {
  const { playing, time, loop } = store.now;
  const atEnd = time >= loop[1] - 1e-9;
  store.set({ playing: !playing, time: !playing && atEnd ? loop[0] : time });
}

/** A strip with contacts and free time of every step, a slider over it, and the present place. */
function sequence(session: Session): HTMLElement[] {
  const { store, scene } = session;
  const { steps, names } = scene.header;
  const most = Math.max(1, ...steps.map(contactsOf));
  const drawing = new Drawing({ class: "strip", role: "img", "aria-label": "Steps" }, (context, width, height) => {
    const wide = width / steps.length;
    steps.forEach((step, i) => {
      const count = contactsOf(step);
      context.globalAlpha = i === store.now.step ? 1 : 0.55;
      context.fillStyle = themed("--free");
      const free = step.toi_lower ?? 1;
      context.fillRect(i * wide + 1, height - 4, (wide - 2) * free, 4);
      context.fillStyle = themed("--accent");
      const high = count > 0 ? Math.max(2, Math.sqrt(count / most) * (height - 8)) : 0;
      context.fillRect(i * wide + 1, height - 6 - high, Math.max(wide - 2, 1), high);
    });
    context.globalAlpha = 1;
    context.strokeStyle = themed("--ink");
    context.strokeRect(store.now.step * wide + 0.5, 0.5, wide - 1, height - 1);
  });
  drawing.canvas.title = kStepsTitle;
  drawing.canvas.addEventListener("click", (event) => {
    const { left, width } = drawing.canvas.getBoundingClientRect();
    session.showStep(Math.floor(((event.clientX - left) / width) * steps.length));
  });
  const slider = el("input", {
    type: "range",
    id: "step",
    min: 0,
    max: steps.length - 1,
    step: 1,
    "aria-label": "Step of the sequence",
  });
  slider.addEventListener("input", () => {
    session.showStep(Number(slider.value));
  });
  const readout = el("output", { class: "readout", id: "step-readout" });
  store.follow(["step", "theme"], () => {
    const { step } = store.now;
    slider.value = String(step);
    readout.textContent = `step ${step + 1} / ${steps.length}`;
    readout.title = `${names[step]} → ${names[step + 1]}, ${counted(contactsOf(steps[step]), "contact")}`;
    drawing.refresh();
  });
  return [el("span", { class: "dock-label" }, "steps"), el("div", { class: "lane" }, drawing.canvas, slider), readout];
}
