// The table of contacts, of which only visible rows are drawn, with filters above it.
import { colourOfTime, css } from "../colours";
import { el } from "../dom";
import { objectsOf } from "../scene/filter";
import { counted, grouped } from "../numbers";
import { nounOf } from "../scene/header";
import { nothingFound } from "../scene/proofs";
import { kFilterKeys, type Session } from "../session";
import type { SortKey } from "../store";

const kRowHeight = 30;
const kTallRowHeight = 46;
/** In pixels, as browsers stop at some 30 million. In higher lists the scroll bar moves by several rows at a time. */
const kTallest = 8_000_000;

const kColumns: { key: SortKey; label: string; title: string }[] = [
  { key: "time", label: "time", title: "Sort by time of impact" },
  { key: "kind", label: "kind", title: "Sort by kind of pair" },
  { key: "features", label: "vertices", title: "Sort by the first vertex" },
  { key: "object", label: "objects", title: "Sort by the first object" },
];

export class ContactList {
  readonly element = el("div", { class: "panel-body list-panel", id: "contacts" });
  private readonly scroller = el("div", {
    class: "rows",
    id: "rows",
    role: "listbox",
    tabindex: 0,
    "aria-label": "Contacts",
  });
  private readonly spacer = el("div", { class: "spacer" });
  private readonly window = el("div", { class: "window" });
  private readonly summary = el("p", { class: "summary", id: "listed" });
  /** In pixels. */
  private readonly rowHeight: number;

  constructor(private readonly session: Session) {
    const { store } = session;
    // Long numbers and names take a second line, on which they are seen in full.
    const { objects, header } = session.scene;
    const isTall = objects.areNamed || objects.numbers.length > 99 || header.mesh.vertices > 9999;
    this.rowHeight = isTall ? kTallRowHeight : kRowHeight;
    this.element.dataset.tall = String(isTall);
    this.spacer.append(this.window);
    this.scroller.append(this.spacer);
    this.element.append(filters(session), this.summary, this.head(), this.scroller);
    this.scroller.addEventListener("scroll", () => {
      this.drawRows();
    });
    new ResizeObserver(() => {
      this.drawRows();
    }).observe(this.scroller);
    store.follow(kFilterKeys, () => {
      this.refresh();
    });
    store.follow(["selected"], () => {
      this.reveal();
      this.drawRows();
    });
  }

  private head(): HTMLElement {
    const { store } = this.session;
    const cells = kColumns.map(({ key, label, title }) => {
      const cell = el("button", { type: "button", title }, label);
      cell.addEventListener("click", () => {
        store.set({ sort: key, descending: store.now.sort === key && !store.now.descending });
      });
      store.follow(["sort", "descending"], () => {
        const { sort, descending } = store.now;
        cell.dataset.sorted = sort === key ? (descending ? "down" : "up") : "";
        cell.setAttribute("aria-pressed", String(sort === key));
      });
      return cell;
    });
    return el("div", { class: "head" }, ...cells);
  }

  private refresh(): void {
    const { rows, drawn, view, scene } = this.session;
    const { count } = view.step;
    const noun = nounOf(scene.header);
    const height = Math.min(rows.length * this.rowHeight, kTallest);
    this.spacer.style.height = `${height}px`;
    this.summary.textContent =
      count === 0
        ? `No ${noun}: ${nothingFound(scene.header, view.step.header)}`
        : rows.length === count
          ? counted(count, noun)
          : `${grouped(rows.length)} of ${counted(count, noun)}`;
    if (drawn.length < rows.length) this.summary.textContent += `; ${grouped(drawn.length)} of them are drawn`;
    this.summary.dataset.count = String(rows.length);
    this.scroller.scrollTop = 0;
    this.drawRows();
  }

  /** The first visible row. */
  private get top(): number {
    const { rows } = this.session;
    const range = this.spacer.clientHeight - this.scroller.clientHeight;
    const most = rows.length - this.scroller.clientHeight / this.rowHeight;
    return range > 0 ? Math.max((this.scroller.scrollTop / range) * most, 0) : 0;
  }

  private reveal(): void {
    const { rows, store } = this.session;
    const place = rows.indexOf(store.now.selected);
    const seen = this.scroller.clientHeight / this.rowHeight;
    if (place < 0 || (place >= this.top && place <= this.top + seen - 1)) return;
    const range = this.spacer.clientHeight - this.scroller.clientHeight;
    this.scroller.scrollTop = (range * Math.max(place - seen / 2, 0)) / Math.max(rows.length - seen, 1);
  }

  private drawRows(): void {
    const { rows } = this.session;
    const first = Math.floor(this.top);
    const shown = Math.ceil(this.scroller.clientHeight / this.rowHeight) + 1;
    this.window.style.transform = `translateY(${this.scroller.scrollTop - (this.top - first) * this.rowHeight}px)`;
    const elements: HTMLElement[] = [];
    for (let r = first; r < Math.min(first + shown, rows.length); ++r) elements.push(this.row(rows[r]));
    this.window.replaceChildren(...elements);
  }

  private row(contact: number): HTMLElement {
    const { scene, store } = this.session;
    const { contacts } = scene;
    const time = contacts.toiLower[contact];
    const swatch = el("i", { class: "swatch" });
    swatch.style.background = css(colourOfTime(time));
    const both = objectsOf(contact, scene.objectOfVertex, contacts);
    const names = [...new Set(both)].map((object) => scene.objects.nameOf(object));
    const row = el(
      "div",
      {
        class: "row",
        role: "option",
        "data-contact": contact,
        "aria-selected": store.now.selected === contact,
      },
      el("span", {}, swatch, time.toFixed(5)),
      el("span", {}, contacts.kindOf(contact).name + (contacts.isUnresolved(contact) ? " ?" : "")),
      el("span", {}, `${contacts.firstFeature(contact).join(" ")} · ${contacts.secondFeature(contact).join(" ")}`),
      el("span", { class: "objects" }, ...names.flatMap((name, i) => [...(i > 0 ? [" · "] : []), el("bdi", {}, name)])),
    );
    row.title = names.join(" · ");
    if (contacts.isUnresolved(contact)) row.title += "; unresolved: doubles cannot decide whether the pair touches";
    if (contacts.isNew(contact)) {
      row.dataset.new = "true";
      row.title += "; new since the frame before";
    }
    row.addEventListener("click", () => {
      this.session.select(contact);
    });
    return row;
  }
}

function filters(session: Session): HTMLElement {
  const { store, scene } = session;
  const kind = el("select", { id: "kind", title: "Kind of pair" }, el("option", { value: -1 }, "all kinds"));
  scene.header.kinds.forEach(({ name }, i) => {
    kind.append(el("option", { value: i }, kKindNames[name] ?? name));
  });
  kind.addEventListener("change", () => {
    store.set({ kind: Number(kind.value) });
  });
  store.follow(["kind"], () => {
    kind.value = String(store.now.kind);
  });
  const hasUnresolved = scene.header.steps.some((step) => step.contacts.unresolved > 0);
  const hasNew = scene.header.strip?.fresh.some((count) => count > 0) ?? false;
  return el(
    "div",
    { class: "filters" },
    kind,
    vertexFilter(session),
    objectFilter(session),
    checkbox(session, "unresolvedOnly", "unresolved", hasUnresolved),
    checkbox(session, "newOnly", "new", hasNew),
  );
}

function vertexFilter({ store, scene }: Session): HTMLElement {
  const label = "vertex";
  const most = scene.header.mesh.vertices - 1;
  const input = el("input", { type: "number", id: label, min: 0, max: most, placeholder: label, "aria-label": label });
  input.addEventListener("input", () => {
    store.set({ vertex: input.value === "" ? -1 : Number(input.value) });
  });
  store.follow(["vertex"], () => {
    const { vertex } = store.now;
    if (Number(input.value || -1) !== vertex) input.value = vertex < 0 ? "" : String(vertex);
  });
  return input;
}

function objectFilter({ store, scene }: Session): HTMLElement {
  const label = scene.objects.areNamed ? "object's name" : "object";
  const input = el("input", { type: "search", id: "object", placeholder: "object", "aria-label": label });
  input.addEventListener("input", () => {
    store.set({ object: input.value });
  });
  store.follow(["object"], () => {
    if (input.value !== store.now.object) input.value = store.now.object;
  });
  input.hidden = scene.objects.numbers.length < 2;
  return input;
}

function checkbox({ store }: Session, key: "unresolvedOnly" | "newOnly", name: string, isShown: boolean): HTMLElement {
  const input = el("input", { type: "checkbox", id: name });
  input.addEventListener("change", () => {
    store.set({ [key]: input.checked });
  });
  store.follow([key], () => {
    input.checked = store.now[key];
  });
  const label = el("label", {}, input, name);
  label.hidden = !isShown;
  return label;
}

export const kKindNames: Record<string, string> = {
  vf: "vertex-face",
  ee: "edge-edge",
  ve: "vertex-edge",
  vv: "vertex-vertex",
  ef: "edge-face",
};
