// What the page shows of itself to tests, and to who looks with the browser's tools.
import type { Session } from "./session";
import type { Stage } from "./view3d/stage";

declare global {
  interface Window {
    tamis?: { session: Session; stage: Stage | null; openedIn: number };
  }
}
