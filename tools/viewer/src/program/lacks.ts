// What this browser lacks. The module itself says which part of WebAssembly is missing (bindings/wasm/check_engine.js).

/** A sentence on what the page cannot do without; empty if all is there. */
export function lack(): string {
  const parts = { WebAssembly: "WebAssembly", Worker: "workers", DecompressionStream: "decompression streams" };
  const missing = Object.entries(parts).filter(([name]) => !(name in window));
  if (missing.length === 0) return "";
  const words = missing.map(([, part]) => part).join(" and no ");
  return `This browser has no ${words}: use Chrome 95, Firefox 113, Safari 16.4, or a newer one.`;
}

export function lacksWebGl(): boolean {
  return !document.createElement("canvas").getContext("webgl2");
}
