// A sentence over the scene, for some seconds.
import { el } from "../dom";

export function toast(): { element: HTMLElement; say: (message: string) => void } {
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
