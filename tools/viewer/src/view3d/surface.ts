// Draws the triangles, shaded on both sides, and lit up at vertices that have been in contact.
import { BufferAttribute, BufferGeometry, DoubleSide, Group, LineSegments, Mesh, ShaderMaterial } from "three";
import { kObjectColours } from "../colours";
import type { Scene, Step } from "../scene/scene";
import { coarse } from "./large";
import { kMotion } from "./shaders";
import type { SharedUniforms } from "./shared";

const kVertex = /* glsl */ `
${kMotion}
attribute vec3 normalStart;
attribute vec3 normalEnd;
attribute vec3 tint;
attribute float firstTouch;
attribute float fineness;
uniform sampler2D scale;
uniform vec2 brush;
varying vec3 vNormal;
varying vec3 vView;
varying vec3 vTint;
varying vec4 vGlow;
varying vec3 vPlace;
void main() {
  vec4 view = modelViewMatrix * vec4(moved(), 1.0);
  vPlace = moved();
  vView = view.xyz;
  vNormal = normalMatrix * mix(normalStart, normalEnd, time);
  vTint = tint;
  bool touched = firstTouch <= time && firstTouch >= brush.x && firstTouch <= brush.y;
  vGlow = vec4(texture2D(scale, vec2(firstTouch, 0.5)).rgb, 1.0) * (touched ? fineness : 0.0);
  gl_Position = projectionMatrix * view;
}`;

const kFragment = /* glsl */ `
uniform bool smoothShading;
uniform vec3 focus;
uniform float focusRadius;
uniform vec3 window;
uniform float windowDepth;
varying vec3 vNormal;
varying vec3 vView;
varying vec3 vTint;
varying vec4 vGlow;
varying vec3 vPlace;
void main() {
  // What hides the selected pair is cut away around it.
  float fromPair = distance(gl_FragCoord.xy, window.xy) / max(window.z, 1.0);
  bool hides = -vView.z < windowDepth;
  if (window.z > 0.0 && hides && fromPair < 1.0) discard;
  float rimOfWindow = window.z > 0.0 && hides ? 1.0 - smoothstep(1.0, 1.06, fromPair) : 0.0;
  vec3 flatNormal = normalize(cross(dFdx(vView), dFdy(vView)));
  vec3 toEye = normalize(-vView);
  vec3 normal = smoothShading && dot(vNormal, vNormal) > 1e-12 ? normalize(vNormal) : flatNormal;
  if (dot(normal, flatNormal) < 0.0) normal = -normal;
  float key = max(dot(normal, normalize(vec3(0.45, 0.75, 0.6))), 0.0);
  float fill = max(dot(normal, normalize(vec3(-0.8, 0.1, 0.35))), 0.0);
  float sky = 0.5 + 0.5 * normal.y;
  float rim = pow(1.0 - max(dot(normal, toEye), 0.0), 3.0);
  float shine = pow(max(dot(normal, normalize(normalize(vec3(0.45, 0.75, 0.6)) + toEye)), 0.0), 40.0);
  vec3 tint = vTint;
  if (!gl_FrontFacing) tint = mix(tint * vec3(0.62, 0.52, 0.5), vec3(0.16, 0.11, 0.1), 0.25);
  vec3 colour = tint * (vec3(0.16, 0.19, 0.25) * sky + 0.07 + 0.66 * key + 0.14 * fill) + 0.07 * rim + 0.07 * shine;
  if (vGlow.a > 0.0) {
    vec3 glow = vGlow.rgb / vGlow.a;
    float strength = smoothstep(0.0, 0.9, vGlow.a);
    colour = mix(colour, glow * (0.45 + 0.75 * key + 0.25 * sky), 0.85 * strength);
  }
  colour *= 1.0 - 0.75 * rimOfWindow;
  float alpha = 1.0;
  if (focusRadius > 0.0) {
    alpha = 0.34 * (1.0 - smoothstep(0.35, 1.0, distance(vPlace, focus) / focusRadius));
    if (alpha < 0.004) discard;
  }
  gl_FragColor = vec4(colour, alpha);
  #include <colorspace_fragment>
}`;

const kEdgeVertex = /* glsl */ `
${kMotion}
varying vec3 vPlace;
void main() {
  vPlace = moved();
  gl_Position = projectionMatrix * modelViewMatrix * vec4(vPlace, 1.0);
}`;

const kEdgeFragment = /* glsl */ `
uniform vec3 ink;
uniform vec3 focus;
uniform float focusRadius;
varying vec3 vPlace;
void main() {
  float alpha = 0.38;
  if (focusRadius > 0.0) alpha *= 1.0 - smoothstep(0.35, 1.0, distance(vPlace, focus) / focusRadius);
  if (alpha < 0.004) discard;
  gl_FragColor = vec4(ink, alpha);
  #include <colorspace_fragment>
}`;

/** Unit normals of the vertices: means of their triangles' normals, weighted by area. */
function vertexNormals(faces: Uint32Array, positions: Float32Array): Float32Array {
  const normals = new Float32Array(positions.length);
  for (let f = 0; f < faces.length; f += 3) {
    const a = 3 * faces[f];
    const b = 3 * faces[f + 1];
    const c = 3 * faces[f + 2];
    const ex = positions[b] - positions[a];
    const ey = positions[b + 1] - positions[a + 1];
    const ez = positions[b + 2] - positions[a + 2];
    const gx = positions[c] - positions[a];
    const gy = positions[c + 1] - positions[a + 1];
    const gz = positions[c + 2] - positions[a + 2];
    const nx = ey * gz - ez * gy;
    const ny = ez * gx - ex * gz;
    const nz = ex * gy - ey * gx;
    for (let k = 0; k < 3; ++k) {
      const v = k === 0 ? a : k === 1 ? b : c;
      normals[v] += nx;
      normals[v + 1] += ny;
      normals[v + 2] += nz;
    }
  }
  for (let v = 0; v < normals.length; v += 3) {
    const length = Math.sqrt(normals[v] ** 2 + normals[v + 1] ** 2 + normals[v + 2] ** 2);
    if (length > 0) for (let k = 0; k < 3; ++k) normals[v + k] /= length;
  }
  return normals;
}

/** The edges of the triangles, each once, as pairs of vertices, the smaller one first. */
export function edgesOf(faces: Uint32Array, vertices: number): Uint32Array {
  // Sorted by the smaller vertex in linear time; the few edges of one vertex are then compared with each other.
  const ends = new Uint32Array(vertices + 1);
  const smaller = (f: number, k: number): number => Math.min(faces[f + k], faces[f + ((k + 1) % 3)]);
  for (let f = 0; f < faces.length; f += 3) for (let k = 0; k < 3; ++k) ++ends[smaller(f, k) + 1];
  for (let v = 0; v < vertices; ++v) ends[v + 1] += ends[v];
  const place = ends.slice();
  const others = new Uint32Array(faces.length);
  for (let f = 0; f < faces.length; f += 3)
    for (let k = 0; k < 3; ++k) others[place[smaller(f, k)]++] = Math.max(faces[f + k], faces[f + ((k + 1) % 3)]);
  const edges = new Uint32Array(2 * faces.length);
  let count = 0;
  for (let v = 0; v < vertices; ++v) {
    const own = others.subarray(ends[v], ends[v + 1]).sort();
    for (let i = 0; i < own.length; ++i)
      if (i === 0 || own[i] !== own[i - 1]) {
        edges[count++] = v;
        edges[count++] = own[i];
      }
  }
  return edges.slice(0, count);
}

/** 1 for vertices whose triangles are small, 0 for large ones, of which a contact's colour would light up too much. */
function fineness(faces: Uint32Array, positions: Float32Array): Float32Array {
  const longest = new Float32Array(positions.length / 3);
  for (let f = 0; f < faces.length; f += 3)
    for (let k = 0; k < 3; ++k) {
      const a = faces[f + k];
      const b = faces[f + ((k + 1) % 3)];
      const x = positions[3 * a] - positions[3 * b];
      const y = positions[3 * a + 1] - positions[3 * b + 1];
      const z = positions[3 * a + 2] - positions[3 * b + 2];
      const edge = Math.sqrt(x * x + y * y + z * z);
      if (edge > longest[a]) longest[a] = edge;
      if (edge > longest[b]) longest[b] = edge;
    }
  const [small, large] = [0.15, 0.4];
  return longest.map((edge) => 1 - Math.min(Math.max((edge - small) / (large - small), 0), 1));
}

function tints(scene: Scene): Uint8Array {
  const colours = new Uint8Array(3 * scene.objectOfVertex.length);
  // Converts to linear colours, with which the shader computes.
  const linear = kObjectColours.map((rgb) => rgb.map((c) => Math.round(255 * (c / 255) ** 2.2)));
  scene.objectOfVertex.forEach((object, v) => {
    if (object >= 0) colours.set(linear[object % linear.length], 3 * v);
  });
  return colours;
}

export class Surface extends Group {
  readonly geometry = new BufferGeometry();
  private readonly material: ShaderMaterial;
  private readonly edges = new LineSegments();
  private hasEdges = false;
  private showsEdges = false;
  /** The number of the step; -1: none yet. */
  private shown = -1;
  private readonly mesh: Mesh;
  /** Fewer triangles of the same vertices; made when it is needed. */
  private rough: BufferGeometry | null = null;

  constructor(
    private readonly scene: Scene,
    shared: SharedUniforms,
  ) {
    super();
    this.geometry.setIndex(new BufferAttribute(scene.faces, 1));
    this.geometry.setAttribute("tint", new BufferAttribute(tints(scene), 3, true));
    this.material = new ShaderMaterial({
      vertexShader: kVertex,
      fragmentShader: kFragment,
      uniforms: { ...shared, smoothShading: { value: true } },
      side: DoubleSide,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 2,
    });
    this.mesh = new Mesh(this.geometry, this.material);
    this.edges.material = new ShaderMaterial({
      vertexShader: kEdgeVertex,
      fragmentShader: kEdgeFragment,
      uniforms: { ...shared },
      transparent: true,
      depthWrite: false,
    });
    this.mesh.frustumCulled = false;
    this.edges.frustumCulled = false;
    this.edges.visible = false;
    this.add(this.mesh, this.edges);
  }

  /** Shows a step. `firstTouch`: for each vertex the time of its first contact, above 1 if it has none. */
  show(step: Step, firstTouch: Float32Array): void {
    const set = (name: string, array: Float32Array, width: number): void => {
      this.geometry.setAttribute(name, new BufferAttribute(array, width));
    };
    set("position", step.start, 3);
    set("end", step.end, 3);
    set("normalStart", vertexNormals(this.scene.faces, step.start), 3);
    set("normalEnd", vertexNormals(this.scene.faces, step.end), 3);
    set("firstTouch", firstTouch, 1);
    if (step.index !== this.shown) set("fineness", fineness(this.scene.faces, step.start), 1);
    this.shown = step.index;
    if (this.hasEdges) this.share(this.edges.geometry, ["position", "end"]);
    if (this.rough) this.share(this.rough, Object.keys(this.geometry.attributes));
  }

  /** Draws a coarse surface without edges. */
  set draft(on: boolean) {
    this.edges.visible = this.showsEdges && !on;
    if (on) this.rough ??= this.roughened();
    this.mesh.geometry = on ? this.rough! : this.geometry;
  }

  private roughened(): BufferGeometry {
    const { faces, objectOfVertex } = this.scene;
    const positions = this.geometry.getAttribute("position").array as Float32Array;
    const rough = new BufferGeometry();
    rough.setIndex(new BufferAttribute(coarse(faces, objectOfVertex, positions), 1));
    this.share(rough, Object.keys(this.geometry.attributes));
    return rough;
  }

  set smooth(on: boolean) {
    this.material.uniforms.smoothShading.value = on;
  }

  /** Draws the surface transparent, as while only a part of it is shown. */
  set faded(on: boolean) {
    this.material.transparent = on;
    this.material.depthWrite = !on;
    this.material.needsUpdate = true;
  }

  showEdges(on: boolean): void {
    this.showsEdges = on;
    this.edges.visible = on;
    if (!on || this.hasEdges) return;
    const edges = edgesOf(this.scene.faces, this.scene.header.mesh.vertices);
    this.edges.geometry.setIndex(new BufferAttribute(edges, 1));
    this.hasEdges = true;
    this.share(this.edges.geometry, ["position", "end"]);
  }

  private share(geometry: BufferGeometry, names: string[]): void {
    for (const name of names) geometry.setAttribute(name, this.geometry.getAttribute(name));
  }
}
