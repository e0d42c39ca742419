// The sieve true to scale: areas are numbers of pairs. The pairs that the first stage leaves are drawn again, larger.
import { Drawing, themed } from "../dom";
import { inWords } from "../numbers";

/** Colours of the pairs that are left, from the first stage to the contacts. */
export function stageColour(place: number, stages: number): string {
  if (place === 0) return themed("--stage-all");
  if (place === stages - 1) return themed("--stage-contacts");
  const part = (place - 1) / Math.max(stages - 3, 1);
  return `color-mix(in oklab, ${themed("--stage-last")} ${Math.round(100 * part)}%, ${themed("--stage-first")})`;
}

export class SievePicture {
  readonly canvas: HTMLCanvasElement;
  private readonly drawing: Drawing;
  private totals: number[] = [];

  constructor() {
    const label = "All pairs as a square, and the small part of it that each stage leaves";
    this.drawing = new Drawing(
      { class: "sieve-picture", role: "img", "aria-label": label },
      (context, width, height) => {
        this.draw(context, width, height);
      },
    );
    this.canvas = this.drawing.canvas;
  }

  /** The numbers of pairs that enter each stage; the contacts last. */
  show(totals: number[]): void {
    this.totals = totals;
    this.drawing.refresh();
  }

  private draw(context: CanvasRenderingContext2D, width: number, height: number): void {
    const [all, first] = this.totals;
    if (!all) return;
    const side = Math.min(height - 22, (width - 26) / 2);
    const square = (x: number, size: number, place: number): void => {
      context.fillStyle = stageColour(place, this.totals.length);
      context.fillRect(x, side - size, size, size);
    };
    square(0, side, 0);
    const seen = Math.max(side * Math.sqrt(first / all), first > 0 ? 1.5 : 0);
    square(0, seen, this.totals.length - 1);
    const right = width - side;
    context.strokeStyle = themed("--stage-contacts");
    context.globalAlpha = 0.6;
    context.beginPath();
    context.moveTo(seen, side - seen);
    context.lineTo(right, 0);
    context.moveTo(seen, side);
    context.lineTo(right, side);
    context.stroke();
    context.globalAlpha = 1;
    this.totals.forEach((total, place) => {
      if (place > 0 && first > 0) square(right, side * Math.sqrt(total / first), place);
    });
    context.font = "12px system-ui, sans-serif";
    context.fillStyle = themed("--quiet");
    context.fillText("all pairs", 0, side + 16);
    context.textAlign = "right";
    const times = first > 0 ? `the orange corner, ${inWords(all / first)} times as large` : "nothing is left";
    context.fillText(times, width, side + 16);
  }
}
