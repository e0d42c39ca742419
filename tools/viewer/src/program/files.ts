// Files that are dropped or chosen. They are read here, and nowhere else.
import type { StepFile } from "./messages";
import type { Source } from "./program";

/** A page has 2 GB at most, of which a mesh takes ten times its file. */
const kMostBytes = 200e6;

const read = async (file: File): Promise<StepFile> => ({ name: file.name, bytes: await file.arrayBuffer() });

const megabytes = (bytes: number): string => `${Math.ceil(bytes / 1e6).toLocaleString("en")} MB`;

function require(file: File): void {
  if (file.size > kMostBytes)
    throw new Error(
      `${file.name} has ${megabytes(file.size)}, and this page reads files up to ${megabytes(kMostBytes)}: ` +
        "'tamis view START END' takes larger ones",
    );
}

/** Files on their way to a step. */
export class OwnFiles {
  private first: File | null = null;

  /** The step, once both its files are there; null after the first one alone. */
  take(files: File[]): Source | null {
    const sorted = [...files].sort((a, b) => a.name.localeCompare(b.name, "en", { numeric: true }));
    const all = this.first && files.length === 1 ? [this.first, files[0]] : sorted;
    this.first = null;
    if (all.length > 2) throw new Error(`these are ${all.length} files: a step has two, its start and its end`);
    all.forEach(require);
    if (all.length === 1) {
      [this.first] = all;
      return null;
    }
    const [start, end] = all;
    return async () => [await read(start), await read(end)];
  }
}
