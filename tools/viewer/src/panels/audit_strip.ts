// The strip of an audit's frames: bad frames stand out, and a click shows the frame at its place.
import { button, Drawing, el, themed } from "../dom";
import { counted, grouped } from "../numbers";
import { badFrames, isBad, newFrames, type Strip } from "../scene/header";
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
  const named = `frame ${frame}, ${strip.names[frame]}: `;
  const problem = strip.problems[frame];
  if (problem !== undefined) return `${named}not asked about: ${problem}`;
  const found = strip.collapsed[frame] ? ["an object has collapsed"] : [];
  if (strip.asks_intersections) found.push(counted(strip.intersections[frame], "intersection"));
  if (strip.has_step[frame]) found.push(counted(strip.contacts[frame], "contact"));
  if (strip.fresh[frame] > 0) found.push(`${grouped(strip.fresh[frame])} of them new since the frame before`);
  const absent = strip.steps[frame] < 0 ? "; its shape is not in this page" : "";
  return named + (found.join(", ") || "nothing was asked about it") + absent;
}

/** The colour of a frame's line: not asked about, collapsed, asked about and free, and the rest. */
function lineOf(strip: Strip, frame: number): string {
  if (strip.problems[frame] !== undefined) return "--first";
  if (strip.collapsed[frame]) return "--second";
  const isAsked = strip.asks_intersections || strip.has_step[frame];
  if (isAsked && !isBad(strip, frame)) return "--free";
  return "--line";
}

/** Draws bars from the middle: for each frame its intersections upward, the contacts of the step to it downward. */
function drawBars(context: CanvasRenderingContext2D, strip: Strip, width: number, height: number): void {
  const wide = width / strip.steps.length;
  const middle = Math.round(height / 2);
  const bars = (counts: number[], colour: string, upward: boolean): void => {
    const most = counts.reduce((a, b) => Math.max(a, b), 1);
    context.globalAlpha = 1;
    context.fillStyle = colour;
    counts.forEach((count, i) => {
      if (count === 0) return;
      const high = Math.max(3, Math.sqrt(count / most) * (middle - 3));
      context.fillRect(i * wide, upward ? middle - 1 - high : middle + 2, Math.max(wide - 1, 1.5), high);
    });
  };
  const colours = Object.fromEntries(["--free", "--line", "--first", "--second"].map((name) => [name, themed(name)]));
  strip.steps.forEach((step, i) => {
    context.fillStyle = colours[lineOf(strip, i)];
    context.globalAlpha = step < 0 ? 0.45 : 1;
    context.fillRect(i * wide, middle - 1, Math.max(wide - 1, 1), 3);
  });
  bars(strip.intersections, themed("--second"), true);
  bars(strip.contacts, themed("--accent"), false);
  // Frames with new pairs are marked at the lower edge.
  context.fillStyle = themed("--ink");
  strip.fresh.forEach((count, i) => {
    if (count > 0) context.fillRect(i * wide, height - 3, Math.max(wide - 1, 2), 3);
  });
}

/** A button that shows the next of some frames; after the last one the first. */
function nextButton(session: Session, strip: Strip, frames: number[], label: string, title: string): HTMLElement {
  const show = (): void => {
    const now = frameOf(strip, session.store.now.step);
    session.showStep(strip.steps[frames.find((frame) => frame > now) ?? frames[0]]);
  };
  return button(label, title, show, { class: "next-bad", id: `next-${label}`, disabled: frames.length === 0 });
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
  const buttons = el(
    "div",
    { class: "next-frames" },
    nextButton(
      session,
      strip,
      badFrames(strip),
      "bad",
      "Next frame with an intersection, a contact or a collapsed object",
    ),
    nextButton(session, strip, newFrames(strip), "new", "Next frame with a pair that the frame before does not have"),
  );
  return [buttons, el("div", { class: "lane" }, drawing.canvas), readout];
}
