// Finds the direction from which most contacts are seen: those that no triangle hides.
import { Vector3, type Vector3Like } from "three";
import type { StepView } from "../scene/step_view";
import { Pair } from "../scene/pair";
import { thinned } from "./large";

/** So many triangles and contacts are enough to tell directions apart, and take no noticeable time. */
const kTriangles = 10_000;
const kContacts = 16;
/** The first contact counts as much as so many others. */
const kFirstWeight = 4;

/** From above and the side; kept if no other direction is clearer. */
const kUsual = new Vector3(0.5, 0.42, 0.9).normalize();

/** Heights of the eye, and how much what is seen from there counts: from below, light and ground are unusual. */
const kHeights = [
  [0.42, 1],
  [0.12, 0.95],
  [0.02, 0.9],
  [-0.3, 0.7],
] as const;

interface View {
  direction: Vector3;
  preference: number;
}

function views(): View[] {
  const usual = Math.atan2(kUsual.x, kUsual.z);
  const around = kHeights.flatMap(([height, preference]) =>
    [0, 1, -1, 2, -2, 3, -3, 4].map((turn) => {
      const angle = usual + (turn * Math.PI) / 4;
      return { direction: new Vector3(Math.sin(angle), height, Math.cos(angle)).normalize(), preference };
    }),
  );
  return [{ direction: kUsual, preference: 1 }, ...around];
}

/** A point of a feature at the start of the step, where features of a pair are apart, and how much it counts. */
interface Sample {
  at: Vector3;
  feature: number[];
  weight: number;
}

function samples({ scene, step, byTime, firstContact }: StepView): Sample[] {
  const others = thinned(byTime, 1, kContacts);
  return [firstContact, ...others].flatMap((contact, i) => {
    const pair = new Pair(scene, step, contact);
    const weight = i === 0 ? kFirstWeight : 1;
    return [
      { at: new Vector3(...pair.firstPoint(0)), feature: pair.first, weight },
      { at: new Vector3(...pair.secondPoint(0)), feature: pair.second, weight },
    ];
  });
}

/** The weight of all samples that are seen from a direction. */
function seenFrom(direction: Vector3, triangles: Uint32Array, at: Float32Array, points: Sample[]): number {
  const right = new Vector3(0, 1, 0).cross(direction).normalize();
  const up = direction.clone().cross(right);
  // In the plane across the direction, z toward the eye.
  const flat = (x: number, y: number, z: number) => ({
    x: right.x * x + right.y * y + right.z * z,
    y: up.x * x + up.y * y + up.z * z,
    z: direction.x * x + direction.y * y + direction.z * z,
  });
  const places = points.map((point) => flat(...point.at.toArray()));
  const isSeen = points.map(() => true);
  const corner = (i: number) => flat(at[3 * triangles[i]], at[3 * triangles[i] + 1], at[3 * triangles[i] + 2]);
  for (let f = 0; f < triangles.length; f += 3) {
    const [a, b, c] = [corner(f), corner(f + 1), corner(f + 2)];
    const [low, high] = [Math.min(a.x, b.x, c.x), Math.max(a.x, b.x, c.x)];
    for (let i = 0; i < places.length; ++i) {
      const place = places[i];
      if (place.x < low || place.x > high || !isSeen[i]) continue;
      const isOwn = [0, 1, 2].some((k) => points[i].feature.includes(triangles[f + k]));
      if (!isOwn && hides(a, b, c, place)) isSeen[i] = false;
    }
  }
  return points.reduce((sum, { weight }, i) => sum + (isSeen[i] ? weight : 0), 0);
}

/** Whether the triangle lies between the point and the eye, which is toward z. */
function hides(a: Vector3Like, b: Vector3Like, c: Vector3Like, at: Vector3Like): boolean {
  const area = (p: Vector3Like, q: Vector3Like): number => (q.x - p.x) * (at.y - p.y) - (q.y - p.y) * (at.x - p.x);
  const [u, v, w] = [area(b, c), area(c, a), area(a, b)];
  const sum = u + v + w;
  if (sum === 0 || u * sum < 0 || v * sum < 0 || w * sum < 0) return false;
  return (u * a.z + v * b.z + w * c.z) / sum > at.z + 1e-6;
}

/** Returns the direction to the eye from which most contacts of the step are seen at its start. */
export function clearestDirection(view: StepView): Vector3 {
  if (view.step.count === 0) return kUsual.clone();
  const points = samples(view);
  const triangles = thinned(view.scene.faces, 3, kTriangles);
  let best = kUsual;
  let most = -1;
  for (const { direction, preference } of views()) {
    const seen = preference * seenFrom(direction, triangles, view.step.start, points);
    if (seen > most) [best, most] = [direction, seen];
  }
  return best.clone();
}
