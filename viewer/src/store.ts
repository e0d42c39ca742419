// What the page shows, in one place: panels and drawing follow it, keys and pointers change it.

export type Theme = "dark" | "light";
export type Up = "y" | "z";
export type Panel = "contacts" | "pair" | "sieve";
export type SortKey = "time" | "kind" | "features" | "object";

/** What is on or off. */
export type Switch = "smooth" | "edges" | "marks" | "normals" | "features" | "xray" | "unresolvedOnly" | "panelOpen";

export interface ViewState {
  step: number;
  /** Time in the step, 0 to 1. */
  time: number;
  playing: boolean;
  /** Playing goes round between these times. */
  loop: [number, number];
  /** A contact by its place among those of all steps; -1: none. */
  selected: number;
  /** The selected pair alone. */
  isolated: boolean;
  brush: [number, number];
  /** Place in the header's kinds; -1: all. */
  kind: number;
  object: number;
  vertex: number;
  unresolvedOnly: boolean;
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
  /** Which way of the mesh is shown upward. */
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
  object: -1,
  vertex: -1,
  unresolvedOnly: false,
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

  /** Tells those who asked for one of the keys that changed. */
  set(change: Partial<ViewState>): void {
    const changed = (Object.keys(change) as Key[]).filter((key) => this.state[key] !== change[key]);
    if (changed.length === 0) return;
    this.state = { ...this.state, ...change };
    for (const { keys, listener } of this.listeners) if (changed.some((key) => keys.has(key))) listener();
  }

  toggle(key: Switch): void {
    this.set({ [key]: !this.state[key] });
  }

  /** Calls at once, and after each change of one of the keys. */
  follow(keys: Key[], listener: Listener): void {
    this.listeners.push({ keys: new Set(keys), listener });
    listener();
  }
}
