// Selects the contact at the place of a click in the scene.
import type { Session } from "./session";
import type { Stage } from "./view3d/stage";
import { mix, type Vec3 } from "./vectors";

const kReachPixels = 14;

/** The drawn contact nearest to a place on the canvas, in CSS pixels; -1 if none is near. */
export function contactAt(session: Session, stage: Stage, x: number, y: number): number {
  const { start, end, toi } = session.view.marks;
  const { time } = session.store.now;
  const { first } = session.view.step;
  let best = -1;
  let bestDistance = kReachPixels;
  let bestDepth = Infinity;
  for (const i of session.drawn) {
    const k = i - first;
    if (toi[k] > time + 1e-6) continue;
    const place = (at: Float32Array): Vec3 => [at[3 * k], at[3 * k + 1], at[3 * k + 2]];
    const seen = stage.project(mix(place(start), place(end), time));
    if (!seen) continue;
    // Distances count in steps of two pixels; of contacts at the same distance the one in front is taken.
    const distance = Math.round(Math.hypot(seen.x - x, seen.y - y) / 2) * 2;
    if (distance < bestDistance || (distance === bestDistance && seen.depth < bestDepth)) {
      best = i;
      bestDistance = distance;
      bestDepth = seen.depth;
    }
  }
  return best;
}

export function listenToClicks(session: Session, stage: Stage): void {
  let down: [number, number] | null = null;
  stage.canvas.addEventListener("pointerdown", (event) => (down = [event.clientX, event.clientY]));
  stage.canvas.addEventListener("pointerup", (event) => {
    const wasDrag = !down || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 4;
    if (wasDrag || session.store.now.isolated || event.button !== 0) return;
    const { left, top } = stage.canvas.getBoundingClientRect();
    session.select(contactAt(session, stage, event.clientX - left, event.clientY - top));
  });
}
