// Code that shaders share: a vertex on its straight line through the step, and the colour scale of time.
import { colourOfTime } from "../colours";
import { DataTexture, LinearFilter, RGBAFormat, SRGBColorSpace, UnsignedByteType } from "three";

/** The position at `time`; `position`, as three.js names it, is the position at the start. */
export const kMotion = /* glsl */ `
attribute vec3 end;
uniform float time;
vec3 moved() { return mix(position, end, time); }
`;

/** The colour scale of time as a texture, whose coordinate s is the time of impact. */
export function timeScale(): DataTexture {
  const width = 256;
  const pixels = new Uint8Array(4 * width);
  for (let i = 0; i < width; ++i) pixels.set([...colourOfTime(i / (width - 1)), 255], 4 * i);
  const texture = new DataTexture(pixels, width, 1, RGBAFormat, UnsignedByteType);
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearFilter;
  texture.colorSpace = SRGBColorSpace;
  texture.needsUpdate = true;
  return texture;
}
