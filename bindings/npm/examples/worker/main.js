// Asks the worker, and writes what it finds into the page.
const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });

/** One question at a time: the next one waits for its answer. */
function ask(message, transfer = []) {
  return new Promise((resolve, reject) => {
    worker.onmessage = ({ data }) => (data.problem ? reject(new Error(data.problem)) : resolve(data));
    worker.onerror = ({ message: reason }) => reject(new Error(reason));
    worker.postMessage(message, transfer);
  });
}

async function main() {
  await ask({ mesh: { faces: new Int32Array([0, 1, 2, 3, 4, 5]) } });
  const start = new Float64Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, 1, 1, 0.5, 2, 0.5, 1, 2]);
  const end = start.map((x, i) => (i === 11 ? -1 : x));
  const { times } = await ask({ start, end }, [start.buffer, end.buffer]);
  return times.map(({ vertices, toiLower }) => `vertex ${vertices[0]} meets the face at ${toiLower.toFixed(6)}`).join("\n");
}

main().then(
  (text) => (document.body.textContent = text),
  (error) => (document.body.textContent = error.message),
);
