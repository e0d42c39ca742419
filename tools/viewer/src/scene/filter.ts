// Chooses and sorts the contacts that are listed and drawn.
import type { ViewState } from "../store";
import type { StepView } from "./step_view";

type Filter = Pick<
  ViewState,
  "brush" | "kind" | "object" | "vertex" | "unresolvedOnly" | "newOnly" | "sort" | "descending"
>;

function accepts({ scene }: StepView, filter: Filter): (contact: number) => boolean {
  const { contacts, objectOfVertex } = scene;
  const [low, high] = filter.brush;
  const isChosen = scene.objects.chosen(filter.object);
  return (i) => {
    const time = contacts.toiLower[i];
    if (time < low || time > high) return false;
    if (filter.kind >= 0 && contacts.kind[i] !== filter.kind) return false;
    if (filter.unresolvedOnly && !contacts.isUnresolved(i)) return false;
    if (filter.vertex >= 0 && !contacts.has(i, filter.vertex)) return false;
    if (filter.newOnly && !contacts.isNew(i)) return false;
    return filter.object === "" || objectsOf(i, objectOfVertex, contacts).some(isChosen);
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
  const ordered = (rows: Uint32Array): Uint32Array => (filter.descending ? rows.reverse() : rows);
  const kept = view.byTime.filter(accepts(view, filter));
  if (filter.sort !== "time") {
    const keys: Record<string, (i: number) => number> = {
      kind: (i) => contacts.kind[i],
      features: (i) => contacts.vertex(i, 0),
      object: (i) => objectOfVertex[contacts.vertex(i, 0)],
    };
    // `kept` is sorted by time, so that its places break ties. Numbers are sorted much faster than by a function.
    const kOrders = Math.max(kept.length, 1);
    const order = Float64Array.from(kept, (i, place) => keys[filter.sort](i) * kOrders + place).sort();
    return ordered(Uint32Array.from(order, (key) => kept[((key % kOrders) + kOrders) % kOrders]));
  }
  return ordered(kept);
}
