// Opens the scene in the page, and makes panels and drawing.
import { Actions } from "./actions";
import { el } from "./dom";
import { draw } from "./draw";
import { fromHash, toHash } from "./hash";
import { keyTable, listenToKeys } from "./keys";
import { ContactList } from "./panels/contact_list";
import { header, tabs, tools } from "./panels/header";
import { Help } from "./panels/help";
import { PairPanel } from "./panels/pair_panel";
import { Sieve } from "./panels/sieve";
import { Timeline } from "./panels/timeline";
import { listenToClicks } from "./picking";
import { Ring } from "./panels/ring";
import { firstBadStep, isPose } from "./scene/header";
import { Scene } from "./scene/scene";
import { Session } from "./session";
import { initialState, Store } from "./store";
import { Stage } from "./view3d/stage";

/** Makes the drawing; if that fails, shows a sentence in its place and returns null. */
function openStage(place: HTMLElement, scene: Scene): Stage | null {
  const canvas = el("canvas", { id: "scene-canvas", tabindex: 0, "aria-label": "The scene" });
  place.append(canvas);
  const context = el("canvas").getContext("webgl2");
  if (context) return new Stage(canvas, scene, isSoftware(context));
  canvas.remove();
  place.append(
    el(
      "p",
      { class: "no-webgl", id: "no-webgl" },
      "This browser has no WebGL 2, so the scene cannot be drawn; the list, the times and the sieve work all the same. " +
        "Switch on hardware acceleration, or open this file in a current Firefox, Chrome, Edge or Safari.",
    ),
  );
  return null;
}

/** Whether the processor draws, as where there is no graphics card. */
function isSoftware(context: WebGL2RenderingContext): boolean {
  const names = context.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL ?? context.RENDERER;
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(String(context.getParameter(names)));
}

function keepHash(session: Session, stage: Stage | null): void {
  const { store } = session;
  let timer = 0;
  let written = "";
  const write = (): void => {
    timer = 0;
    if (store.now.playing) return;
    written = `#${toHash(store.now, stage?.camera.viewpoint ?? null)}`;
    history.replaceState(null, "", written);
  };
  const soon = (): void => {
    if (timer === 0) timer = window.setTimeout(write, 250);
  };
  store.follow(Object.keys(initialState) as (keyof typeof initialState)[], soon);
  stage?.drawn.push(soon);
  addEventListener("hashchange", () => {
    if (location.hash === written) return;
    restore(session, stage);
  });
}

function restore({ store, scene }: Session, stage: Stage | null): boolean {
  const { state, viewpoint } = fromHash(location.hash, scene);
  store.set(state);
  if (viewpoint && stage) stage.camera.jump(viewpoint);
  return viewpoint !== null;
}

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

function toast(): { element: HTMLElement; say: (message: string) => void } {
  const element = el("output", { class: "toast", id: "toast" });
  let timer = 0;
  const say = (message: string): void => {
    element.textContent = message;
    element.dataset.shown = "true";
    clearTimeout(timer);
    timer = window.setTimeout(() => (element.dataset.shown = "false"), 6000);
  };
  return { element, say };
}

function open(scene: Scene, began: number): void {
  const theme = matchMedia("(prefers-color-scheme: light)").matches ? "light" : "dark";
  const narrow = matchMedia("(max-width: 760px)").matches;
  const store = new Store({ ...initialState, up: scene.up, theme, panelOpen: !narrow });
  store.follow(["theme"], () => (document.documentElement.dataset.theme = store.now.theme));
  if (isPose(scene.header)) document.documentElement.dataset.pose = "true";
  const session = new Session(scene, store);
  const place = el("main", { class: "stage" });
  const { element: message, say } = toast();
  const { side, bar } = { side: panels(session), bar: new Timeline(session).element };
  document.body.replaceChildren(place, side, bar, message);
  const stage = openStage(place, scene);
  const actions = new Actions(session, stage);
  actions.say = say;
  place.append(header(session, actions), tools(session, actions));
  if (stage) {
    stage.camera.jump(actions.wholeStep());
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
  listenToKeys(table);
  // Begins at the end of the step, where all contacts have lit up.
  if (!location.hash) {
    session.showStep(firstBadStep(scene.header));
    store.set({ time: 1 });
  } else restore(session, stage);
  keepHash(session, stage);
  window.tamis = { session, stage, openedIn: performance.now() - began };
}

async function main(): Promise<void> {
  const began = performance.now();
  const data = document.getElementById("scene")?.textContent.trim() ?? "";
  try {
    if (data === "" || data.startsWith("<")) throw new Error("it holds no scene: 'tamis view' writes pages that do");
    open(await Scene.read(data), began);
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    document.body.replaceChildren(
      el("p", { class: "no-webgl", id: "unreadable" }, `This page cannot be shown: ${reason}.`),
    );
  }
}

// The element behind this script tells a whole page from one that is cut short.
addEventListener("DOMContentLoaded", () => void main());
