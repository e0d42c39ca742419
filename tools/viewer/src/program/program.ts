// The module in a worker, which is made anew when it has been stopped or has failed.
import { inflated } from "./inflate";
import type { Facts, FromWorker, StepFile, ToWorker } from "./messages";

/** The two files of a step; each call reads them anew. */
export type Source = () => Promise<[StepFile, StepFile]>;

export interface Found {
  facts: Facts;
  scene: ArrayBuffer;
}

export class Program {
  private worker: Worker | null = null;
  private source: Source | null = null;
  private refuse: (reason: Error) => void = () => undefined;

  /** `script`: of the worker. `wasm`: the module, compressed, in base64. */
  constructor(
    private readonly script: string,
    private readonly wasm: string,
  ) {}

  async open(source: Source): Promise<void> {
    this.source = null;
    const [start, end] = await source();
    await this.ask({ ask: "open", start, end }, [start.bytes, end.bytes]);
    this.source = source;
  }

  /** Asks about the step that is open: for all its contacts, or for the first. */
  async find(length: number, all: boolean): Promise<Found> {
    const { source } = this;
    if (!source) throw new Error("no step is open: choose one, or drop two files");
    if (!this.worker) await this.open(source);
    const told = await this.ask({ ask: "find", length, all }, []).catch((error: unknown) => {
      this.stop(""); // a module's memory never shrinks: the next question has a new one
      throw error;
    });
    if (!told.facts) throw new Error("the module has not answered");
    return { facts: told.facts, scene: told.scene };
  }

  /** Ends the question that is being answered. */
  stop(reason: string): void {
    this.worker?.terminate();
    this.worker = null;
    this.refuse(new Error(reason));
  }

  private async ask(message: ToWorker, moved: ArrayBuffer[]): Promise<{ facts: Facts | null; scene: ArrayBuffer }> {
    if (!this.worker) {
      this.worker = new Worker(URL.createObjectURL(new Blob([this.script], { type: "text/javascript" })));
      const wasm = await inflated(this.wasm);
      await this.send({ ask: "load", wasm }, [wasm]);
    }
    return this.send(message, moved);
  }

  private async send(message: ToWorker, moved: ArrayBuffer[]): Promise<{ facts: Facts | null; scene: ArrayBuffer }> {
    const told = await new Promise<FromWorker>((done, refuse) => {
      const { worker } = this;
      if (!worker) throw new Error("stopped");
      this.refuse = refuse;
      worker.onmessage = ({ data }: MessageEvent<FromWorker>) => {
        done(data);
      };
      worker.onerror = ({ message: words }) => {
        done({ problem: words, dead: true });
      };
      worker.postMessage(message, moved);
    });
    if ("scene" in told) return told;
    if (told.dead) this.stop(told.problem);
    if (told.problem !== "") throw new Error(told.problem);
    return { facts: null, scene: new ArrayBuffer(0) };
  }
}
