// The messages between a viewer without a scene of its own, in a frame, and the page around it.
import type { Theme } from "./store";

/** From the page around the viewer. */
export type ToViewer =
  /** Shows a scene: the bytes of tools/files/view/scene_bytes.hpp. `keep`: from where the scene before was seen. */
  | { tamis: "scene"; bytes: ArrayBuffer; keep?: boolean }
  /** Shows words over the scene, with a bar if `part`, in [0, 1], is given; no words: hides them. */
  | { tamis: "says"; words: string; part?: number }
  /** Chooses the theme, which is else the one of the system. */
  | { tamis: "theme"; theme: Theme };

/** From the viewer. */
export type FromViewer =
  /** The viewer listens. */
  | { tamis: "ready" }
  /** The scene is shown. */
  | { tamis: "shown"; contacts: number }
  /** The bytes are no scene. */
  | { tamis: "failed"; words: string }
  /** Files were dropped on the viewer, which reads none itself. */
  | { tamis: "files"; files: File[] };
