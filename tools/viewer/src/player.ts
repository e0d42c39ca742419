// Plays: advances the time through the step, in a loop around a pair's contact, or on to the next step of a sequence.
import type { Session } from "./session";

const kSecondsPerStep = 4;

/** Advances the time while the page plays; returns whether it does. */
export function advance(session: Session, seconds: number): boolean {
  const { store, scene } = session;
  const { playing, time, loop, step, selected } = store.now;
  if (!playing) return false;
  const span = loop[1] - loop[0];
  // A part of the step plays in two seconds, but no faster than the whole step.
  const rate = Math.min(1 / kSecondsPerStep, span / 2);
  const next = time + rate * seconds;
  if (next < loop[1]) {
    store.set({ time: Math.max(next, loop[0]) });
  } else if (selected < 0 && scene.stepCount > 1) {
    session.showStep((step + 1) % scene.stepCount, 0);
  } else {
    store.set({ time: loop[0] });
  }
  return true;
}
