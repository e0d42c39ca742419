// Makes the drawing, or says why there is none.
import { el } from "../dom";
import type { Scene } from "../scene/scene";
import { Stage } from "./stage";

/** Makes the drawing; if that fails, shows a sentence in its place and returns null. */
export function openStage(place: HTMLElement, scene: Scene): Stage | null {
  const canvas = el("canvas", { id: "scene-canvas", tabindex: 0, "aria-label": "The scene" });
  place.append(canvas);
  const context = el("canvas").getContext("webgl2");
  if (context) return new Stage(canvas, scene, isSoftware(context));
  canvas.remove();
  place.append(
    el(
      "p",
      { class: "no-webgl", id: "no-webgl" },
      "This browser has no WebGL 2, so the scene cannot be drawn; the list, the times and the sieve work all the same. " +
        "Switch on hardware acceleration, or open this file in a current Firefox, Chrome, Edge or Safari.",
    ),
  );
  return null;
}

/** Whether the processor draws, as where there is no graphics card. */
function isSoftware(context: WebGL2RenderingContext): boolean {
  const names = context.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL ?? context.RENDERER;
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(String(context.getParameter(names)));
}
