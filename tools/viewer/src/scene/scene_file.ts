// Reads the scene that tools/files/view/scene_bytes.cpp writes into the page: header and columns, compressed by zlib, as base64.
import type { Say } from "../panels/opening";
import { fromDifferences, fromPlanes } from "./columns";
import type { SceneHeader } from "./header";

function bytesOfBase64(text: string): Uint8Array<ArrayBuffer> {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** So many characters are read at once. */
const kSlice = 2 ** 22;

/** Decodes base64 with line breaks, and inflates it. */
async function inflate(text: string, say: Say): Promise<Uint8Array> {
  const { readable, writable } = new DecompressionStream("deflate");
  const writer = writable.getWriter();
  const megabytes = (length: number): string => (length / 1e6).toFixed(1);
  const feed = async (): Promise<void> => {
    let rest = "";
    for (let at = 0; at < text.length; at += kSlice) {
      await say(`Reading ${megabytes(at)} of ${megabytes(text.length)} MB`, (0.4 * at) / text.length);
      const characters = rest + text.slice(at, at + kSlice).replace(/\s+/g, "");
      const whole = characters.length - (characters.length % 4);
      rest = characters.slice(whole);
      await writer.write(bytesOfBase64(characters.slice(0, whole)));
    }
    await writer.write(bytesOfBase64(rest));
    await writer.close();
  };
  const [inflated] = await Promise.all([new Response(readable).arrayBuffer(), feed()]);
  return new Uint8Array(inflated);
}

/** The columns of a scene by name. */
export class SceneFile {
  readonly header: SceneHeader;
  private readonly columns: Uint8Array;

  /** Throws unless the bytes are those of a scene. */
  constructor(bytes: Uint8Array) {
    const length = new DataView(bytes.buffer).getUint32(0, true);
    this.header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length))) as SceneHeader;
    this.columns = bytes.subarray(4 + length);
  }

  static async read(text: string, say: Say): Promise<SceneFile> {
    return new SceneFile(await inflate(text, say));
  }

  integers(name: string, width: number): Uint32Array {
    return fromDifferences(this.bytes(name, 4), width);
  }

  /** The frames, each written as its difference from the frame before. */
  frames(): Uint32Array[] {
    const width = 3 * this.header.mesh.vertices;
    const bytes = this.bytes("positions", 4);
    const frames = this.header.names.map((_, i) =>
      fromDifferences(bytes.subarray(4 * width * i, 4 * width * (i + 1)), 3),
    );
    for (let f = 1; f < frames.length; ++f) for (let i = 0; i < width; ++i) frames[f][i] += frames[f - 1][i];
    return frames;
  }

  planes(name: string, size: number): Uint8Array<ArrayBuffer> {
    return fromPlanes(this.bytes(name, size), size);
  }

  private bytes(name: string, size: number): Uint8Array {
    const { offset, count } = this.header.columns[name];
    return this.columns.subarray(offset, offset + size * count);
  }
}
