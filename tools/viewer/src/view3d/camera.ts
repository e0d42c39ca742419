// The camera: mouse, touch and keys turn it, and it flies to chosen contacts.
import { PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

export interface Viewpoint {
  eye: Vector3;
  target: Vector3;
}

const kFlightSeconds = 0.7;

export class Camera {
  readonly camera = new PerspectiveCamera(36, 1, 1e-3, 100);
  private readonly controls: OrbitControls;
  private flight: { from: Viewpoint; to: Viewpoint; began: number } | null = null;

  constructor(element: HTMLElement, changed: () => void) {
    this.controls = new OrbitControls(this.camera, element);
    this.controls.enableDamping = false;
    this.controls.zoomToCursor = true;
    this.controls.minDistance = 1e-5;
    this.controls.maxDistance = 60;
    this.controls.addEventListener("change", changed);
    this.controls.addEventListener("start", () => (this.flight = null));
  }

  get viewpoint(): Viewpoint {
    return { eye: this.camera.position.clone(), target: this.controls.target.clone() };
  }

  get isFlying(): boolean {
    return this.flight !== null;
  }

  jump({ eye, target }: Viewpoint): void {
    this.flight = null;
    this.camera.position.copy(eye);
    this.controls.target.copy(target);
    this.controls.update();
  }

  fly(to: Viewpoint): void {
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) this.jump(to);
    else this.flight = { from: this.viewpoint, to, began: performance.now() };
  }

  /** Turns around the target by angles in radians. */
  turn(yaw: number, pitch: number): void {
    const { eye, target } = this.viewpoint;
    const arm = eye.sub(target);
    const radius = arm.length();
    const polar = Math.min(Math.max(Math.acos(arm.y / radius) - pitch, 0.02), Math.PI - 0.02);
    const azimuth = Math.atan2(arm.x, arm.z) - yaw;
    arm.setFromSphericalCoords(radius, polar, azimuth);
    this.jump({ eye: arm.add(target), target });
  }

  zoom(factor: number): void {
    const { eye, target } = this.viewpoint;
    this.jump({
      eye: eye
        .sub(target)
        .multiplyScalar(1 / factor)
        .add(target),
      target,
    });
  }

  /** Shifts eye and target, in fractions of the distance between them. */
  shift(right: number, up: number): void {
    const { eye, target } = this.viewpoint;
    const distance = eye.distanceTo(target);
    const way = new Vector3()
      .setFromMatrixColumn(this.camera.matrix, 0)
      .multiplyScalar(right * distance)
      .addScaledVector(new Vector3().setFromMatrixColumn(this.camera.matrix, 1), up * distance);
    this.jump({ eye: eye.add(way), target: target.add(way) });
  }

  resize(width: number, height: number): void {
    this.camera.aspect = width / height;
    // In a tall window the field of view is wider, so that its width shows as much as a wide window's height.
    this.camera.fov = width < height ? 52 : 36;
    this.camera.updateProjectionMatrix();
  }

  /** Moves the camera; called once a frame. */
  update(): void {
    if (this.flight) this.step(this.flight);
    const distance = this.camera.position.distanceTo(this.controls.target);
    this.camera.near = 0.005 * distance;
    this.camera.far = distance + 8;
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
  }

  private step({ from, to, began }: { from: Viewpoint; to: Viewpoint; began: number }): void {
    const part = Math.min((performance.now() - began) / (1000 * kFlightSeconds), 1);
    const eased = part * part * (3 - 2 * part);
    const target = from.target.clone().lerp(to.target, eased);
    // The distance changes by factors, so that a long flight does not end too fast.
    const [near, far] = [from.eye.distanceTo(from.target), to.eye.distanceTo(to.target)];
    const direction = from.eye.clone().sub(from.target).divideScalar(near);
    direction.lerp(to.eye.clone().sub(to.target).divideScalar(far), eased);
    const distance = near ** (1 - eased) * far ** eased;
    if (direction.lengthSq() < 1e-8) direction.set(0, 0, 1);
    const eye = direction.normalize().multiplyScalar(distance).add(target);
    this.flight = part < 1 ? { from, to, began } : null;
    this.camera.position.copy(eye);
    this.controls.target.copy(target);
    this.controls.update();
  }
}
