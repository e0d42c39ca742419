// Draws contacts as round marks that move with their features, in two draw calls for any number of contacts.
import { BufferAttribute, BufferGeometry, GreaterDepth, Group, LessEqualDepth, Points, ShaderMaterial } from "three";
import { kMotion } from "./shaders";
import { kDraftPoints, thinned } from "./large";
import type { SharedUniforms } from "./shared";

const kVertex = /* glsl */ `
${kMotion}
attribute float toi;
attribute float unresolved;
uniform float diameter;
uniform float pixelRatio;
uniform vec2 brush;
uniform sampler2D scale;
uniform float focusRadius;
varying vec3 vColour;
varying float vUnresolved;
varying float vRim;
void main() {
  vec4 at = projectionMatrix * modelViewMatrix * vec4(moved(), 1.0);
  at.z -= 2e-4 * at.w;
  bool shown = toi <= time + 1e-6 && toi >= brush.x && toi <= brush.y && focusRadius == 0.0;
  vUnresolved = unresolved;
  // Small marks have no room for a rim.
  vRim = diameter > 5.0 ? 1.0 : 0.0;
  // Just touched: larger for a moment.
  float fresh = 1.0 - smoothstep(0.0, 0.04, time - toi);
  gl_PointSize = diameter * pixelRatio * (1.0 + 0.8 * fresh);
  gl_Position = shown ? at : vec4(2.0, 2.0, 2.0, 1.0);
  vColour = texture2D(scale, vec2(toi, 0.5)).rgb;
}`;

const kFragment = /* glsl */ `
uniform float opacity;
uniform vec3 ink;
varying vec3 vColour;
varying float vUnresolved;
varying float vRim;
void main() {
  vec2 place = 2.0 * gl_PointCoord - 1.0;
  float radius = vUnresolved > 0.5 ? max(abs(place.x + place.y), abs(place.x - place.y)) : length(place);
  if (radius > 1.0) discard;
  vec3 colour = radius > 0.7 && vRim > 0.5 ? vec3(0.02, 0.02, 0.04) : vColour;
  if (vUnresolved > 0.5 && radius < 0.45) colour = vec3(1.0);
  gl_FragColor = vec4(colour, opacity);
  #include <colorspace_fragment>
}`;

/** The positions of contacts at both ends of the step, and their times. */
export interface MarkData {
  start: Float32Array;
  end: Float32Array;
  toi: Float32Array;
  /** 1: unresolved. */
  unresolved: Float32Array;
}

export class Marks extends Group {
  private readonly geometry = new BufferGeometry();
  /** Some of the marks. */
  private readonly few = new BufferGeometry();
  private readonly passes: Points<BufferGeometry, ShaderMaterial>[];

  constructor(shared: SharedUniforms) {
    super();
    const pass = (behind: boolean): Points<BufferGeometry, ShaderMaterial> => {
      const material = new ShaderMaterial({
        vertexShader: kVertex,
        fragmentShader: kFragment,
        uniforms: { ...shared, diameter: { value: 6 }, opacity: { value: behind ? 0.22 : 1 } },
        transparent: behind,
        depthWrite: false,
        depthFunc: behind ? GreaterDepth : LessEqualDepth,
      });
      const points = new Points(this.geometry, material);
      points.frustumCulled = false;
      points.renderOrder = behind ? 1 : 2;
      return points;
    };
    this.passes = [pass(true), pass(false)];
    this.add(...this.passes);
  }

  show(data: MarkData): void {
    this.geometry.setAttribute("position", new BufferAttribute(data.start, 3));
    this.geometry.setAttribute("end", new BufferAttribute(data.end, 3));
    this.geometry.setAttribute("toi", new BufferAttribute(data.toi, 1));
    this.geometry.setAttribute("unresolved", new BufferAttribute(data.unresolved, 1));
    for (const [name, attribute] of Object.entries(this.geometry.attributes)) this.few.setAttribute(name, attribute);
    // Marks of many contacts are small, or they would hide each other.
    const [few, many] = [200, 50000];
    const crowd = Math.min(Math.max(Math.log(data.toi.length / few) / Math.log(many / few), 0), 1);
    for (const points of this.passes) points.material.uniforms.diameter.value = 9 - 6 * crowd;
  }

  /** Draws the contacts at these places of the data alone. */
  choose(places: Uint32Array): void {
    this.geometry.setIndex(new BufferAttribute(places, 1));
    this.few.setIndex(new BufferAttribute(thinned(places, 1, kDraftPoints), 1));
  }

  /** Draws some marks alone. */
  set draft(on: boolean) {
    for (const points of this.passes) points.geometry = on ? this.few : this.geometry;
  }

  set xray(on: boolean) {
    this.passes[0].visible = on;
  }
}
