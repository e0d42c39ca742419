// The scene in the window: makes panels and drawing, and takes them away again.
import { Actions } from "./actions";
import { keepHash, restore } from "./address";
import { el } from "./dom";
import { draw } from "./draw";
import { toHash } from "./hash";
import { keyTable, listenToKeys } from "./keys";
import { ContactList } from "./panels/contact_list";
import { header, tabs, tools } from "./panels/header";
import { Help } from "./panels/help";
import type { Say } from "./panels/opening";
import { PairPanel } from "./panels/pair_panel";
import { Sieve } from "./panels/sieve";
import { toast } from "./panels/toast";
import { Timeline } from "./panels/timeline";
import { listenToClicks } from "./picking";
import { Ring } from "./panels/ring";
import { firstBadStep, isPose } from "./scene/header";
import type { Scene } from "./scene/scene";
import { Session } from "./session";
import { initialState, Store, type ViewState } from "./store";
import { openStage } from "./view3d/open_stage";
import type { Stage } from "./view3d/stage";

function panels(session: Session): HTMLElement {
  const { store } = session;
  const bodies = {
    contacts: new ContactList(session).element,
    pair: new PairPanel(session).element,
    sieve: new Sieve(session).element,
  };
  const side = el("aside", { class: "side", id: "panel" }, tabs(session), ...Object.values(bodies));
  store.follow(["panel", "panelOpen"], () => {
    for (const [name, body] of Object.entries(bodies)) body.hidden = !store.now.panelOpen || name !== store.now.panel;
    side.dataset.open = String(store.now.panelOpen);
  });
  return side;
}

export class Viewer {
  /** Ends what listens to the whole document. */
  private readonly end = new AbortController();

  private constructor(
    readonly session: Session,
    readonly stage: Stage | null,
    private readonly actions: Actions,
  ) {}

  /**
   * Shows the scene in the window, in place of what it shows. `look`: of another viewer. Without one the address says what
   * is shown, and follows it.
   */
  static async open(scene: Scene, say: Say, look?: string): Promise<Viewer> {
    await say("Sorting contacts", 0.7);
    const session = new Session(scene, new Store(firstState(scene)));
    const place = el("main", { class: "stage" });
    const { element: message, say: announce } = toast();
    const { side, bar } = { side: panels(session), bar: new Timeline(session).element };
    await say("Drawing", 0.85);
    document.body.replaceChildren(place, side, bar, message);
    const stage = openStage(place, scene);
    const actions = new Actions(session, stage);
    actions.say = announce;
    const viewer = new Viewer(session, stage, actions);
    viewer.furnish(place);
    viewer.begin(look);
    return viewer;
  }

  /** What is seen and from where, without selection, for the viewer of another scene. */
  look(): string {
    const { store } = this.session;
    const state = { ...store.now, step: 0, selected: -1, isolated: false, panel: initialState.panel };
    return `#${toHash(state, this.stage?.camera.viewpoint ?? null)}`;
  }

  close(): void {
    this.end.abort();
    this.stage?.close();
  }

  /** Puts buttons, ring, keys and their list around the drawing. */
  private furnish(place: HTMLElement): void {
    const { session, stage, actions } = this;
    const { store, scene } = session;
    const { dataset } = document.documentElement;
    store.follow(["theme"], () => (dataset.theme = store.now.theme));
    if (isPose(scene.header)) dataset.pose = "true";
    else delete dataset.pose;
    place.append(header(session, actions), tools(session, actions));
    if (stage) {
      draw(session, stage, actions);
      listenToClicks(session, stage);
      place.append(new Ring(session, stage).element);
    }
    const table = keyTable(session, actions);
    const help = new Help(table, stage?.cost ?? null);
    actions.help = () => {
      help.open();
    };
    document.body.append(help.element);
    listenToKeys(table, this.end.signal);
  }

  /** Begins at the end of the step, where all contacts have lit up. */
  private begin(look: string | undefined): void {
    const { session, stage, actions } = this;
    const hash = look ?? location.hash;
    if (hash === "") {
      session.showStep(firstBadStep(session.scene.header));
      session.store.set({ time: 1 });
    }
    if (hash === "" || !restore(session, stage, hash)) stage?.camera.jump(actions.wholeStep());
    if (look === undefined) keepHash(session, stage);
  }
}

function firstState(scene: Scene): ViewState {
  const theme = matchMedia("(prefers-color-scheme: light)").matches ? "light" : "dark";
  const narrow = matchMedia("(max-width: 760px)").matches;
  return { ...initialState, up: scene.up, theme, panelOpen: !narrow };
}
