// The list of keys.
import { button, el } from "../dom";
import type { KeyAction } from "../keys";
import type { FrameCost } from "../view3d/stage";

export class Help {
  readonly element = el("dialog", { id: "help", "aria-label": "Keys" });
  private readonly costs = el("p", { class: "summary" });

  constructor(
    table: Record<string, KeyAction[]>,
    private readonly cost: FrameCost | null,
  ) {
    const sections = Object.entries(table).map(([name, actions]) =>
      el(
        "section",
        {},
        el("h3", {}, name),
        el(
          "dl",
          {},
          ...actions.flatMap((action) => [el("dt", {}, el("kbd", {}, labelOf(action))), el("dd", {}, action.does)]),
        ),
      ),
    );
    const close = button("Close", "Close (Esc)", () => {
      this.element.close();
    });
    this.element.append(
      el("header", {}, el("h2", {}, "Keys"), close),
      el("div", { class: "keys" }, ...sections),
      el(
        "p",
        { class: "summary" },
        "Mouse: drag turns, right drag shifts, wheel zooms. Touch: one finger turns, two shift and zoom. Click or tap a contact to select it; drag in the histogram to keep a part of the times.",
      ),
      this.costs,
    );
    this.element.addEventListener("click", (event) => {
      if (event.target === this.element) this.element.close();
    });
  }

  open(): void {
    const { cost } = this;
    this.costs.textContent = cost
      ? `Last frame: ${cost.drawCalls} draw calls, ${cost.triangles} triangles, ${cost.cpu.toFixed(1)} ms of this page's own work.`
      : "";
    this.element.showModal();
  }
}

const labelOf = ({ keys, label }: KeyAction): string => label ?? keys.map((key) => key.toUpperCase()).join(" ");
