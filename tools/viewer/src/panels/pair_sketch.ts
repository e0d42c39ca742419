// A sketch of the pair alone at one time, seen along the plane of contact: the normal points up.
import { css, kFirstFeature, kSecondFeature, type Rgb } from "../colours";
import { Drawing, themed } from "../dom";
import type { Pair } from "../scene/pair";
import { add, cross, dot, subtract, times, type Vec3 } from "../vectors";

/** The view is from a little above the plane, so that a face does not look like a line. */
const kTilt = 0.42;

export class PairSketch {
  readonly canvas: HTMLCanvasElement;
  private readonly drawing: Drawing;
  private pair: Pair | null = null;
  private time = 0;

  constructor(label: string) {
    this.drawing = new Drawing({ class: "sketch", role: "img", "aria-label": label }, (context, width, height) => {
      this.draw(context, width, height);
    });
    this.canvas = this.drawing.canvas;
  }

  show(pair: Pair | null, time: number): void {
    this.pair = pair;
    this.time = time;
    this.drawing.refresh();
  }

  private draw(context: CanvasRenderingContext2D, width: number, height: number): void {
    const { pair, time } = this;
    if (!pair) return;
    const project = this.projection(pair, width, height);
    const fill = (feature: number[], colour: Rgb): void => {
      const corners = feature.map((v) => project(pair.at(v, time)));
      context.strokeStyle = context.fillStyle = css(colour);
      context.lineWidth = 2.5;
      context.lineJoin = "round";
      context.beginPath();
      corners.forEach(([x, y], i) => {
        if (i === 0) context.moveTo(x, y);
        else context.lineTo(x, y);
      });
      if (corners.length === 3) {
        context.closePath();
        context.globalAlpha = 0.35;
        context.fill();
        context.globalAlpha = 1;
      }
      if (corners.length > 1) context.stroke();
      for (const [x, y] of corners) dotAt(context, x, y, corners.length === 1 ? 5 : 2.5);
    };
    fill(pair.second, kSecondFeature);
    fill(pair.first, kFirstFeature);
    context.fillStyle = themed("--ink");
    const [x, y] = project(pair.secondPoint(time));
    dotAt(context, x, y, 2);
  }

  private projection(pair: Pair, width: number, height: number): (point: Vec3) => [number, number] {
    // Up is the side from which the first feature comes.
    const up = times(pair.gap(0) < 0 ? -1 : 1, pair.normal);
    const right = pair.tangent;
    const depth = cross(right, up);
    // The view moves with the contact, so that only the relative motion of the features is seen.
    const centre = times(0.5, add(pair.firstPoint(this.time), pair.secondPoint(this.time)));
    const scale = (0.46 * Math.min(width, 1.6 * height)) / pair.size;
    return (point) => {
      const from = subtract(point, centre);
      const high = Math.cos(kTilt) * dot(from, up) + Math.sin(kTilt) * dot(from, depth);
      return [width / 2 + scale * dot(from, right), height / 2 - scale * high];
    };
  }
}

function dotAt(context: CanvasRenderingContext2D, x: number, y: number, radius: number): void {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
}
