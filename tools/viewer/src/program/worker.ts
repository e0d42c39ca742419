// Runs the module of tools/program beside the page, which stays alive whatever a question costs.
import { reasonOf } from "../reason";
import type { Facts, FromWorker, StepFile, ToWorker } from "./messages";

/** The module's functions, by tools/program/program.cpp. Pointers are places in HEAPU8. */
interface Module {
  HEAPU8: Uint8Array;
  UTF8ToString(place: number): string;
  _program_room(bytes: number): number;
  _program_open(startName: number, start: number, size: number, endName: number, end: number, endSize: number): number;
  _program_ask(length: number, all: number): number;
  _program_facts(): number;
  _program_scene(): number;
  _program_scene_bytes(): number;
}

declare function createTamis(settings: { wasmBinary: ArrayBuffer }): Promise<Module>;

const nothing = new ArrayBuffer(0);
let program: Module | null = null;

/** Copies bytes into the module's memory, which may grow for them. */
function put(module: Module, bytes: Uint8Array): number {
  const place = module._program_room(bytes.length);
  if (place === 0) throw new Error("the browser gives no memory for these files: take smaller ones");
  module.HEAPU8.set(bytes, place);
  return place;
}

function open(module: Module, start: StepFile, end: StepFile): string {
  const text = new TextEncoder();
  const files = [start, end].flatMap(({ name, bytes }) => [text.encode(`${name}\0`), new Uint8Array(bytes)]);
  const [startName, startBytes, endName, endBytes] = files.map((bytes) => put(module, bytes));
  const sizes = [start.bytes.byteLength, end.bytes.byteLength];
  return module.UTF8ToString(module._program_open(startName, startBytes, sizes[0], endName, endBytes, sizes[1]));
}

async function answer(message: ToWorker): Promise<FromWorker> {
  if (message.ask === "load") {
    program = await createTamis({ wasmBinary: message.wasm });
    return { problem: "", facts: null, scene: nothing };
  }
  if (!program) throw new Error("the module is not loaded");
  if (message.ask === "open") return { problem: open(program, message.start, message.end), dead: false };
  const problem = program.UTF8ToString(program._program_ask(message.length, message.all ? 1 : 0));
  if (problem !== "") return { problem, dead: false };
  const place = program._program_scene();
  const scene = program.HEAPU8.slice(place, place + program._program_scene_bytes()).buffer;
  return { problem, facts: JSON.parse(program.UTF8ToString(program._program_facts())) as Facts, scene };
}

addEventListener("message", ({ data }: MessageEvent<ToWorker>) => {
  answer(data)
    .catch((error: unknown): FromWorker => ({ problem: reasonOf(error), dead: true }))
    .then((told) => {
      postMessage(told, { transfer: "scene" in told ? [told.scene] : [] });
    })
    .catch((error: unknown) => {
      postMessage({ problem: reasonOf(error), dead: true });
    });
});
