// The histogram of times of impact: bars in the colours of time, and a brush over them.
import { colourOfTime, css } from "../colours";
import { Drawing, themed } from "../dom";
import { isIntersection } from "../scene/proofs";
import type { Session } from "../session";

const kBins = 120;

export class Histogram {
  readonly element: HTMLCanvasElement;
  private readonly drawing: Drawing;
  private counts: number[] = [];
  private dragFrom: number | null = null;

  constructor(private readonly session: Session) {
    this.drawing = new Drawing(
      {
        class: "histogram",
        role: "img",
        "aria-label": "Contacts over the time of the step; drag to keep a part of it",
      },
      (context, width, height) => {
        this.draw(context, width, height);
      },
    );
    this.element = this.drawing.canvas;
    this.listen();
    session.store.follow(["step"], () => {
      this.count();
    });
    session.store.follow(["step", "brush", "time", "theme"], () => {
      this.drawing.refresh();
    });
  }

  private count(): void {
    this.counts = new Array<number>(kBins).fill(0);
    const { contacts } = this.session.scene;
    const { toiLower } = contacts;
    // Intersections are of the frame, and have no time in the step.
    for (const i of this.session.view.byTime)
      if (!isIntersection(contacts, i)) ++this.counts[Math.min(Math.floor(toiLower[i] * kBins), kBins - 1)];
  }

  private timeAt(event: PointerEvent): number {
    const { left, width } = this.element.getBoundingClientRect();
    return Math.min(Math.max((event.clientX - left) / width, 0), 1);
  }

  private listen(): void {
    const { store } = this.session;
    this.element.addEventListener("pointerdown", (event) => {
      this.dragFrom = this.timeAt(event);
      this.element.setPointerCapture(event.pointerId);
    });
    this.element.addEventListener("pointermove", (event) => {
      if (this.dragFrom === null) return;
      const to = this.timeAt(event);
      if (Math.abs(to - this.dragFrom) > 0.004)
        store.set({ brush: [Math.min(this.dragFrom, to), Math.max(this.dragFrom, to)] });
    });
    this.element.addEventListener("pointerup", (event) => {
      // A click without a drag sets the time, and widens the brush to the whole step.
      if (this.dragFrom !== null && Math.abs(this.timeAt(event) - this.dragFrom) <= 0.004)
        store.set({ time: this.timeAt(event), brush: [0, 1], playing: false });
      this.dragFrom = null;
    });
  }

  private draw(context: CanvasRenderingContext2D, width: number, height: number): void {
    const { brush, time } = this.session.store.now;
    const most = Math.max(1, ...this.counts);
    const bar = width / kBins;
    this.counts.forEach((count, i) => {
      if (count === 0) return;
      const middle = (i + 0.5) / kBins;
      const inBrush = (i + 1) / kBins > brush[0] && i / kBins < brush[1];
      // Heights are square roots, so that single contacts are visible beside thousands.
      const high = Math.max(2, Math.sqrt(count / most) * (height - 6));
      context.globalAlpha = inBrush ? (middle <= time ? 1 : 0.55) : 0.15;
      context.fillStyle = css(colourOfTime(middle));
      context.fillRect(i * bar + 0.5, height - high, Math.max(bar - 1, 1), high);
    });
    context.globalAlpha = 1;
    if (brush[0] > 0 || brush[1] < 1) {
      context.strokeStyle = themed("--accent");
      context.lineWidth = 1.5;
      context.strokeRect(brush[0] * width + 1, 1, Math.max((brush[1] - brush[0]) * width - 2, 2), height - 2);
    }
    context.fillStyle = themed("--ink");
    context.fillRect(Math.round(time * width) - 1, 0, 2, height);
  }
}
