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
}

/** A single frame: its pairs are intersections, and nothing moves. */
export const isPose = ({ names }: Pick<SceneHeader, "names">): boolean => names.length === 1;

/** What the pairs of a scene are called. */
export const nounOf = (header: Pick<SceneHeader, "names">): string => (isPose(header) ? "intersection" : "contact");

/** What is said where nothing was found. */
export function nothingFound(header: SceneHeader, step: StepHeader): string {
  return isPose(header) ? "no edge passes through a triangle or touches one, proven." : withoutContacts(step);
}

/** What is said of a step without contacts. Where not all are listed that means little. */
export function withoutContacts({ toi_lower: lower }: StepHeader): string {
  if (lower === null) return "the step is free, proven.";
  return `none is listed here, but pairs listed elsewhere may touch${lower > 0 ? ` from ${lower} on` : ""}.`;
}
