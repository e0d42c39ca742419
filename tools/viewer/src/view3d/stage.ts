// The drawing of mesh, contacts and selected pair. A frame is drawn only when something has changed.
import { Color, Scene as Scene3d, Vector3, WebGLRenderer } from "three";
import { el } from "../dom";
import type { Pair } from "../scene/pair";
import type { Scene, Step } from "../scene/scene";
import type { Theme } from "../store";
import type { Vec3 } from "../vectors";
import { Camera } from "./camera";
import { isLarge, Slices } from "./large";
import { LoosePoints } from "./loose_points";
import { Marks, type MarkData } from "./marks";
import { Pair3d } from "./pair3d";
import { Segments, segmentsBetween, type SegmentData } from "./segments";
import { sharedUniforms } from "./shared";
import { Surface } from "./surface";

/** How long nothing happens before the whole is drawn, in milliseconds. */
const kPause = 150;
const kDraftRatio = 0.5;

const kInk: Record<Theme, number> = { dark: 0xe8eef7, light: 0x10151d };

export interface FrameCost {
  drawCalls: number;
  triangles: number;
  /** The time that the page's own code took for the last frame, in milliseconds. */
  cpu: number;
  frames: number;
}

export class Stage {
  readonly camera: Camera;
  readonly cost: FrameCost = { drawCalls: 0, triangles: 0, cpu: 0, frames: 0 };
  /** Called before each frame with the seconds since the last frame; returns whether to draw another one. */
  beforeFrame: (seconds: number) => boolean = () => false;
  /** Called after each frame. */
  readonly drawn: (() => void)[] = [];
  readonly surface: Surface;
  private readonly renderer: WebGLRenderer;
  private readonly world = new Scene3d();
  private readonly shared = sharedUniforms();
  private readonly marks = new Marks(this.shared);
  private readonly normals = new Segments(this.shared, { width: 0.8, nearness: 2e-4 });
  private readonly features = new Segments(this.shared, { width: 0.8, nearness: 2e-4 });
  private readonly rods = new Segments(this.shared, { width: 1.6 });
  private readonly loose: LoosePoints;
  private readonly pair3d = new Pair3d(this.shared);
  /** The selected pair, if it is drawn within the scene; null if it is isolated. */
  private shown: Pair | null = null;
  /** The last draft, while the whole picture is drawn behind it. */
  private readonly still = el("canvas", { class: "still", "aria-hidden": true });
  private slices: Slices | null = null;
  private wait = 0;
  private requested = false;
  private isClosed = false;
  private last = 0;

  /** Throws if the browser has no WebGL 2. */
  constructor(
    readonly canvas: HTMLCanvasElement,
    private readonly scene: Scene,
    private readonly isSoftware: boolean,
  ) {
    // Slices add to one picture, and edges are smoothed only where that costs little.
    this.renderer = new WebGLRenderer({ canvas, antialias: !isSoftware, preserveDrawingBuffer: isSoftware });
    this.still.hidden = true;
    canvas.after(this.still);
    this.camera = new Camera(canvas, () => {
      this.request();
    });
    this.surface = new Surface(scene, this.shared);
    this.loose = new LoosePoints(scene.loosePoints, this.shared);
    this.normals.renderOrder = 3;
    this.features.renderOrder = 3;
    this.world.add(this.surface, this.rods, this.loose, this.marks, this.normals, this.features, this.pair3d);
    new ResizeObserver(() => {
      this.resize();
    }).observe(canvas.parentElement!);
    this.resize();
  }

  showStep(step: Step, firstTouch: Float32Array): void {
    this.surface.show(step, firstTouch);
    this.loose.show(step);
    this.rods.show(segmentsBetween(this.scene.rods, step.start, step.end, () => [70, 92, 140, 255]));
    this.request();
  }

  showMarks(data: MarkData): void {
    this.marks.show(data);
    this.request();
  }

  chooseMarks(places: Uint32Array): void {
    this.marks.choose(places);
    this.request();
  }

  showNormals(data: SegmentData | null): void {
    if (data) this.normals.show(data);
    this.normals.visible = data !== null;
    this.request();
  }

  showFeatures(data: SegmentData | null): void {
    if (data) this.features.show(data);
    this.features.visible = data !== null;
    this.request();
  }

  showPair(pair: Pair | null, isolated: boolean, theme: Theme): void {
    this.pair3d.show(pair, theme);
    const focused = pair !== null && isolated;
    this.shown = focused ? null : pair;
    if (pair) this.shared.focus.value.set(...pair.firstPoint(pair.toi));
    this.shared.focusRadius.value = focused ? 7 * pair.size : 0;
    this.surface.faded = focused;
    this.request();
  }

  setTime(time: number): void {
    this.shared.time.value = time;
    this.pair3d.moveTo(time);
    this.request();
  }

  set brush([low, high]: [number, number]) {
    this.shared.brush.value.set(low, high);
    this.request();
  }

  setVisible(marks: boolean, xray: boolean): void {
    this.marks.visible = marks;
    this.marks.xray = xray;
    this.request();
  }

  set theme(theme: Theme) {
    this.shared.ink.value = new Color(kInk[theme]);
    this.request();
  }

  /** Gives back what the drawing holds of the graphics card. */
  close(): void {
    this.isClosed = true;
    this.stopSlices();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  /** The place at which a point is drawn, in CSS pixels of the canvas, with its depth; null behind the eye. */
  project(point: Vec3): { x: number; y: number; depth: number } | null {
    const at = new Vector3(...point).project(this.camera.camera);
    if (at.z > 1 || at.z < -1) return null;
    const { clientWidth, clientHeight } = this.canvas;
    return { x: ((at.x + 1) / 2) * clientWidth, y: ((1 - at.y) / 2) * clientHeight, depth: at.z };
  }

  /** The length of one unit of the drawing at a place, in CSS pixels on the canvas. */
  pixelsAt(point: Vec3): number {
    const { camera } = this.camera;
    const distance = camera.position.distanceTo(new Vector3(...point));
    return this.canvas.clientHeight / (2 * distance * Math.tan((camera.fov * Math.PI) / 360));
  }

  request(): void {
    if (this.requested || this.isClosed) return;
    this.requested = true;
    this.slices?.stop();
    requestAnimationFrame((now) => {
      this.frame(now);
    });
  }

  private frame(now: number): void {
    this.requested = false;
    if (this.isClosed) return;
    const began = performance.now();
    const more = this.beforeFrame(this.last ? Math.min((now - this.last) / 1000, 0.1) : 0);
    this.camera.update();
    this.renderer.setClearAlpha(0);
    this.stopSlices();
    // Drafts are drawn while anything moves, where the processor draws and the whole takes noticeable time.
    this.useDraft(false);
    const isDraft = this.isSoftware && isLarge(this.world);
    this.useDraft(isDraft);
    this.setSize(isDraft ? kDraftRatio : 1);
    this.placeWindow();
    this.renderer.render(this.world, this.camera.camera);
    this.still.hidden = true;
    for (const listener of this.drawn) listener();
    this.cost.cpu = performance.now() - began;
    this.cost.drawCalls = this.renderer.info.render.calls;
    this.cost.triangles = this.renderer.info.render.triangles;
    ++this.cost.frames;
    const again = more || this.camera.isFlying;
    this.last = again ? now : 0;
    if (again) this.request();
    else if (isDraft) this.wait = window.setTimeout(() => void this.drawWhole(), kPause);
  }

  /** The drawing as it is now, in full resolution over a background, as the bytes of a PNG. */
  picture(background: string): Promise<Blob | null> {
    this.stopSlices();
    this.useDraft(false);
    this.setSize(1);
    this.camera.update();
    this.placeWindow();
    this.renderer.render(this.world, this.camera.camera);
    const { width, height } = this.canvas;
    const copy = el("canvas", { width, height });
    const drawing = copy.getContext("2d")!;
    drawing.fillStyle = background;
    drawing.fillRect(0, 0, width, height);
    drawing.drawImage(this.canvas, 0, 0);
    this.request();
    return new Promise((resolve) => {
      copy.toBlob(resolve);
    });
  }

  /** Whether the drawing will change though nothing more happens. */
  get isBusy(): boolean {
    return this.requested || this.wait !== 0;
  }

  /** Draws all in full resolution behind a copy of the draft, until something happens. */
  private async drawWhole(): Promise<void> {
    this.still.width = this.canvas.width;
    this.still.height = this.canvas.height;
    this.still.getContext("2d")!.drawImage(this.canvas, 0, 0);
    this.still.hidden = false;
    this.useDraft(false);
    this.setSize(1);
    this.placeWindow();
    const slices = new Slices(this.renderer, this.world, this.camera.camera);
    this.slices = slices;
    if (!(await slices.draw())) return;
    this.stopSlices();
    this.still.hidden = true;
    ++this.cost.frames;
  }

  private stopSlices(): void {
    clearTimeout(this.wait);
    this.wait = 0;
    this.slices?.stop();
    this.slices = null;
  }

  private useDraft(on: boolean): void {
    for (const part of [this.surface, this.marks, this.loose, this.normals, this.features, this.rods]) part.draft = on;
  }

  /** Cuts away the surface that hides the pair. */
  private placeWindow(): void {
    const { shown, shared } = this;
    const place = shown?.firstPoint(shared.time.value) ?? [0, 0, 0];
    const seen = shown && this.project(place);
    if (!shown || !seen) {
      shared.window.value.z = 0;
      return;
    }
    const ratio = shared.pixelRatio.value;
    const radius = Math.max(0.1 * this.canvas.clientHeight, 1.2 * shown.size * this.pixelsAt(place));
    shared.window.value.set(seen.x * ratio, (this.canvas.clientHeight - seen.y) * ratio, radius * ratio);
    const depth = -new Vector3(...place).applyMatrix4(this.camera.camera.matrixWorldInverse).z;
    shared.windowDepth.value = depth - 0.6 * shown.size;
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement!;
    if (width === 0 || height === 0) return;
    this.camera.resize(width, height);
    this.setSize(1);
    this.request();
  }

  /** Sets the number of pixels drawn for one of the screen, in each direction. */
  private setSize(part: number): void {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement!;
    const ratio = part * Math.min(devicePixelRatio, 2);
    const isSame = this.shared.size.value.x === width * ratio && this.shared.size.value.y === height * ratio;
    if (isSame || width === 0 || height === 0) return;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.shared.size.value.set(width * ratio, height * ratio);
    this.shared.pixelRatio.value = ratio;
  }
}
