// The panel of the selected pair: its features, its time of impact, and its motion before, at and after that.
import { button, el } from "../dom";
import { scientific } from "../numbers";
import { objectsOf } from "../scene/filter";
import type { Pair } from "../scene/pair";
import { isPose, nounOf } from "../scene/header";
import { verdictOf } from "../scene/proofs";
import type { Session } from "../session";
import { kKindNames } from "./contact_list";
import { GapPlot } from "./gap_plot";
import { PairSketch } from "./pair_sketch";

type Moment = "before" | "at" | "after";
const kMoments: Moment[] = ["before", "at", "after"];

export const timeOf = (pair: Pair, moment: Moment): number =>
  moment === "before" ? pair.before : moment === "at" ? pair.toi : pair.after;

export class PairPanel {
  readonly element = el("div", { class: "panel-body pair-panel", id: "pair" });
  private readonly title = el("h2");
  private readonly verdict = el("p", { class: "verdict" });
  private readonly facts = el("dl");
  private readonly sketches = kMoments.map((moment) => new PairSketch(moment));
  private readonly shown = el("div", { class: "shown" });
  /** Of a contact, with its motion through the step; and of an intersection, which has none. */
  private readonly ofContact: HTMLElement[];
  private readonly ofIntersection = new PairSketch("The edge and the face");
  private readonly none = el("p", { class: "summary" });

  constructor(private readonly session: Session) {
    const { store } = session;
    const noun = nounOf(session.scene.header);
    const article = isPose(session.scene.header) ? "an" : "a";
    this.none.textContent = `No pair is selected. Choose ${article} ${noun} in the list, click on one in the scene, or press F for the first.`;
    const sketches = kMoments.map((moment, i) => {
      const figure = el("button", { type: "button", class: "moment", id: moment, title: `${moment} (${i + 1})` });
      figure.append(this.sketches[i].canvas, el("span", {}, moment));
      figure.addEventListener("click", () => {
        if (session.pair) store.set({ time: timeOf(session.pair, moment), playing: false });
      });
      return figure;
    });
    const play = button("Play the pair", "Go round from before to after (O)", () => {
      playPair(session);
    });
    const moments = el("div", { class: "moments" }, ...sketches);
    const gap = new GapPlot(session).element;
    this.ofContact = [moments, gap, play];
    this.ofIntersection.canvas.classList.add("large");
    const actions = el(
      "div",
      { class: "actions" },
      play,
      button("Alone / in the scene", "Show the pair alone (I)", () => {
        store.set({ isolated: !store.now.isolated });
      }),
      button("Back", "Leave the pair (Esc)", () => {
        session.deselect();
      }),
    );
    this.shown.append(this.title, this.verdict, moments, this.ofIntersection.canvas, gap, actions, this.facts);
    this.element.append(this.none, this.shown);
    store.follow(["step", "selected", "theme", "panel"], () => {
      this.refresh();
    });
  }

  private refresh(): void {
    const { pair, scene } = this.session;
    this.none.hidden = pair !== null;
    this.shown.hidden = pair === null;
    kMoments.forEach((moment, i) => {
      this.sketches[i].show(pair, pair ? timeOf(pair, moment) : 0);
    });
    if (!pair) return;
    const { contacts } = scene;
    for (const element of this.ofContact) element.hidden = pair.isIntersection;
    this.ofIntersection.canvas.hidden = !pair.isIntersection;
    this.ofIntersection.show(pair.isIntersection ? pair : null, pair.toi);
    const { name } = contacts.kindOf(pair.index);
    const both = objectsOf(pair.index, scene.objectOfVertex, contacts);
    const objects: Record<string, string> =
      scene.objects.numbers.length > 1 ? { objects: both.map((o) => scene.objects.nameOf(o)).join(", ") } : {};
    const weights = contacts.storedWeights(pair.index).map((w) => w.toFixed(4));
    const normal = contacts
      .normal(pair.index)
      .map((x) => x.toFixed(4))
      .join(", ");
    this.title.replaceChildren(
      el("b", { class: "first" }, nameOf(pair.first)),
      " meets ",
      el("b", { class: "second" }, nameOf(pair.second)),
    );
    const isNew: Record<string, string> = contacts.isNew(pair.index) ? { since: "new since the frame before" } : {};
    this.verdict.textContent = verdictOf(scene.header, contacts, pair.index);
    this.verdict.dataset.unresolved = String(contacts.isUnresolved(pair.index));
    if (pair.isIntersection) {
      const [along, u, v] = weights;
      const place = { "along the edge": along, "weights u, v": `${u}, ${v}` };
      this.fill({ kind: kKindNames[name], ...objects, ...isNew, ...place, normal });
      return;
    }
    this.fill({
      kind: kKindNames[name] ?? name,
      ...objects,
      ...isNew,
      "not before": String(pair.toiLower),
      [contacts.isUnresolved(pair.index) ? "may touch by" : "touches by"]: String(pair.toiUpper),
      "bracket's width": scientific(pair.toiUpper - pair.toiLower),
      "weights u, v": weights.join(", "),
      normal,
    });
  }

  private fill(facts: Record<string, string>): void {
    this.facts.replaceChildren(
      ...Object.entries(facts).flatMap(([name, value]) => [el("dt", {}, name), el("dd", {}, value)]),
    );
  }
}

function nameOf(feature: number[]): string {
  return `${["", "vertex", "edge", "face"][feature.length]} ${feature.join(" ")}`;
}

export function playPair({ pair, store }: Session): void {
  if (pair && !pair.isIntersection) store.set({ loop: [pair.before, pair.after], time: pair.before, playing: true });
}
