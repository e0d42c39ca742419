// A viewer in a frame: the page around it sends scenes, and is sent the files that are dropped here.
import type { FromViewer, ToViewer } from "./messages";
import { Opening } from "./panels/opening";
import { reasonOf } from "./reason";
import { Scene } from "./scene/scene";
import { SceneFile } from "./scene/scene_file";
import type { Theme } from "./store";
import { Viewer } from "./viewer";

const tell = (message: FromViewer): void => {
  window.parent.postMessage(message, "*");
};

class Framed {
  private readonly opening = new Opening();
  private viewer: Viewer | null = null;
  /** Null: the system's. */
  private theme: Theme | null = null;
  /** The scene that is being opened, after which the next one is. */
  private last = Promise.resolve();

  take(message: ToViewer): void {
    if (message.tamis === "says") this.opening.show(message.words, message.part ?? null);
    if (message.tamis === "theme") this.wear(message.theme);
    if (message.tamis === "scene") this.last = this.last.then(() => this.show(message.bytes, message.keep === true));
  }

  private wear(theme: Theme): void {
    this.theme = theme;
    document.documentElement.dataset.theme = theme;
    this.viewer?.session.store.set({ theme });
  }

  private async show(bytes: ArrayBuffer, keep: boolean): Promise<void> {
    try {
      const scene = await Scene.read(new SceneFile(new Uint8Array(bytes)), this.opening.say);
      const look = keep ? (this.viewer?.look() ?? "") : "";
      this.theme = this.viewer?.session.store.now.theme ?? this.theme;
      this.viewer?.close();
      this.viewer = null;
      const began = performance.now();
      this.viewer = await Viewer.open(scene, this.opening.say, look);
      const { session, stage } = this.viewer;
      if (this.theme) session.store.set({ theme: this.theme });
      window.tamis = { session, stage, openedIn: performance.now() - began };
      tell({ tamis: "shown", contacts: scene.contacts.count });
    } catch (error) {
      tell({ tamis: "failed", words: reasonOf(error) });
    }
    this.opening.show("", null);
  }
}

function listenToDrops(): void {
  const { documentElement: root } = document;
  addEventListener("dragover", (event) => {
    event.preventDefault();
    root.dataset.drop = "true";
  });
  addEventListener("dragleave", () => delete root.dataset.drop);
  addEventListener("drop", (event) => {
    event.preventDefault();
    delete root.dataset.drop;
    const files = [...(event.dataTransfer?.files ?? [])];
    if (files.length > 0) tell({ tamis: "files", files });
  });
}

export function listenToParent(): void {
  const framed = new Framed();
  addEventListener("message", ({ source, data }: MessageEvent<ToViewer>) => {
    if (source === window.parent) framed.take(data);
  });
  listenToDrops();
  document.body.replaceChildren();
  tell({ tamis: "ready" });
}
