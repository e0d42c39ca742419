// Uniforms that every material of the scene holds: set once, seen by all.
import { Color, Vector2, Vector3, type IUniform } from "three";
import { timeScale } from "./shaders";

export interface SharedUniforms {
  [name: string]: IUniform;
  time: IUniform<number>;
  /** Times of impact that the brush holds. */
  brush: IUniform<Vector2>;
  scale: IUniform;
  /** Width and height in pixels of the drawing. */
  size: IUniform<Vector2>;
  pixelRatio: IUniform<number>;
  /** Around which the surface stays while a pair is isolated, and how far; 0: all of it. */
  focus: IUniform<Vector3>;
  focusRadius: IUniform<number>;
  /** Around the selected pair, in pixels of the drawing: x, y and radius; radius 0: none. */
  window: IUniform<Vector3>;
  /** What is nearer to the eye than this hides the pair. */
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
