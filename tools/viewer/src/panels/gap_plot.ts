// Plots the pair's gap along the normal over the step, with the bracket magnified below.
import { colourOfTime, css } from "../colours";
import { Drawing, el, themed } from "../dom";
import { scientific } from "../numbers";
import type { Pair } from "../scene/pair";
import { bracketWords } from "../scene/proofs";
import type { Session } from "../session";

const kSamples = 160;

export class GapPlot {
  readonly element = el("figure", { class: "gap" });
  private readonly plot: Drawing;
  private readonly bracket: Drawing;
  private readonly caption = el("figcaption");

  constructor(private readonly session: Session) {
    this.plot = new Drawing({ class: "gap-plot", role: "img", "aria-label": "Gap over time" }, (context, w, h) => {
      if (session.pair) this.drawPlot(session.pair, context, w, h);
    });
    this.bracket = new Drawing({ class: "bracket", role: "img", "aria-label": "Bracket" }, (context, w, h) => {
      if (session.pair) drawBracket(session, session.pair, context, w, h);
    });
    this.plot.canvas.addEventListener("click", (event) => {
      const { left, width } = this.plot.canvas.getBoundingClientRect();
      session.store.set({ time: (event.clientX - left) / width, playing: false });
    });
    this.element.append(this.plot.canvas, this.bracket.canvas, this.caption);
    session.store.follow(["selected", "time", "theme", "panel"], () => {
      this.plot.refresh();
      this.bracket.refresh();
      const { pair } = session;
      if (!pair) return;
      const width = pair.toiUpper - pair.toiLower;
      this.caption.textContent =
        width > 0
          ? `The bracket, magnified ${scientific(0.4 / width)} times: ${scientific(width)} of the step wide.`
          : "The bracket is a single double.";
    });
  }

  private drawPlot(pair: Pair, context: CanvasRenderingContext2D, width: number, height: number): void {
    const sign = pair.gap(0) < 0 ? -1 : 1;
    const gaps = Array.from({ length: kSamples + 1 }, (_, i) => sign * pair.gap(i / kSamples));
    const most = Math.max(...gaps.map(Math.abs), Number.MIN_VALUE);
    const y = (gap: number): number => height / 2 - (gap / most) * (height / 2 - 6);
    context.fillStyle = themed("--free-soft");
    context.fillRect(0, 0, pair.toiLower * width, height);
    context.strokeStyle = themed("--line");
    context.beginPath();
    context.moveTo(0, height / 2);
    context.lineTo(width, height / 2);
    context.stroke();
    context.strokeStyle = themed("--ink");
    context.lineWidth = 1.5;
    context.beginPath();
    gaps.forEach((gap, i) => {
      const x = (i / kSamples) * width;
      if (i === 0) context.moveTo(x, y(gap));
      else context.lineTo(x, y(gap));
    });
    context.stroke();
    context.fillStyle = css(colourOfTime(pair.toi));
    context.beginPath();
    context.arc(pair.toi * width, height / 2, 4.5, 0, 2 * Math.PI);
    context.fill();
    context.fillStyle = themed("--ink");
    context.fillRect(this.session.store.now.time * width - 0.5, 0, 1, height);
    context.font = "11px system-ui, sans-serif";
    context.fillStyle = themed("--quiet");
    context.fillText("gap along the normal", 6, height - 6);
  }
}

/** Draws the bracket over two fifths of the width, the time before and after it over the rest. */
function drawBracket(
  { scene }: Session,
  pair: Pair,
  context: CanvasRenderingContext2D,
  width: number,
  height: number,
): void {
  const [low, high] = [0.3 * width, 0.7 * width];
  const top = 16;
  const middle = pair.toi * width;
  context.fillStyle = themed("--line");
  context.beginPath();
  context.moveTo(middle, 0);
  context.lineTo(high, top);
  context.lineTo(low, top);
  context.fill();
  context.fillStyle = themed("--free-soft");
  context.fillRect(0, top, low, height - top);
  context.fillStyle = css(colourOfTime(pair.toi));
  context.fillRect(low, top, high - low, height - top);
  context.font = "600 11px system-ui, sans-serif";
  context.textBaseline = "middle";
  context.textAlign = "center";
  const y = top + (height - top) / 2;
  context.fillStyle = themed("--ink");
  const [before, within, after] = bracketWords(scene.header, scene.contacts, pair.index);
  context.fillText(before, low / 2, y);
  context.fillText(after, (high + width) / 2, y);
  context.fillStyle = pair.toi > 0.55 ? "#fff" : "#111";
  context.fillText(within, (low + high) / 2, y);
}
