// Chooses and sorts the contacts that are listed and drawn.
import type { ViewState } from "../store";
import type { StepView } from "./step_view";

type Filter = Pick<ViewState, "brush" | "kind" | "object" | "vertex" | "unresolvedOnly" | "sort" | "descending">;

function accepts({ scene }: StepView, filter: Filter): (contact: number) => boolean {
  const { contacts, objectOfVertex } = scene;
  const [low, high] = filter.brush;
  return (i) => {
    const time = contacts.toiLower[i];
    if (time < low || time > high) return false;
    if (filter.kind >= 0 && contacts.kind[i] !== filter.kind) return false;
    if (filter.unresolvedOnly && !contacts.isUnresolved(i)) return false;
    if (filter.vertex >= 0 && !contacts.has(i, filter.vertex)) return false;
    return filter.object < 0 || objectsOf(i, objectOfVertex, contacts).includes(filter.object);
  };
}

/** Returns the objects of the first and of the second feature. */
export function objectsOf(
  contact: number,
  objectOfVertex: Int32Array,
  contacts: StepView["scene"]["contacts"],
): [number, number] {
  const { first } = contacts.kindOf(contact);
  return [objectOfVertex[contacts.vertex(contact, 0)], objectOfVertex[contacts.vertex(contact, first)]];
}

/** Returns the contacts that the filter accepts, sorted; times break ties. */
export function listed(view: StepView, filter: Filter): Uint32Array {
  const { contacts, objectOfVertex } = view.scene;
  const kept = view.byTime.filter(accepts(view, filter));
  if (filter.sort !== "time") {
    const keys: Record<string, (i: number) => number> = {
      kind: (i) => contacts.kind[i],
      features: (i) => contacts.vertex(i, 0),
      object: (i) => objectsOf(i, objectOfVertex, contacts)[0],
    };
    const key = keys[filter.sort];
    kept.sort((a, b) => key(a) - key(b) || contacts.toiLower[a] - contacts.toiLower[b] || a - b);
  }
  return filter.descending ? kept.reverse() : kept;
}
