// The sieve: the number of pairs that enter each stage, from all pairs of the mesh to those that touch.
import { el } from "../dom";
import { grouped, inWords, percent } from "../numbers";
import type { Session } from "../session";
import { SievePicture, stageColour } from "./sieve_picture";
import { contactsOf } from "../scene/scene";
import { isPose, nounOf, type SceneHeader, type Stage } from "../scene/header";

/** For the pairs that enter a stage, what they do there. */
const kStages: Record<string, string> = {
  boxes: "have boxes that meet while they move",
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
  // Pairs of an edge and a face are counted under vf.
  const all = isPose(header)
    ? { name: "all pairs", vf: edges * faces, ee: 0 }
    : { name: "all pairs", vf: points * faces, ee: (edges * (edges - 1)) / 2 };
  const [vf, ee] = isPose(header) ? [contacts.ef, 0] : [contacts.vf, contacts.ee];
  const found = { name: `${nounOf(header)}s`, vf, ee };
  return [
    row(all, "pairs of features in the mesh", all.vf + all.ee),
    ...stages.map((stage) => row(stage, kStages[stage.name] ?? `go into ${stage.name}`, stage.vf + stage.ee)),
    row(found, `touch: ${found.name}`, contactsOf(header.steps[step])),
  ];
}

export class Sieve {
  readonly element = el("div", { class: "panel-body sieve-panel", id: "sieve" });
  private readonly picture = new SievePicture();
  private readonly title = el("h2", { class: "sieve-title" });
  private readonly share = el("p", { class: "summary" });
  private readonly list = el("div", { class: "sieve" });

  constructor(private readonly session: Session) {
    const { error } = session.scene.header.grid;
    this.element.append(
      this.title,
      this.share,
      this.picture.canvas,
      this.list,
      el(
        "p",
        { class: "summary" },
        `Positions here are rounded to ${error.toPrecision(2)} of the mesh's unit for drawing; ` +
          "times, counts and brackets are those that were computed.",
      ),
    );
    session.store.follow(["step", "theme", "panel"], () => {
      this.refresh();
    });
  }

  private refresh(): void {
    const { scene, store } = this.session;
    const rows = rowsOf(scene.header, store.now.step);
    const all = rows[0].total;
    const left = rows[rows.length - 1].total;
    this.title.textContent = `${inWords(all)} pairs, ${inWords(left)} ${nounOf(scene.header)}${left === 1 ? "" : "s"}`;
    this.share.textContent = `${percent(all > 0 ? (all - left) / all : 1)} of all pairs are proven free. Areas are true to scale.`;
    this.picture.show(rows.map((row) => row.total));
    this.list.replaceChildren(
      ...rows.map((row, i) => {
        const swatch = el("i", { class: "swatch" });
        swatch.style.background = stageColour(i, rows.length);
        return el(
          "div",
          {
            class: "sieve-row",
            title: isPose(scene.header)
              ? `${grouped(row.vf)} edge-face`
              : `${grouped(row.vf)} vertex-face, ${grouped(row.ee)} edge-edge`,
            "data-stage": row.name,
            "data-pairs": row.total,
          },
          swatch,
          el("b", {}, grouped(row.total)),
          el("span", {}, row.explained),
        );
      }),
    );
  }
}
