// The table of keys, from which the list that `?` shows is made, too.
import { playPair, timeOf } from "./panels/pair_panel";
import { togglePlay } from "./panels/timeline";
import { isPose } from "./scene/header";
import { hasSieve } from "./scene/proofs";
import type { Session } from "./session";
import type { Panel, Switch } from "./store";
import type { Actions } from "./actions";

export interface KeyAction {
  /** As in KeyboardEvent.key, with Shift+ or Alt+ before it. */
  keys: string[];
  /** The name in the list of keys; if absent, the keys themselves. */
  label?: string;
  does: string;
  run: (key: string) => void;
}

function timeKeys(session: Session): KeyAction[] {
  const { store } = session;
  const shift = (by: number): void => {
    store.set({ time: Math.min(Math.max(store.now.time + by, 0), 1), playing: false });
  };
  return [
    {
      keys: [" "],
      label: "Space",
      does: "play or pause",
      run: () => {
        togglePlay(session);
      },
    },
    {
      keys: ["ArrowLeft", "ArrowRight"],
      label: "← →",
      does: "a hundredth of the step back, on",
      run: (key) => {
        shift(key === "ArrowLeft" ? -0.01 : 0.01);
      },
    },
    {
      keys: [",", "."],
      does: "a thousandth back, on",
      run: (key) => {
        shift(key === "," ? -0.001 : 0.001);
      },
    },
    {
      keys: ["Home", "End"],
      does: "start and end of the step",
      run: (key) => {
        store.set({ time: key === "Home" ? 0 : 1, playing: false });
      },
    },
    {
      keys: ["PageUp", "PageDown"],
      label: "Page ↑ ↓",
      does: "step before, step after",
      run: (key) => {
        session.showStep(store.now.step + (key === "PageUp" ? -1 : 1));
      },
    },
    {
      keys: ["[", "]"],
      does: "keep contacts from now on, until now",
      run: (key) => {
        const { brush, time } = store.now;
        store.set({ brush: key === "[" ? [time, Math.max(brush[1], time)] : [Math.min(brush[0], time), time] });
      },
    },
    {
      keys: ["\\"],
      does: "keep all contacts of the step",
      run: () => {
        store.set({ brush: [0, 1] });
      },
    },
  ];
}

function pairKeys(session: Session, actions: Actions): KeyAction[] {
  const { store } = session;
  const moments = { "1": "before", "2": "at", "3": "after" } as const;
  return [
    {
      keys: ["f"],
      does: "first contact",
      run: () => {
        actions.firstContact();
      },
    },
    {
      keys: ["s"],
      does: "what stops this step",
      run: () => {
        actions.whatStops();
      },
    },
    {
      keys: ["ArrowUp", "ArrowDown"],
      label: "↑ ↓",
      does: "contact before, contact after, in the list",
      run: (key) => {
        session.move(key === "ArrowUp" ? -1 : 1);
      },
    },
    {
      keys: ["1", "2", "3"],
      does: "before, at and after the contact",
      run: (key) => {
        const { pair } = session;
        if (pair && !pair.isIntersection)
          store.set({ time: timeOf(pair, moments[key as "1" | "2" | "3"]), playing: false });
      },
    },
    {
      keys: ["o"],
      does: "play the pair, round and round",
      run: () => {
        playPair(session);
      },
    },
    {
      keys: ["i"],
      does: "the pair alone, or in the scene",
      run: () => {
        if (session.pair) store.set({ isolated: !store.now.isolated });
      },
    },
    {
      keys: ["Escape"],
      label: "Esc",
      does: "leave the pair",
      run: () => {
        actions.leave();
      },
    },
  ];
}

function cameraKeys({ store }: Session, actions: Actions): KeyAction[] {
  const arrows = (modifier: string): string[] =>
    ["Left", "Right", "Up", "Down"].map((way) => `${modifier}+Arrow${way}`);
  const way = (key: string): string => key.replace(/^.*Arrow/, "");
  return [
    {
      keys: arrows("Shift"),
      label: "Shift ← → ↑ ↓",
      does: "turn the camera",
      run: (key) => {
        actions.turn(way(key));
      },
    },
    {
      keys: arrows("Alt"),
      label: "Alt ← → ↑ ↓",
      does: "shift the camera",
      run: (key) => {
        actions.shift(way(key));
      },
    },
    {
      keys: ["+", "=", "-"],
      label: "+ −",
      does: "nearer, farther",
      run: (key) => {
        actions.zoom(key === "-" ? 0.8 : 1.25);
      },
    },
    {
      keys: ["r"],
      does: "see everything",
      run: () => {
        actions.overview();
      },
    },
    {
      keys: ["z"],
      does: "y or z of the mesh upward",
      run: () => {
        store.set({ up: store.now.up === "y" ? "z" : "y" });
        actions.overview();
      },
    },
  ];
}

const kSwitches: [string, Switch, string][] = [
  ["g", "smooth", "smooth or flat shading"],
  ["e", "edges", "edges of the mesh"],
  ["m", "marks", "contact points"],
  ["n", "normals", "contact normals"],
  ["p", "features", "both features of every contact"],
  ["x", "xray", "contacts behind the surface, faintly"],
  ["u", "unresolvedOnly", "unresolved pairs alone"],
  ["h", "panelOpen", "hide or show the panel"],
];

const kNewOnly: [string, Switch, string] = ["w", "newOnly", "pairs alone that are new since the frame before"];

function lookKeys({ store, scene }: Session, actions: Actions): KeyAction[] {
  const panels: Record<string, Panel> = { l: "contacts", b: "pair", v: "sieve" };
  const shown = scene.header.steps.some(hasSieve) ? ["l", "b", "v"] : ["l", "b"];
  const plain: [string, string, () => void][] = [
    ["t", "dark or light", actions.theme.bind(actions)],
    ["c", "copy a link to this view", actions.copyLink.bind(actions)],
    ["k", "save a picture", () => void actions.savePicture()],
    [
      "?",
      "this list",
      () => {
        actions.help();
      },
    ],
  ];
  const switches = scene.header.strip ? [...kSwitches, kNewOnly] : kSwitches;
  return [
    ...switches.map(([key, name, does]) => ({
      keys: [key],
      does,
      run: () => {
        store.toggle(name);
      },
    })),
    {
      keys: shown,
      does: shown.length > 2 ? "list, pair, sieve" : "list, pair",
      run: (key) => {
        store.set({ panel: panels[key], panelOpen: true });
      },
    },
    ...plain.map(([key, does, run]) => ({ keys: [key], does, run })),
  ];
}

export function keyTable(session: Session, actions: Actions): Record<string, KeyAction[]> {
  const pairs = pairKeys(session, actions);
  const looking = [...cameraKeys(session, actions), ...lookKeys(session, actions)];
  if (isPose(session.scene.header)) return { Intersections: pairs, Looking: looking };
  return { Time: timeKeys(session), Contacts: pairs, Looking: looking };
}

/** The table's name of a pressed key; null if the page should not handle it. */
function nameOf(event: KeyboardEvent): string | null {
  if (event.ctrlKey || event.metaKey) return null;
  const isArrow = event.key.startsWith("Arrow");
  if (event.shiftKey && isArrow) return `Shift+${event.key}`;
  if (event.altKey) return isArrow ? `Alt+${event.key}` : null;
  return event.key.length === 1 ? event.key.toLowerCase() : event.key;
}

/** Until the signal. */
export function listenToKeys(table: Record<string, KeyAction[]>, signal: AbortSignal): void {
  const actions = new Map<string, KeyAction>();
  for (const action of Object.values(table).flat()) for (const key of action.keys) actions.set(key, action);
  const take = (event: KeyboardEvent): void => {
    const target = event.target as HTMLElement;
    const key = nameOf(event);
    if (key === null) return;
    const isTyping = target.matches("select, input:not([type=range]):not([type=checkbox])");
    if (isTyping && key === "Escape") target.blur();
    // A focused button or list handles by itself the keys that press it and leave it.
    const presses = target.matches("button, input[type=checkbox], a") && (key === " " || key === "Enter");
    const action = actions.get(key);
    if (!action || isTyping || presses || document.querySelector("dialog[open]")) return;
    event.preventDefault();
    action.run(key);
  };
  document.addEventListener("keydown", take, { signal });
}
