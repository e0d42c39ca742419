// The messages between the page and its worker.

/** A file of a step. */
export interface StepFile {
  name: string;
  bytes: ArrayBuffer;
}

/** What the module says of a step, as tools/program/program.cpp writes it. */
export interface Facts {
  vertices: number;
  triangles: number;
  contacts: number;
  seconds: number;
  /** Proven: the step is free before this part of it. */
  first: number;
  notes: string[];
}

export type ToWorker =
  | { ask: "load"; wasm: ArrayBuffer }
  | { ask: "open"; start: StepFile; end: StepFile }
  | { ask: "find"; length: number; all: boolean };

/** The answer to each message. `dead`: the worker can answer no other one. */
export type FromWorker = { problem: string; dead: boolean } | { problem: ""; facts: Facts | null; scene: ArrayBuffer };
