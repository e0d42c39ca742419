// The objects of the page that tests, and users of the browser's tools, can reach.
import type { Session } from "./session";
import type { Stage } from "./view3d/stage";

declare global {
  interface Window {
    tamis?: { session: Session; stage: Stage | null; openedIn: number };
  }
}
