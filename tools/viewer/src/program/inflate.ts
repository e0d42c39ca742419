// What tools/program/module.mjs and make_step.mjs have compressed.

/** The bytes that stand in a text: deflated, in base64. */
export function inflated(base64: string): Promise<ArrayBuffer> {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();
}
