// Writes the state into the address, behind `#`, and reads it: a link shows the sender's view.
import { Vector3 } from "three";
import { hasSieve } from "./scene/proofs";
import type { Scene } from "./scene/scene";
import { initialState, type ViewState } from "./store";
import type { Viewpoint } from "./view3d/camera";

const kSwitches = [
  "smooth",
  "edges",
  "marks",
  "normals",
  "features",
  "xray",
  "unresolvedOnly",
  "newOnly",
  "isolated",
] as const;
const kValues = ["kind", "object", "vertex", "selected"] as const;

const short = (x: number): string => String(Number(x.toPrecision(6)));

export function toHash(state: Readonly<ViewState>, viewpoint: Viewpoint | null): string {
  const parts = new URLSearchParams();
  if (state.step > 0) parts.set("step", String(state.step));
  // With all digits: the selected contact's bracket may be narrower than six digits show.
  parts.set("t", String(state.time));
  for (const key of kValues) if (state[key] !== initialState[key]) parts.set(key, String(state[key]));
  if (state.brush[0] > 0 || state.brush[1] < 1) parts.set("brush", state.brush.map(short).join(","));
  if (state.sort !== initialState.sort || state.descending)
    parts.set("sort", state.sort + (state.descending ? "-" : ""));
  for (const key of kSwitches) if (state[key] !== initialState[key]) parts.set(key, state[key] ? "1" : "0");
  parts.set("up", state.up);
  if (state.panel !== initialState.panel) parts.set("panel", state.panel);
  if (viewpoint) parts.set("eye", [...viewpoint.eye, ...viewpoint.target].map(short).join(","));
  return parts.toString().replaceAll("%2C", ",");
}

const numbers = (text: string | null): number[] => (text === null ? [] : text.split(",").map(Number));

/** The state that a hash describes, without entries that are unknown or not in this scene. */
export function fromHash(
  hash: string,
  { stepCount, contacts, header }: Pick<Scene, "stepCount" | "contacts" | "header">,
): { state: Partial<ViewState>; viewpoint: Viewpoint | null } {
  const parts = new URLSearchParams(hash.replace(/^#/, ""));
  const state: Partial<ViewState> = {};
  const integer = (name: string, below: number): number | null => {
    const value = Number(parts.get(name) ?? NaN);
    return Number.isInteger(value) && value >= 0 && value < below ? value : null;
  };
  state.step = integer("step", stepCount) ?? 0;
  const time = Number(parts.get("t") ?? NaN);
  state.time = time >= 0 && time <= 1 ? time : 1;
  state.selected = integer("selected", contacts.count) ?? -1;
  state.object = parts.get("object") ?? "";
  for (const key of ["kind", "vertex"] as const) state[key] = integer(key, 2 ** 31) ?? -1;
  const [low, high] = numbers(parts.get("brush"));
  state.brush = low >= 0 && high <= 1 && low <= high ? [low, high] : [0, 1];
  const sort = parts.get("sort") ?? initialState.sort;
  state.descending = sort.endsWith("-");
  const key = sort.replace(/-$/, "");
  if (key === "time" || key === "kind" || key === "features" || key === "object") state.sort = key;
  for (const name of kSwitches) state[name] = parts.has(name) ? parts.get(name) === "1" : initialState[name];
  const panel = parts.get("panel") ?? initialState.panel;
  if (panel === "contacts" || panel === "pair" || (panel === "sieve" && header.steps.some(hasSieve)))
    state.panel = panel;
  const up = parts.get("up");
  if (up === "y" || up === "z") state.up = up;
  const eye = numbers(parts.get("eye"));
  const viewpoint =
    eye.length === 6 && eye.every(Number.isFinite)
      ? { eye: new Vector3(...eye.slice(0, 3)), target: new Vector3(...eye.slice(3)) }
      : null;
  return { state, viewpoint };
}
