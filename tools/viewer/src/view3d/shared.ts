// Uniforms that all materials of the scene share.
import { Color, Vector2, Vector3, type IUniform } from "three";
import { timeScale } from "./shaders";

export interface SharedUniforms {
  [name: string]: IUniform;
  time: IUniform<number>;
  /** The times of impact between which contacts are chosen by the brush. */
  brush: IUniform<Vector2>;
  scale: IUniform;
  /** Width and height in pixels of the drawing. */
  size: IUniform<Vector2>;
  pixelRatio: IUniform<number>;
  /** While a pair is isolated, the surface is drawn only within focusRadius of focus; 0: everywhere. */
  focus: IUniform<Vector3>;
  focusRadius: IUniform<number>;
  /** The circle around the selected pair, in pixels of the drawing: x, y and radius; radius 0: none. */
  window: IUniform<Vector3>;
  /** Surface in the circle that is nearer to the eye than this depth hides the pair, and is cut away. */
  windowDepth: IUniform<number>;
  ink: IUniform<Color>;
}

export function sharedUniforms(): SharedUniforms {
  return {
    time: { value: 0 },
    brush: { value: new Vector2(0, 1) },
    scale: { value: timeScale() },
    size: { value: new Vector2(1, 1) },
    pixelRatio: { value: 1 },
    focus: { value: new Vector3() },
    focusRadius: { value: 0 },
    window: { value: new Vector3() },
    windowDepth: { value: 0 },
    ink: { value: new Color() },
  };
}
