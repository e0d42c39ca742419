// Draws the selected pair: both features filled, thick edges and vertices, their paths through the step, the normal.
import { BufferAttribute, BufferGeometry, DoubleSide, Group, Mesh, MeshBasicMaterial, Color } from "three";
import { kFirstFeature, kSecondFeature, type Rgb } from "../colours";
import type { Pair } from "../scene/pair";
import type { Theme } from "../store";
import { add, times, type Vec3 } from "../vectors";
import { emptySegments, Segments, type SegmentData } from "./segments";
import type { SharedUniforms } from "./shared";

const kInk: Record<Theme, Rgb> = { dark: [255, 255, 255], light: [16, 21, 29] };

interface Stroke {
  from: [Vec3, Vec3];
  to: [Vec3, Vec3];
  colour: Rgb;
  alpha: number;
}

function segments(strokes: Stroke[]): SegmentData {
  const data = emptySegments(strokes.length);
  strokes.forEach(({ from, to, colour, alpha }, i) => {
    data.fromStart.set(from[0], 3 * i);
    data.fromEnd.set(from[1], 3 * i);
    data.toStart.set(to[0], 3 * i);
    data.toEnd.set(to[1], 3 * i);
    // Converts to linear colours, with which the shader computes.
    data.colour.set([...colour.map((c) => Math.round(255 * (c / 255) ** 2.2)), alpha], 4 * i);
  });
  return data;
}

/** Adds a dot: a segment of length 0, drawn as wide as it is thick. */
const dotAt = (ends: [Vec3, Vec3], colour: Rgb): Stroke => ({ from: ends, to: ends, colour, alpha: 255 });

export class Pair3d extends Group {
  private readonly outline: Segments;
  private readonly behind: Segments;
  private readonly dots: Segments;
  private readonly point: Segments;
  private readonly trails: Segments;
  private readonly faces = new Group();
  private pair: Pair | null = null;

  constructor(shared: SharedUniforms) {
    super();
    this.behind = new Segments(shared, { width: 2, hidden: true, opacity: 0.5 });
    this.outline = new Segments(shared, { width: 2.4, nearness: 4e-4 });
    this.dots = new Segments(shared, { width: 4.5, hidden: true });
    this.point = new Segments(shared, { width: 2, hidden: true });
    this.trails = new Segments(shared, { width: 1, hidden: true });
    [this.trails, this.faces, this.behind, this.outline, this.dots, this.point].forEach((part, i) => {
      part.renderOrder = 10 + i;
      this.add(part);
    });
    this.visible = false;
  }

  show(pair: Pair | null, theme: Theme): void {
    this.pair = pair;
    this.visible = pair !== null;
    this.faces.clear();
    if (!pair) return;
    const ends = (v: number): [Vec3, Vec3] => [pair.at(v, 0), pair.at(v, 1)];
    const features: [number[], Rgb][] = [
      [pair.first, kFirstFeature],
      [pair.second, kSecondFeature],
    ];
    const edges = features.flatMap(([feature, colour]) =>
      pair.edgesOf(feature).map(([a, b]): Stroke => ({ from: ends(a), to: ends(b), colour, alpha: 255 })),
    );
    const vertices = features.flatMap(([feature, colour]) => feature.map((v) => dotAt(ends(v), colour)));
    const trails = features.flatMap(([feature, colour]) =>
      feature.map((v): Stroke => {
        const [start, end] = ends(v);
        return { from: [start, start], to: [end, end], colour, alpha: 150 };
      }),
    );
    const ink = kInk[theme];
    const point: [Vec3, Vec3] = [pair.firstPoint(0), pair.firstPoint(1)];
    const onSecond: [Vec3, Vec3] = [pair.secondPoint(0), pair.secondPoint(1)];
    const tip = (place: Vec3): Vec3 => add(place, times(0.45 * pair.size, pair.normal));
    const arrow: Stroke = { from: onSecond, to: [tip(onSecond[0]), tip(onSecond[1])], colour: ink, alpha: 230 };
    this.outline.show(segments([...edges, arrow]));
    this.behind.show(segments(edges));
    this.dots.show(segments(vertices));
    this.point.show(segments([dotAt(point, ink)]));
    this.trails.show(segments(trails));
    for (const [feature, colour] of features) if (feature.length === 3) this.faces.add(triangle(colour));
  }

  /** Moves the filled features. */
  moveTo(time: number): void {
    const { pair } = this;
    if (!pair) return;
    const filled = [pair.first, pair.second].filter((feature) => feature.length === 3);
    filled.forEach((feature, i) => {
      const mesh = this.faces.children[i] as Mesh;
      const position = mesh.geometry.getAttribute("position");
      feature.forEach((v, k) => position.setXYZ(k, ...pair.at(v, time)));
      position.needsUpdate = true;
    });
  }
}

function triangle(colour: Rgb): Mesh {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(9), 3));
  const material = new MeshBasicMaterial({
    color: new Color(css255(colour)),
    transparent: true,
    opacity: 0.45,
    side: DoubleSide,
    depthWrite: false,
  });
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  return mesh;
}

const css255 = (colour: Rgb): string => `rgb(${colour.join(",")})`;
