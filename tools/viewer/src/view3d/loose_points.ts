// Draws the points that belong to no edge and no triangle.
import { BufferAttribute, BufferGeometry, Points, ShaderMaterial } from "three";
import type { Step } from "../scene/scene";
import { kDraftPoints, thinned } from "./large";
import { kMotion } from "./shaders";
import type { SharedUniforms } from "./shared";

const kVertex = /* glsl */ `
${kMotion}
uniform float pixelRatio;
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(moved(), 1.0);
  gl_PointSize = 6.0 * pixelRatio;
}`;

const kFragment = /* glsl */ `
uniform vec3 ink;
void main() {
  if (length(2.0 * gl_PointCoord - 1.0) > 1.0) discard;
  gl_FragColor = vec4(mix(ink, vec3(0.25, 0.36, 0.55), 0.6), 1.0);
  #include <colorspace_fragment>
}`;

export class LoosePoints extends Points<BufferGeometry, ShaderMaterial> {
  private readonly all = new BufferGeometry();
  /** Some of the points. */
  private readonly few = new BufferGeometry();

  constructor(points: Uint32Array, shared: SharedUniforms) {
    const material = new ShaderMaterial({ vertexShader: kVertex, fragmentShader: kFragment, uniforms: { ...shared } });
    super(new BufferGeometry(), material);
    this.all.setIndex(new BufferAttribute(points, 1));
    this.few.setIndex(new BufferAttribute(thinned(points, 1, kDraftPoints), 1));
    this.geometry = this.all;
    this.frustumCulled = false;
  }

  show(step: Step): void {
    for (const geometry of [this.all, this.few]) {
      geometry.setAttribute("position", new BufferAttribute(step.start, 3));
      geometry.setAttribute("end", new BufferAttribute(step.end, 3));
    }
  }

  /** Draws some points alone. */
  set draft(on: boolean) {
    this.geometry = on ? this.few : this.all;
  }
}
