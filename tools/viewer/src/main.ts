// Shows the scene that stands in the page, or, in a frame, the scenes that the page around it sends.
import { el } from "./dom";
import { listenToParent } from "./framed";
import { Opening } from "./panels/opening";
import { reasonOf } from "./reason";
import { Scene } from "./scene/scene";
import { SceneFile } from "./scene/scene_file";
import { Viewer } from "./viewer";

async function showOwn(text: string): Promise<void> {
  const began = performance.now();
  const opening = new Opening();
  document.body.replaceChildren();
  const scene = await Scene.read(await SceneFile.read(text, opening.say), opening.say);
  const { session, stage } = await Viewer.open(scene, opening.say);
  window.tamis = { session, stage, openedIn: performance.now() - began };
}

async function main(): Promise<void> {
  const text = document.getElementById("scene")?.textContent.trim() ?? "";
  const hasScene = text !== "" && !text.startsWith("<");
  try {
    if (hasScene) await showOwn(text);
    else if (window.parent !== window) listenToParent();
    else throw new Error("it holds no scene: 'tamis view' writes pages that do");
  } catch (error) {
    const sentence = `This page cannot be shown: ${reasonOf(error)}.`;
    document.body.replaceChildren(el("p", { class: "no-webgl", id: "unreadable" }, sentence));
  }
}

// The element behind this script tells a whole page from one that is cut short.
addEventListener("DOMContentLoaded", () => void main());
