// Keeps a detector beside the page, which stays alive whatever a question costs. Positions come and go without copies.
import { load } from "tamis";

let detector;

async function answer({ mesh, start, end }) {
  if (mesh) {
    detector?.free();
    detector = (await load()).detector(mesh);
    return {};
  }
  const times = [];
  for (const { vertices, toiLower } of detector.contacts(start, end)) times.push({ vertices: [...vertices], toiLower });
  return { times, start, end };
}

addEventListener("message", ({ data }) => {
  answer(data)
    .catch((error) => ({ problem: error.message }))
    .then((told) => postMessage(told, told.start ? [told.start.buffer, told.end.buffer] : []));
});
