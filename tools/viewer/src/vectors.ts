// Vectors of three numbers.
export type Vec3 = [number, number, number];

export const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times = (s: number, a: Vec3): Vec3 => [s * a[0], s * a[1], s * a[2]];
export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const length = (a: Vec3): number => Math.hypot(...a);
/** REQUIRES: not zero. */
export const unit = (a: Vec3): Vec3 => times(1 / length(a), a);
export const mix = (a: Vec3, b: Vec3, t: number): Vec3 => add(times(1 - t, a), times(t, b));

export function weighted(points: Vec3[], weights: number[]): Vec3 {
  return points.reduce<Vec3>((sum, point, i) => add(sum, times(weights[i], point)), [0, 0, 0]);
}
