// The sieve: the number of pairs that enter each stage, from all pairs of the mesh to those that touch.
import { el } from "../dom";
import { grouped, inWords } from "../numbers";
import type { Session } from "../session";
import { SievePicture, stageColour } from "./sieve_picture";
import type { Scene } from "../scene/scene";
import { isPose, nounOf, type SceneHeader, type Stage } from "../scene/header";
import { shareOf } from "../scene/proofs";

/** For the pairs that enter a stage, what they do there. */
const kStages: Record<string, string> = {
  boxes: "have boxes that meet while they move",
  slab: "go into the slab clip: does an axis keep them apart?",
  dnf: "go into DNF: can their four points be in one plane?",
  ncf: "go into NCF: does a plane through an edge keep them apart?",
  solve: "go to the solver: when, and do they touch then?",
};

interface Row extends Stage {
  explained: string;
  total: number;
}

/** The pairs of n things with each other. */
const pairsOf = (n: number): number => (n * (n - 1)) / 2;

function allPairs({ header, rods, loosePoints }: Scene): Stage {
  const { points, faces, edges } = header.mesh;
  const name = "all pairs";
  // Pairs of an edge and a face are counted under vf.
  if (isPose(header)) return { name, vf: edges * faces, ee: 0, ve: 0, vv: 0 };
  const loose = loosePoints.length;
  return { name, vf: points * faces, ee: pairsOf(edges), ve: (loose * rods.length) / 2, vv: pairsOf(loose) };
}

function rowsOf(scene: Scene, step: number): Row[] {
  const { header } = scene;
  const { stages, contacts, complete } = header.steps[step];
  const row = (stage: Stage, explained: string): Row => {
    const { vf, ee, ve, vv } = stage;
    return { ...stage, explained, total: vf + ee + ve + vv };
  };
  const { vf = contacts.ef, ee = 0, ve = 0, vv = 0 } = contacts;
  const name = `${nounOf(header)}s`;
  return [
    row(allPairs(scene), "pairs of features in the mesh"),
    ...stages.map((stage) => row(stage, kStages[stage.name] ?? `go into ${stage.name}`)),
    row({ name, vf, ee, ve, vv }, complete ? `touch: ${name}` : `touch and are listed here: ${name}`),
  ];
}

/** The pairs of a row by kind. */
function byKind({ vf, ee, ve, vv }: Row, header: SceneHeader): string {
  if (isPose(header)) return `${grouped(vf)} edge-face`;
  const loose = ve + vv > 0 ? `, ${grouped(ve)} vertex-edge, ${grouped(vv)} vertex-vertex` : "";
  return `${grouped(vf)} vertex-face, ${grouped(ee)} edge-edge${loose}`;
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
    const rows = rowsOf(scene, store.now.step);
    const all = rows[0].total;
    const left = rows[rows.length - 1].total;
    this.title.textContent = `${inWords(all)} pairs, ${inWords(left)} ${nounOf(scene.header)}${left === 1 ? "" : "s"}`;
    this.share.textContent = shareOf(scene.header.steps[store.now.step], all, left);
    this.picture.show(rows.map((row) => row.total));
    this.list.replaceChildren(
      ...rows.map((row, i) => {
        const swatch = el("i", { class: "swatch" });
        swatch.style.background = stageColour(i, rows.length);
        return el(
          "div",
          {
            class: "sieve-row",
            title: byKind(row, scene.header),
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
