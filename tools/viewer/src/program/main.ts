// The site's first page: a step, how long it is, what Tamis finds in it, and the viewer that shows it.
import { reasonOf } from "../reason";
import { builtIn, runScript } from "./built_in";
import { OwnFiles } from "./files";
import { ViewerFrame } from "./frame";
import { lack, lacksWebGl } from "./lacks";
import { Program, type Source } from "./program";
import { wordsOf } from "./words";

declare global {
  interface Window {
    /** By module.js: the script that loads the module, and the module, compressed, in base64. */
    tamisModule?: { script: string; wasm: string };
    /** Of the worker, by build_program.mjs. */
    tamisWorker?: string;
    /** How long it took until the first scene was seen, in milliseconds. */
    tamisFirst?: number;
  }
}

const at = (id: string): HTMLElement => document.getElementById(id)!;
const inputAt = (id: string): HTMLInputElement => at(id) as HTMLInputElement;

/** With a capital, but for names of files, and a full stop. */
function sentence(words: string): string {
  const first = /^\S*\.\S/.test(words) ? words.charAt(0) : words.charAt(0).toUpperCase();
  return `${first}${words.slice(1).replace(/\.$/, "")}.`;
}

class Page {
  private readonly viewer = new ViewerFrame(at("viewer") as HTMLIFrameElement);
  private readonly own = new OwnFiles();
  private readonly length = inputAt("length");
  private program: Program | null = null;
  private busy = false;
  /** What was asked while another question was answered: the last one counts. */
  private next: (() => Promise<void>) | null = null;

  async start(): Promise<void> {
    this.listen();
    this.showLength();
    const lacking = lack();
    if (lacking !== "") throw new Error(lacking);
    if (lacksWebGl()) at("lacks").textContent = "This browser has no WebGL 2, so contacts are listed, and not drawn.";
    await this.choose("cloth");
  }

  private listen(): void {
    for (const button of document.querySelectorAll<HTMLButtonElement>("[data-step]"))
      button.onclick = () => void this.choose(button.dataset.step ?? "");
    at("all").onclick = () => void this.run(() => this.find(true, true));
    at("first").onclick = () => void this.run(() => this.find(false, true));
    at("stop").onclick = () => {
      this.next = null;
      this.program?.stop("stopped: take a shorter step or a smaller mesh, or ask again");
    };
    this.length.oninput = () => {
      this.showLength();
    };
    this.length.onchange = () => void this.run(() => this.find(true, true));
    const chooser = inputAt("files");
    at("own").onclick = () => {
      chooser.click();
    };
    chooser.onchange = () => {
      this.take([...(chooser.files ?? [])]);
      chooser.value = "";
    };
    this.viewer.onFiles = (files) => {
      this.take(files);
    };
    addEventListener("dragover", (event) => {
      event.preventDefault();
    });
    addEventListener("drop", (event) => {
      event.preventDefault();
      this.take([...(event.dataTransfer?.files ?? [])]);
    });
  }

  private showLength(): void {
    at("times").textContent = `${Number(this.length.value)} ×`;
  }

  private choose(name: string): Promise<void> {
    return this.run(() => this.open(builtIn(name), name));
  }

  private take(files: File[]): void {
    if (files.length === 0) return;
    void this.run(async () => {
      const source = this.own.take(files);
      if (source) await this.open(source, "own", 1);
      else this.tell(`${files[0].name} is the start. Now drop the file of the end.`);
    });
  }

  private async open(source: Source, name: string, length = 3): Promise<void> {
    this.tell("Loading …");
    const program = await this.loaded();
    this.tell("Reading the step …");
    await program.open(source);
    for (const button of document.querySelectorAll<HTMLElement>("[data-step], #own"))
      button.setAttribute("aria-pressed", String((button.dataset.step ?? "own") === name));
    this.length.value = String(length);
    this.showLength();
    await this.find(true, false);
  }

  private async loaded(): Promise<Program> {
    if (this.program) return this.program;
    if (!window.tamisModule) await runScript("module.js");
    if (!window.tamisModule) throw new Error("module.js holds no module: load this page again");
    const { script, wasm } = window.tamisModule;
    this.program = new Program(`${script}\n${window.tamisWorker ?? ""}`, wasm);
    return this.program;
  }

  private async find(all: boolean, keep: boolean): Promise<void> {
    const program = await this.loaded();
    this.tell(all ? "Finding all contacts …" : "Finding the first contact …");
    const { facts, scene } = await program.find(Number(this.length.value), all);
    await this.viewer.show(scene, keep);
    window.tamisFirst ??= performance.now();
    this.tell(wordsOf(facts, all));
  }

  private tell(words: string, isProblem = false): void {
    const says = at("says");
    says.textContent = words;
    says.classList.toggle("problem", isProblem);
  }

  /** One question after the other. What fails is said, and the page goes on. */
  private async run(question: () => Promise<void>): Promise<void> {
    this.next = question;
    if (this.busy) return;
    this.busy = true;
    document.body.dataset.busy = "true";
    while (this.next) {
      const { next } = this;
      this.next = null;
      try {
        await next();
      } catch (error) {
        this.tell(sentence(reasonOf(error)), true);
      }
    }
    this.busy = false;
    delete document.body.dataset.busy;
  }
}

new Page().start().catch((error: unknown) => {
  const says = at("says");
  says.textContent = reasonOf(error);
  says.classList.add("problem");
});
