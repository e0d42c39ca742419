// The sieve: how many pairs each stage still has to look at, from all that there are to those that touch.
import { el } from "../dom";
import { grouped, inWords, percent } from "../numbers";
import type { Session } from "../session";
import { contactsOf } from "../scene/scene";
import type { SceneHeader, Stage } from "../scene/header";

/** What each stage does; pairs that enter it are counted. */
const kStages: Record<string, string> = {
  boxes: "boxes meet while they move",
  slab: "go into the slab clip: does an axis keep them apart?",
  dnf: "go into DNF: can their four points be in one plane?",
  ncf: "go into NCF: does a plane through an edge keep them apart?",
  solve: "go to the solver: when, and do they touch then?",
};

interface Row {
  name: string;
  explained: string;
  vf: number;
  ee: number;
  total: number;
}

function rowsOf(header: SceneHeader, step: number): Row[] {
  const { points, faces, edges } = header.mesh;
  const { stages, contacts } = header.steps[step];
  const row = (stage: Stage, explained: string, total: number): Row => ({ ...stage, explained, total });
  const all = { name: "all pairs", vf: points * faces, ee: (edges * (edges - 1)) / 2 };
  return [
    row(all, "pairs of features in the mesh", all.vf + all.ee),
    ...stages.map((stage) => row(stage, kStages[stage.name] ?? `go into ${stage.name}`, stage.vf + stage.ee)),
    row({ name: "contacts", vf: contacts.vf, ee: contacts.ee }, "contacts", contactsOf(header.steps[step])),
  ];
}

export class Sieve {
  readonly element = el("div", { class: "panel-body sieve-panel", id: "sieve" });

  constructor(private readonly session: Session) {
    session.store.follow(["step"], () => {
      this.refresh();
    });
  }

  private refresh(): void {
    const { scene, store } = this.session;
    const rows = rowsOf(scene.header, store.now.step);
    const all = rows[0].total;
    const left = rows[rows.length - 1].total;
    const bars = rows.map((row, i) => {
      // Logarithms, or everything after the first bar would be less than a pixel wide.
      const width = (n: number): number => (n > 0 ? Math.max(Math.log(n + 1) / Math.log(all + 1), 0.01) : 0);
      const bar = el("div", { class: i === 0 ? "bar all" : i === rows.length - 1 ? "bar left" : "bar" });
      bar.style.width = `${100 * width(row.total)}%`;
      const title = `${grouped(row.vf)} vertex-face, ${grouped(row.ee)} edge-edge`;
      const gone = i === 0 ? "" : `${percent(1 - row.total / all)} proven free`;
      return el(
        "div",
        { class: "sieve-row", title, "data-stage": row.name, "data-pairs": row.total },
        el(
          "div",
          { class: "sieve-head" },
          el("b", {}, grouped(row.total)),
          el("span", {}, i < rows.length - 1 ? gone : ""),
        ),
        el("div", { class: "track" }, bar),
        el("div", { class: "sieve-note" }, row.explained),
      );
    });
    this.element.replaceChildren(
      el("h2", { class: "sieve-title" }, `${inWords(all)} pairs, ${inWords(left)} contacts`),
      el(
        "p",
        { class: "summary" },
        all > left
          ? `${percent((all - left) / all)} of all pairs are proven free. Bars are logarithmic: each is what is left to look at.`
          : "Every pair is a contact.",
      ),
      el("div", { class: "sieve" }, ...bars),
      el(
        "p",
        { class: "summary" },
        `Positions here are rounded to ${scene.header.grid.error.toPrecision(2)} of the mesh's unit for drawing; ` +
          "times, counts and brackets are those that were computed.",
      ),
    );
  }
}
