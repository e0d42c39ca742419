// The state of the page, in one place: panels and drawing follow it, keys and pointers change it.

export type Theme = "dark" | "light";
export type Up = "y" | "z";
export type Panel = "contacts" | "pair" | "sieve";
export type SortKey = "time" | "kind" | "features" | "object";

/** The parts of the state that are on or off. */
export type Switch =
  | "smooth"
  | "edges"
  | "marks"
  | "normals"
  | "features"
  | "xray"
  | "unresolvedOnly"
  | "newOnly"
  | "panelOpen";

export interface ViewState {
  step: number;
  /** The time in the step, in [0, 1]. */
  time: number;
  playing: boolean;
  /** The times between which the page plays again and again. */
  loop: [number, number];
  /** The selected contact, by its place among those of all steps; -1: none. */
  selected: number;
  /** Whether only the selected pair is drawn, with its surroundings. */
  isolated: boolean;
  brush: [number, number];
  /** The filter's kind, by its place in the header's kinds; -1: all. */
  kind: number;
  /** The filter's object: a part of its name, or its number; empty: all. */
  object: string;
  vertex: number;
  unresolvedOnly: boolean;
  newOnly: boolean;
  sort: SortKey;
  descending: boolean;
  panel: Panel;
  panelOpen: boolean;
  theme: Theme;
  smooth: boolean;
  edges: boolean;
  marks: boolean;
  normals: boolean;
  features: boolean;
  xray: boolean;
  /** The axis of the mesh that points up in the drawing. */
  up: Up;
}

export const initialState: ViewState = {
  step: 0,
  time: 0,
  playing: false,
  loop: [0, 1],
  selected: -1,
  isolated: false,
  brush: [0, 1],
  kind: -1,
  object: "",
  vertex: -1,
  unresolvedOnly: false,
  newOnly: false,
  sort: "time",
  descending: false,
  panel: "contacts",
  panelOpen: true,
  theme: "dark",
  smooth: true,
  edges: false,
  marks: true,
  normals: false,
  features: false,
  xray: true,
  up: "y",
};

export type Key = keyof ViewState;
type Listener = () => void;

export class Store {
  private state: ViewState;
  private readonly listeners: { keys: Set<Key>; listener: Listener }[] = [];

  constructor(state: ViewState) {
    this.state = state;
  }

  get now(): Readonly<ViewState> {
    return this.state;
  }

  /** Changes the state, and calls the listeners of the keys that have changed. */
  set(change: Partial<ViewState>): void {
    const changed = (Object.keys(change) as Key[]).filter((key) => this.state[key] !== change[key]);
    if (changed.length === 0) return;
    this.state = { ...this.state, ...change };
    for (const { keys, listener } of this.listeners) if (changed.some((key) => keys.has(key))) listener();
  }

  toggle(key: Switch): void {
    this.set({ [key]: !this.state[key] });
  }

  /** Calls the listener at once, and after each change of one of the keys. */
  follow(keys: Key[], listener: Listener): void {
    this.listeners.push({ keys: new Set(keys), listener });
    listener();
  }
}
