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
  /** The counts of stages; empty if they were not kept. */
  stages: Stage[];
  /** Whether all contacts that were found are listed here. */
  complete: boolean;
  /** How many pairs touch at the start and were ignored. */
  ignored: number;
  /** Which objects have collapsed: they were left out, and nothing is proven of the step. */
  collapsed?: string;
  /** Only in audits: the frames at its start and end; the same frame twice if no step leads to the frame. */
  ends?: [number, number];
}

/** All frames of an audited motion. The scene holds positions of some of them. */
export interface Strip {
  /** Whether the question was about the intersections of frames, too. */
  asks_intersections: boolean;
  names: string[];
  /** Why a frame was not asked about, by its number. */
  problems: Partial<Record<string, string>>;
  /** Whether a step that ends at the frame was asked about. */
  has_step: boolean[];
  /** For each frame the number of contacts in the step that ends there. */
  contacts: number[];
  intersections: number[];
  /** How many of both the frame before did not have. */
  fresh: number[];
  /** Whether an object has collapsed in the frame. */
  collapsed: boolean[];
  /** For each frame the scene's step that ends there; -1: the scene does not hold it. */
  steps: number[];
}

export interface SceneHeader {
  names: string[];
  scale: number;
  min_separation: number;
  /** What became of pairs that touch at the start: "report" or "ignore". */
  at_start: string;
  kinds: PairKind[];
  steps: StepHeader[];
  /** `names`: of objects, by their numbers; there may be none, or fewer than objects. */
  mesh: { vertices: number; faces: number; edges: number; points: number; names: string[] };
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

const shownFrames = ({ steps }: Strip): number[] => steps.flatMap((step, frame) => (step < 0 ? [] : [frame]));

/** Whether a frame has intersections or a collapsed object, or the step to it contacts. */
export const isBad = (strip: Strip, frame: number): boolean =>
  strip.collapsed[frame] || strip.contacts[frame] + strip.intersections[frame] > 0;

/** The bad frames that the scene holds. */
export const badFrames = (strip: Strip): number[] => shownFrames(strip).filter((frame) => isBad(strip, frame));

/** Those that have pairs which the frame before did not have. */
export const newFrames = (strip: Strip): number[] => shownFrames(strip).filter((frame) => strip.fresh[frame] > 0);

/** The step that a page shows first: in an audit the first one with new pairs, else the first bad one. */
export function firstBadStep({ strip }: Pick<SceneHeader, "strip">): number {
  const first = strip && [...newFrames(strip), ...badFrames(strip)][0];
  return first === undefined ? 0 : strip!.steps[first];
}

/** Whether the scene is a single frame: then its pairs are intersections, and nothing moves. */
export const isPose = ({ names, strip }: Pick<SceneHeader, "names" | "strip">): boolean => names.length === 1 && !strip;

/** The word for the pairs of a scene. */
export const nounOf = (header: Pick<SceneHeader, "names" | "strip">): string =>
  header.strip ? "pair" : isPose(header) ? "intersection" : "contact";
