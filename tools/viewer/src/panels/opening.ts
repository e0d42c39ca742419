// What the page does before it shows a scene: a sentence and a bar. Also what the page around the viewer says.
import { el } from "../dom";

/** Says what is being done, and how much of all is done; waits until that can be seen. */
export type Say = (words: string, part: number) => Promise<void>;

/** What takes less time than this, in milliseconds, is not said. */
const kNoticeable = 100;

export class Opening {
  private readonly words = el("span", {});
  private readonly bar = el("progress", { max: 1, value: 0, "aria-label": "Progress" });
  readonly element = el("p", { class: "opening", id: "opening", role: "status" }, this.words, this.bar);
  private seen = performance.now();

  /** Shows words, and a bar if `part` is a number; hides both if there are no words. */
  show(words: string, part: number | null): void {
    this.element.hidden = words === "";
    this.words.textContent = words;
    this.bar.hidden = part === null;
    if (part !== null) this.bar.value = part;
    if (words !== "" && !this.element.isConnected) document.body.append(this.element);
  }

  readonly say: Say = async (words, part) => {
    this.show(`${words} …`, part);
    if (performance.now() - this.seen < kNoticeable) return;
    await painted();
    this.seen = performance.now();
  };
}

/** Waits for the next frame; a tab in the background has none, so not for long. */
function painted(): Promise<void> {
  return new Promise((done) => {
    const timer = setTimeout(done, 200);
    requestAnimationFrame(() => {
      clearTimeout(timer);
      setTimeout(done);
    });
  });
}
