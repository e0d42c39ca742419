// The viewer in its frame: it is sent scenes, and sends the files that are dropped on it.
import type { FromViewer, ToViewer } from "../messages";

export class ViewerFrame {
  /** Called with files that are dropped on the viewer. */
  onFiles: (files: File[]) => void = () => undefined;
  private readonly isReady: Promise<void>;
  private shown: (problem: string) => void = () => undefined;

  constructor(private readonly frame: HTMLIFrameElement) {
    this.isReady = new Promise((ready) => {
      addEventListener("message", ({ source, data }: MessageEvent<FromViewer>) => {
        if (source !== frame.contentWindow) return;
        if (data.tamis === "ready") ready();
        if (data.tamis === "shown") this.shown("");
        if (data.tamis === "failed") this.shown(data.words);
        if (data.tamis === "files") this.onFiles(data.files);
      });
    });
    // Set here, so that the first message meets its listener.
    frame.src = "viewer.html";
  }

  /** Waits until the scene is seen. */
  async show(bytes: ArrayBuffer, keep: boolean): Promise<void> {
    await this.isReady;
    const problem = await new Promise<string>((done) => {
      this.shown = done;
      this.send({ tamis: "scene", bytes, keep }, [bytes]);
    });
    if (problem !== "") throw new Error(problem);
  }

  async say(words: string): Promise<void> {
    await this.isReady;
    this.send({ tamis: "says", words }, []);
  }

  private send(message: ToViewer, moved: ArrayBuffer[]): void {
    this.frame.contentWindow?.postMessage(message, "*", moved);
  }
}
