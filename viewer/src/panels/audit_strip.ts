// The strip of an audit's frames: bad frames stand out, and a click shows the frame at its place.
import { button, Drawing, el, themed } from "../dom";
import { counted } from "../numbers";
import { holdsBad, type Strip } from "../scene/header";
import type { Session } from "../session";

/** The number of the frame at which a step of the scene ends. */
const frameOf = (strip: Strip, step: number): number => strip.steps.indexOf(step);

/** The frame nearest to `frame` that the scene holds. */
function nearestShown(strip: Strip, frame: number): number {
  let nearest = -1;
  strip.steps.forEach((step, i) => {
    if (step >= 0 && (nearest < 0 || Math.abs(i - frame) < Math.abs(nearest - frame))) nearest = i;
  });
  return nearest;
}

function describe(strip: Strip, frame: number): string {
  const found = [counted(strip.intersections[frame], "intersection"), counted(strip.contacts[frame], "contact")];
  const absent = strip.steps[frame] < 0 ? "; its shape is not in this page" : "";
  return `frame ${frame}, ${strip.names[frame]}: ${found.join(", ")}${absent}`;
}

/** Draws bars from the middle: for each frame its intersections upward, the contacts of the step to it downward. */
function drawBars(context: CanvasRenderingContext2D, strip: Strip, width: number, height: number): void {
  const wide = width / strip.steps.length;
  const middle = Math.round(height / 2);
  const bars = (counts: number[], colour: string, upward: boolean): void => {
    const most = counts.reduce((a, b) => Math.max(a, b), 1);
    context.fillStyle = colour;
    counts.forEach((count, i) => {
      if (count === 0) return;
      const high = Math.max(3, Math.sqrt(count / most) * (middle - 3));
      context.fillRect(i * wide, upward ? middle - 1 - high : middle + 2, Math.max(wide - 1, 1.5), high);
    });
  };
  strip.steps.forEach((step, i) => {
    context.fillStyle = step < 0 ? themed("--line") : themed("--free");
    context.fillRect(i * wide, middle - 1, Math.max(wide - 1, 1), 3);
  });
  bars(strip.intersections, themed("--second"), true);
  bars(strip.contacts, themed("--accent"), false);
}

/** Shows the next bad frame that the scene holds; after the last one the first. */
function showNextBad(session: Session, strip: Strip): void {
  const now = frameOf(strip, session.store.now.step);
  const all = strip.steps.map((_, i) => i).filter((i) => holdsBad(strip, i));
  if (all.length > 0) session.showStep(strip.steps[all.find((i) => i > now) ?? all[0]]);
}

export function auditStrip(session: Session, strip: Strip): HTMLElement[] {
  const { store } = session;
  const drawing = new Drawing(
    { class: "strip", id: "strip", role: "img", "aria-label": "Frames" },
    (context, width, height) => {
      drawBars(context, strip, width, height);
      const wide = width / strip.steps.length;
      context.strokeStyle = themed("--ink");
      context.strokeRect(frameOf(strip, store.now.step) * wide - 0.5, 0.5, Math.max(wide, 3), height - 1);
    },
  );
  const frameAt = (event: MouseEvent): number => {
    const { left, width } = drawing.canvas.getBoundingClientRect();
    const frame = Math.floor(((event.clientX - left) / width) * strip.steps.length);
    return Math.min(Math.max(frame, 0), strip.steps.length - 1);
  };
  drawing.canvas.addEventListener("click", (event) => {
    session.showStep(strip.steps[nearestShown(strip, frameAt(event))]);
    store.set({ time: 1 });
  });
  drawing.canvas.addEventListener("pointermove", (event) => {
    drawing.canvas.title = describe(strip, frameAt(event));
  });
  const readout = el("output", { class: "readout", id: "step-readout" });
  store.follow(["step", "theme"], () => {
    const frame = frameOf(strip, store.now.step);
    readout.textContent = `frame ${frame} / ${strip.steps.length}`;
    readout.title = describe(strip, frame);
    drawing.refresh();
  });
  const next = button(
    "next",
    "Next bad frame",
    () => {
      showNextBad(session, strip);
      store.set({ time: 1 });
    },
    { class: "next-bad", id: "next-bad" },
  );
  next.disabled = !strip.steps.some((_, i) => holdsBad(strip, i));
  return [next, el("div", { class: "lane" }, drawing.canvas), readout];
}
