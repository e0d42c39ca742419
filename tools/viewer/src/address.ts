// The address of the page says what is shown: it follows the state, and the state follows it.
import { fromHash, toHash } from "./hash";
import type { Session } from "./session";
import { initialState } from "./store";
import type { Stage } from "./view3d/stage";

/** Writes the state into the address while it changes, and shows the state of an address that is entered. */
export function keepHash(session: Session, stage: Stage | null): void {
  const { store } = session;
  let timer = 0;
  let written = "";
  const write = (): void => {
    timer = 0;
    if (store.now.playing) return;
    written = `#${toHash(store.now, stage?.camera.viewpoint ?? null)}`;
    history.replaceState(null, "", written);
  };
  const soon = (): void => {
    if (timer === 0) timer = window.setTimeout(write, 250);
  };
  store.follow(Object.keys(initialState) as (keyof typeof initialState)[], soon);
  stage?.drawn.push(soon);
  addEventListener("hashchange", () => {
    if (location.hash === written) return;
    restore(session, stage, location.hash);
  });
}

/** Shows the state that a hash describes; returns whether it says from where the scene is seen. */
export function restore({ store, scene }: Session, stage: Stage | null, hash: string): boolean {
  const { state, viewpoint } = fromHash(hash, scene);
  store.set(state);
  if (viewpoint && stage) stage.camera.jump(viewpoint);
  return viewpoint !== null;
}
