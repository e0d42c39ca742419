// Draws segments with a width in pixels in one draw call: rods, features, normals, trails.
import {
  BufferAttribute,
  Group,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  Mesh,
  ShaderMaterial,
  type IUniform,
} from "three";
import { kDraftSegments, kSegmentSlice, thinned } from "./large";
import type { SharedUniforms } from "./shared";

const kVertex = /* glsl */ `
attribute vec2 corner;
attribute vec3 fromStart;
attribute vec3 fromEnd;
attribute vec3 toStart;
attribute vec3 toEnd;
attribute vec4 colour;
uniform float time;
uniform float width;
uniform float nearness;
uniform vec2 size;
uniform float pixelRatio;
varying vec4 vColour;
void main() {
  vec4 from = modelViewMatrix * vec4(mix(fromStart, fromEnd, time), 1.0);
  vec4 to = modelViewMatrix * vec4(mix(toStart, toEnd, time), 1.0);
  // What is behind the eye is cut off, or its projection would point the other way.
  float near = -1e-4;
  if (from.z > near && to.z < near) from = mix(to, from, (near - to.z) / (from.z - to.z));
  if (to.z > near && from.z < near) to = mix(from, to, (near - from.z) / (to.z - from.z));
  vec4 a = projectionMatrix * from;
  vec4 b = projectionMatrix * to;
  vec2 way = (b.xy / b.w - a.xy / a.w) * size;
  way = dot(way, way) > 0.0 ? normalize(way) : vec2(1.0, 0.0);
  vec4 at = corner.x < 0.0 ? a : b;
  vec2 offset = (corner.x * way + corner.y * vec2(-way.y, way.x)) * width * pixelRatio;
  at.xy += offset / size * at.w;
  at.z -= nearness * at.w;
  gl_Position = at;
  vColour = colour;
}`;

const kFragment = /* glsl */ `
uniform float opacity;
varying vec4 vColour;
void main() {
  gl_FragColor = vec4(vColour.rgb, vColour.a * opacity);
  #include <colorspace_fragment>
}`;

/** Both ends of segments at the start and at the end of the step, three numbers each; colours of four bytes. */
export interface SegmentData {
  fromStart: Float32Array;
  fromEnd: Float32Array;
  toStart: Float32Array;
  toEnd: Float32Array;
  colour: Uint8Array;
}

export interface SegmentStyle {
  /** In CSS pixels. */
  width: number;
  /** By how much segments are drawn nearer to the eye than they are, in normalised depth. */
  nearness?: number;
  hidden?: boolean;
  opacity?: number;
  time?: IUniform<number>;
}

export class Segments extends Group {
  private readonly material: ShaderMaterial;
  /** Some of many segments; null if there are few. */
  private few: Mesh | null = null;

  constructor(shared: SharedUniforms, style: SegmentStyle) {
    super();
    this.material = new ShaderMaterial({
      vertexShader: kVertex,
      fragmentShader: kFragment,
      uniforms: {
        ...shared,
        ...(style.time ? { time: style.time } : {}),
        width: { value: style.width },
        nearness: { value: style.nearness ?? 0 },
        opacity: { value: style.opacity ?? 1 },
      },
      transparent: true,
      depthTest: !style.hidden,
      depthWrite: false,
    });
  }

  show(data: SegmentData): void {
    for (const chunk of this.children) (chunk as Mesh).geometry.dispose();
    this.clear();
    const count = data.fromStart.length / 3;
    for (let from = 0; from < count; from += kSegmentSlice)
      this.add(this.chunk(data, from, Math.min(from + kSegmentSlice, count)));
    const few = thinnedSegments(data);
    this.few = few === data ? null : this.chunk(few, 0, few.fromStart.length / 3);
    if (this.few) this.add(this.few);
    this.draft = false;
  }

  /** Draws some segments alone. */
  set draft(on: boolean) {
    for (const chunk of this.children) chunk.visible = (chunk === this.few) === (on && this.few !== null);
  }

  private chunk(data: SegmentData, from: number, to: number): Mesh {
    const geometry = new InstancedBufferGeometry();
    const corners = new Float32Array([-1, -1, 1, -1, 1, 1, -1, 1]);
    geometry.setAttribute("corner", new BufferAttribute(corners, 2));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    for (const name of ["fromStart", "fromEnd", "toStart", "toEnd"] as const)
      geometry.setAttribute(name, new InstancedBufferAttribute(data[name].subarray(3 * from, 3 * to), 3));
    const colour = new InstancedBufferAttribute(data.colour.subarray(4 * from, 4 * to), 4, true);
    geometry.setAttribute("colour", colour);
    geometry.instanceCount = to - from;
    const mesh = new Mesh(geometry, this.material);
    mesh.frustumCulled = false;
    mesh.renderOrder = this.renderOrder;
    return mesh;
  }
}

function thinnedSegments(data: SegmentData): SegmentData {
  if (data.fromStart.length <= 3 * kDraftSegments) return data;
  const some = (points: Float32Array) => thinned(points, 3, kDraftSegments);
  return {
    fromStart: some(data.fromStart),
    fromEnd: some(data.fromEnd),
    toStart: some(data.toStart),
    toEnd: some(data.toEnd),
    colour: thinned(data.colour, 4, kDraftSegments),
  };
}

/** Segments between vertices of a step, given by pairs of indices. */
export function segmentsBetween(
  pairs: ArrayLike<number>,
  start: Float32Array,
  end: Float32Array,
  colourOf: (pair: number) => number[],
): SegmentData {
  const count = pairs.length / 2;
  const data = emptySegments(count);
  for (let i = 0; i < count; ++i) {
    const [a, b] = [3 * pairs[2 * i], 3 * pairs[2 * i + 1]];
    data.fromStart.set(start.subarray(a, a + 3), 3 * i);
    data.fromEnd.set(end.subarray(a, a + 3), 3 * i);
    data.toStart.set(start.subarray(b, b + 3), 3 * i);
    data.toEnd.set(end.subarray(b, b + 3), 3 * i);
    data.colour.set(colourOf(i), 4 * i);
  }
  return data;
}

export function emptySegments(count: number): SegmentData {
  const points = (): Float32Array => new Float32Array(3 * count);
  return {
    fromStart: points(),
    fromEnd: points(),
    toStart: points(),
    toEnd: points(),
    colour: new Uint8Array(4 * count),
  };
}
