// Refuses an engine that lacks a part of WebAssembly, before it compiles the module. Each part has a tiny module of its own.
{
  const parts = {
    '128-bit SIMD (Chrome 91, Firefox 89, Safari 16.4, Node 16.4)':
      [1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11],
    'exceptions (Chrome 95, Firefox 100, Safari 15.2, Node 17)':
      [1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 10, 8, 1, 6, 0, 6, 64, 25, 11, 11],
  };
  for (const [part, code] of Object.entries(parts))
    if (typeof WebAssembly !== 'object' || !WebAssembly.validate(new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, ...code])))
      throw new Error(`tamis: this engine's WebAssembly has no ${part}: use that version or a newer one`);
}
