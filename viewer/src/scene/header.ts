// The JSON header of a scene: the keys are those of `tamis --json` where it has them.

export interface PairKind {
  name: string;
  /** Of the vertices of a pair, how many belong to the first feature and how many to the second. */
  first: number;
  second: number;
}

export interface Stage {
  name: string;
  vf: number;
  ee: number;
}

export interface StepHeader {
  contacts: Record<string, number>;
  /** Before this time the step is proven free; null: all of it is. */
  toi_lower: number | null;
  toi_upper: number | null;
  stages: Stage[];
  /** Of an audit: its start and its end among the frames, the same where no step leads to the frame. */
  ends?: [number, number];
}

/** All frames of an audited motion, of which the scene holds some. */
export interface Strip {
  names: string[];
  /** Of the step that ends there. */
  contacts: number[];
  intersections: number[];
  /** The scene's step that ends there; -1: the scene does not hold it. */
  steps: number[];
}

export interface SceneHeader {
  names: string[];
  scale: number;
  min_separation: number;
  kinds: PairKind[];
  steps: StepHeader[];
  mesh: { vertices: number; faces: number; edges: number; points: number; objects: number };
  grid: { lowest: [number, number, number]; spacing: number; error: number };
  columns: Record<string, { offset: number; count: number }>;
  /** Of an audit alone. */
  strip?: Strip;
}

/** Where a step begins and ends among the frames. */
export const endsOf = ({ steps, names }: SceneHeader, step: number): [number, number] =>
  steps[step].ends ?? [step, Math.min(step + 1, names.length - 1)];

/** What the frames of a step are called. */
export const namesOf = (header: SceneHeader, step: number): string[] =>
  [...new Set(endsOf(header, step))].map((frame) => header.names[frame]);

/** Of an audit the first one that is shown with something in it; else the first. */
export function firstBadStep({ strip }: Pick<SceneHeader, "strip">): number {
  const bad = strip?.steps.findIndex((step, i) => step >= 0 && strip.contacts[i] + strip.intersections[i] > 0) ?? -1;
  return bad < 0 ? 0 : strip!.steps[bad];
}

/** A single frame: its pairs are intersections, and nothing moves. */
export const isPose = ({ names, strip }: Pick<SceneHeader, "names" | "strip">): boolean => names.length === 1 && !strip;

/** What the pairs of a scene are called. */
export const nounOf = (header: Pick<SceneHeader, "names" | "strip">): string =>
  header.strip ? "pair" : isPose(header) ? "intersection" : "contact";

/** What is said where nothing was found. */
export function nothingFound(header: SceneHeader, step: StepHeader): string {
  if (header.strip) return "nothing was found in this frame, nor in the step to it.";
  return isPose(header) ? "no edge passes through a triangle or touches one, proven." : withoutContacts(step);
}

/** What is said of a step without contacts. Where not all are listed that means little. */
export function withoutContacts({ toi_lower: lower }: StepHeader): string {
  if (lower === null) return "the step is free, proven.";
  return `none is listed here, but pairs listed elsewhere may touch${lower > 0 ? ` from ${lower} on` : ""}.`;
}
