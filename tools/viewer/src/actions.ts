// The actions of buttons and keys that do more than change one value.
import { Box3, Vector3 } from "three";
import { el } from "./dom";
import { isPose, namesOf, nounOf } from "./scene/header";
import { nothingFound, nothingStops, whatEnds } from "./scene/proofs";
import type { Pair } from "./scene/pair";
import type { Session } from "./session";
import type { Viewpoint } from "./view3d/camera";
import { clearestDirection } from "./view3d/clearest";
import type { Stage } from "./view3d/stage";

export class Actions {
  help: () => void = () => undefined;
  say: (message: string) => void = () => undefined;

  constructor(
    private readonly session: Session,
    private readonly stage: Stage | null,
  ) {}

  /** Shows the first contact in the scene, at its time. */
  firstContact(): void {
    const { header } = this.session.scene;
    const contact = this.session.view.firstContact;
    if (contact < 0) {
      this.say(`No ${nounOf(header)}: ${nothingFound(header, this.session.view.step.header)}`);
      return;
    }
    this.session.select(contact);
    this.session.store.set({ isolated: false });
    this.flyNear(this.session.pair);
  }

  /** Shows the pair that ends the step alone, at the time until which the pair is proven apart. */
  whatStops(): void {
    const { header } = this.session.scene;
    if (isPose(header)) return;
    const contact = this.session.view.limiting;
    if (contact < 0) {
      this.say(`Nothing stops this step: ${nothingStops(header, this.session.view.step.header)}`);
      return;
    }
    this.session.select(contact);
    const time = this.session.scene.contacts.toiLower[contact];
    this.session.store.set({ time });
    this.say(whatEnds(header, this.session.view.step.header, time));
  }

  leave(): void {
    const { pair, store } = this.session;
    if (pair === null && store.now.panelOpen && store.now.panel !== "contacts") store.set({ panel: "contacts" });
    if (pair === null) return;
    this.session.deselect();
    this.overview();
  }

  overview(): void {
    this.stage?.camera.fly(this.wholeStep());
  }

  /** Flies so near to the pair that it fills a good part of the view. */
  flyTo(pair: Pair): void {
    const { stage } = this;
    if (!stage) return;
    const target = new Vector3(...pair.secondPoint(pair.toi));
    const { eye, target: old } = stage.camera.viewpoint;
    const direction = eye.sub(old).normalize();
    const normal = new Vector3(...pair.normal);
    // The gap between the features is seen best from a direction across the normal.
    direction.addScaledVector(normal, -0.8 * direction.dot(normal));
    if (direction.lengthSq() < 0.05) direction.set(0.3, 0.4, 1);
    stage.camera.fly({
      eye: direction
        .normalize()
        .multiplyScalar(5.5 * pair.size)
        .add(target),
      target,
    });
  }

  /** Flies near to the pair, but not so near that its place in the scene is lost. */
  private flyNear(pair: Pair | null): void {
    if (!pair || !this.stage) return;
    const { eye, target: middle } = this.wholeStep();
    const target = new Vector3(...pair.firstPoint(pair.toi));
    const arm = eye.sub(middle);
    const distance = Math.max(0.5 * arm.length(), 8 * pair.size);
    this.stage.camera.fly({ eye: arm.setLength(distance).add(target), target });
  }

  turn(way: string): void {
    const by = 0.12;
    this.stage?.camera.turn(
      way === "Left" ? -by : way === "Right" ? by : 0,
      way === "Up" ? -by : way === "Down" ? by : 0,
    );
  }

  shift(way: string): void {
    const by = 0.06;
    this.stage?.camera.shift(
      way === "Left" ? -by : way === "Right" ? by : 0,
      way === "Up" ? by : way === "Down" ? -by : 0,
    );
  }

  zoom(factor: number): void {
    this.stage?.camera.zoom(factor);
  }

  theme(): void {
    const { store } = this.session;
    store.set({ theme: store.now.theme === "dark" ? "light" : "dark" });
  }

  copyLink(): void {
    navigator.clipboard.writeText(location.href).then(
      () => {
        this.say("The link to this view is copied.");
      },
      () => {
        this.say("This browser lets no page copy: take the address from its bar.");
      },
    );
  }

  /** Gives the browser a PNG of the drawing to save. */
  async savePicture(): Promise<void> {
    const picture = await this.stage?.picture(getComputedStyle(document.body).getPropertyValue("--back"));
    if (!picture) {
      this.say("There is no picture to save: this browser has no WebGL 2.");
      return;
    }
    const address = URL.createObjectURL(picture);
    const [name] = namesOf(this.session.scene.header, this.session.store.now.step);
    el("a", { href: address, download: `${name}.png` }).click();
    URL.revokeObjectURL(address);
  }

  /** The view from which most contacts are seen, as near as possible with all moving objects in it. */
  wholeStep(): Viewpoint {
    const frames = this.frames();
    const shown = this.shownVertices();
    const target = middleOf(shown, frames);
    const toEye = clearestDirection(this.session.view);
    const right = new Vector3(0, 1, 0).cross(toEye).normalize();
    const up = toEye.clone().cross(right);
    const camera = this.stage?.camera.camera;
    const tall = Math.tan((((camera?.fov ?? 36) / 2) * Math.PI) / 180);
    const wide = tall * (camera?.aspect ?? 1);
    // Leaves space for the text above and below the scene.
    const [marginX, marginY] = [0.94, 0.74];
    let distance = 1e-3;
    const from = new Vector3();
    for (const at of frames)
      for (const v of shown) {
        from.set(at[3 * v] - target.x, at[3 * v + 1] - target.y, at[3 * v + 2] - target.z);
        const reach = Math.max(Math.abs(from.dot(right)) / (wide * marginX), Math.abs(from.dot(up)) / (tall * marginY));
        distance = Math.max(distance, reach + from.dot(toEye));
      }
    return { eye: toEye.multiplyScalar(distance).add(target), target };
  }

  /** The vertices of objects that move in this step; of all objects if none moves. */
  private shownVertices(): Uint32Array {
    const { start, end } = this.session.view.step;
    const { objectOfVertex } = this.session.scene;
    const moving = new Set<number>();
    let last = -1;
    for (let v = 0; v < objectOfVertex.length; ++v) {
      const object = objectOfVertex[v];
      if (object === last || object < 0) continue;
      if (start[3 * v] === end[3 * v] && start[3 * v + 1] === end[3 * v + 1] && start[3 * v + 2] === end[3 * v + 2])
        continue;
      moving.add(object);
      last = object;
    }
    const shown: number[] = [];
    let isLastShown = false;
    last = -1;
    for (let v = 0; v < objectOfVertex.length; ++v) {
      const object = objectOfVertex[v];
      if (object !== last) isLastShown = object >= 0 && (moving.size === 0 || moving.has(object));
      last = object;
      if (isLastShown) shown.push(v);
    }
    return Uint32Array.from(shown);
  }

  /** Start and end of the step, and the starts of some steps of the sequence, so few that they take no noticeable time. */
  private frames(): Float32Array[] {
    const { scene, view } = this.session;
    const { start, end } = view.step;
    const count = Math.min(scene.stepCount - 1, 16, Math.floor(600_000 / Math.max(start.length, 1)));
    const others = Array.from({ length: count }, (_, i) => Math.floor(((i + 0.5) * scene.stepCount) / count));
    return [start, end, ...others.map((step) => scene.step(step).start)];
  }
}

/** The middle of the box around vertices in some frames. */
function middleOf(vertices: Uint32Array, frames: Float32Array[]): Vector3 {
  const box = new Box3();
  const point = new Vector3();
  for (const at of frames) for (const v of vertices) box.expandByPoint(point.fromArray(at, 3 * v));
  return box.getCenter(new Vector3());
}
