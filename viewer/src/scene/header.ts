// The JSON header of a scene, with the keys of `tamis --json` where that has them.

export interface PairKind {
  name: string;
  /** The numbers of vertices of the first feature and of the second. */
  first: number;
  second: number;
}

export interface Stage {
  name: string;
  vf: number;
  ee: number;
  ve: number;
  vv: number;
}

export interface StepHeader {
  contacts: Record<string, number>;
  /** Before this time the step is proven free; null: the whole step is. */
  toi_lower: number | null;
  toi_upper: number | null;
  stages: Stage[];
  /** Only in audits: the frames at its start and end; the same frame twice if no step leads to the frame. */
  ends?: [number, number];
}

/** All frames of an audited motion. The scene holds positions of some of them. */
export interface Strip {
  names: string[];
  /** For each frame the number of contacts in the step that ends there. */
  contacts: number[];
  intersections: number[];
  /** For each frame the scene's step that ends there; -1: the scene does not hold it. */
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
  /** Only in audits. */
  strip?: Strip;
}

/** The frames at which a step begins and ends. */
export const endsOf = ({ steps, names }: SceneHeader, step: number): [number, number] =>
  steps[step].ends ?? [step, Math.min(step + 1, names.length - 1)];

/** The names of the frames of a step. */
export const namesOf = (header: SceneHeader, step: number): string[] =>
  [...new Set(endsOf(header, step))].map((frame) => header.names[frame]);

/** Whether the scene holds a frame, and the frame has intersections or its step has contacts. */
export const holdsBad = (strip: Strip, frame: number): boolean =>
  strip.steps[frame] >= 0 && strip.contacts[frame] + strip.intersections[frame] > 0;

/** In an audit the first step that the scene holds and that ends at a bad frame; else the first step. */
export function firstBadStep({ strip }: Pick<SceneHeader, "strip">): number {
  const bad = strip?.steps.findIndex((_, frame) => holdsBad(strip, frame)) ?? -1;
  return bad < 0 ? 0 : strip!.steps[bad];
}

/** Whether the scene is a single frame: then its pairs are intersections, and nothing moves. */
export const isPose = ({ names, strip }: Pick<SceneHeader, "names" | "strip">): boolean => names.length === 1 && !strip;

/** The word for the pairs of a scene. */
export const nounOf = (header: Pick<SceneHeader, "names" | "strip">): string =>
  header.strip ? "pair" : isPose(header) ? "intersection" : "contact";

/** The sentence for a step or frame without pairs. */
export function nothingFound(header: SceneHeader, step: StepHeader): string {
  if (header.strip)
    return step.ends && step.ends[0] === step.ends[1]
      ? "nothing was found in this frame; no step to it was asked about."
      : "nothing was found in this frame, nor in the step to it.";
  return isPose(header) ? "no edge passes through a triangle or touches one, proven." : withoutContacts(step);
}

/** The sentence for a step without contacts. If not all contacts are listed here, the step need not be free. */
export function withoutContacts({ toi_lower: lower }: StepHeader): string {
  if (lower === null) return "the step is free, proven.";
  return `none is listed here, but pairs listed elsewhere may touch${lower > 0 ? ` from ${lower} on` : ""}.`;
}
