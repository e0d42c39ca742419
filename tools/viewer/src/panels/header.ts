// The header: what the page shows, what was found, and buttons for the two most frequent questions.
import { button, el } from "../dom";
import { counted, grouped, shortened } from "../numbers";
import type { Actions } from "../actions";
import type { Session } from "../session";
import type { Switch } from "../store";
import { isPose, namesOf, nounOf } from "../scene/header";
import { freeBefore, hasSieve, hasStep, kIntersections, leftOut, nothingFound } from "../scene/proofs";
import { contactsOf } from "../scene/scene";

/** In characters. The full name is shown when the pointer rests on it. */
const kLongestName = 44;

export function header(session: Session, actions: Actions): HTMLElement {
  const { store, scene } = session;
  const names = el("span", { class: "names" });
  const answer = el("p", { class: "answer", id: "answer" });
  store.follow(["step"], () => {
    const { step } = store.now;
    const all = namesOf(scene.header, step);
    names.textContent = all.map((name) => shortened(name, kLongestName)).join(" → ");
    names.title = all.join(" → ");
    answer.replaceChildren(...sentence(session));
  });
  const noun = nounOf(scene.header);
  const first = button(
    `First ${noun}`,
    `Fly to the first ${noun} (F)`,
    () => {
      actions.firstContact();
    },
    { class: "primary", id: "first" },
  );
  const stops = button(
    "What stops this step",
    "The pair that ends it, alone (S)",
    () => {
      actions.whatStops();
    },
    { id: "stops" },
  );
  stops.hidden = isPose(scene.header);
  store.follow(["step"], () => {
    first.disabled = session.view.step.count === 0;
    stops.disabled = session.view.step.header.toi_lower === null;
  });
  return el(
    "header",
    { class: "head-card" },
    el("h1", {}, "Tamis ", names),
    answer,
    el("div", { class: "actions" }, first, stops),
  );
}

function sentence({ view, scene, store }: Session): (Node | string)[] {
  const { contacts } = view.step.header;
  const noun = nounOf(scene.header);
  const { faces } = scene.header.mesh;
  const mesh = `${faces > 0 ? counted(faces, "triangle") : counted(scene.header.mesh.edges, "edge")}, `;
  const count = contactsOf(scene.header.steps[store.now.step]);
  if (count === 0) return [mesh, el("b", {}, `no ${noun}`), `: ${nothingFound(scene.header, view.step.header)}`];
  if (scene.header.strip) {
    const found = scene.header.strip.asks_intersections ? [counted(contacts.ef, "intersection")] : [];
    if (hasStep(view.step.header)) found.push(counted(count - contacts.ef, "contact"));
    const { fresh, steps } = scene.header.strip;
    const isNew = fresh[steps.indexOf(store.now.step)];
    const total = el("b", { id: "count", "data-count": count }, found.join(", "));
    const { header } = view.step;
    const free = header.toi_lower === null ? "." : `. ${leftOut(header) || freeBefore(scene.header, header).join("")}`;
    return [mesh, total, isNew > 0 ? `, ${grouped(isNew)} new since the frame before` : ", none of them new", free];
  }
  const found = el("b", { id: "count", "data-count": count }, counted(count, noun));
  if (isPose(scene.header)) return [mesh, found, kIntersections, ` ${leftOut(view.step.header)}`];
  const unresolved = contacts.unresolved > 0 ? `, ${grouped(contacts.unresolved)} of them unresolved` : "";
  const [before, time, after] = freeBefore(scene.header, view.step.header);
  const collapsed = leftOut(view.step.header);
  if (collapsed) return [mesh, found, `${unresolved}. ${collapsed}`];
  return [mesh, found, `${unresolved}. ${before}`, el("b", {}, time), after];
}

/** Switches for the drawing, theme and help. */
export function tools(session: Session, actions: Actions): HTMLElement {
  const { store } = session;
  const noun = nounOf(session.scene.header);
  const points = `${noun[0].toUpperCase()}${noun.slice(1)}`;
  const flip = (key: Switch, label: string, title: string) => {
    const element = button(
      label,
      title,
      () => {
        store.toggle(key);
      },
      { "data-tool": key },
    );
    store.follow([key], () => {
      element.setAttribute("aria-pressed", String(store.now[key]));
    });
    return element;
  };
  const theme = button(
    "◐",
    "Dark or light (T)",
    () => {
      actions.theme();
    },
    { id: "theme", "aria-label": "Dark or light" },
  );
  return el(
    "nav",
    { class: "tools", "aria-label": "Drawing" },
    flip("marks", "points", `${points} points (M)`),
    flip("normals", "normals", `${points} normals (N)`),
    flip("features", "features", `Both features of every ${noun} (P)`),
    flip("edges", "edges", "Edges of the mesh (E)"),
    flip("smooth", "smooth", "Smooth or flat (G)"),
    flip("xray", "x-ray", `${points}s behind the surface (X)`),
    button(
      "⌂",
      "See everything (R)",
      () => {
        actions.overview();
      },
      { "aria-label": "See everything" },
    ),
    theme,
    button("⤓", "Save a picture (K)", () => void actions.savePicture(), { "aria-label": "Save a picture" }),
    button(
      "?",
      "Keys (?)",
      () => {
        actions.help();
      },
      { id: "keys", "aria-label": "Keys" },
    ),
  );
}

export function tabs(session: Session): HTMLElement {
  const { store } = session;
  const panels = session.scene.header.steps.some(hasSieve)
    ? (["contacts", "pair", "sieve"] as const)
    : (["contacts", "pair"] as const);
  const items = panels.map((panel) => {
    const label = panel === "contacts" ? `${nounOf(session.scene.header)}s` : panel;
    const element = button(
      label,
      `Show: ${label}`,
      () => {
        const isShown = store.now.panelOpen && store.now.panel === panel;
        store.set({ panel, panelOpen: !isShown });
      },
      { role: "tab", "data-tab": panel },
    );
    store.follow(["panel", "panelOpen"], () => {
      element.setAttribute("aria-selected", String(store.now.panelOpen && store.now.panel === panel));
    });
    return element;
  });
  return el("div", { class: "tabs", role: "tablist" }, ...items);
}
