import { need, within } from "./memory.js";
import type { Memory, Numbers } from "./memory.js";
import type { Module } from "./module.js";

/** Six numbers: a position, then a rotation vector, which is the axis times the angle in radians. */
export type Pose = Numbers;
/** Twelve numbers a link: the pose at t=0, then at t=1. A point of the body goes through the last link first. */
export type Chain = Numbers;

/** Poses, and the chains of links that move bodies. Here C keeps no message: the refused thing is one of the arguments. */
export class Poses {
  /** @internal */
  constructor(
    /** Every function of the C interface, with `_` before its name. */
    readonly module: Module,
  ) {}

  /** A pose of a quaternion (w x y z), of a matrix by its rows, or of a rotation vector. Rounding errors are removed. */
  poseOf(rotation: Numbers, position: Numbers): Float64Array {
    if (rotation.length === 3) return Float64Array.of(...listed(position, 3, "position"), ...listed(rotation, 3, "rotation"));
    need(rotation.length === 4 || rotation.length === 9, `rotation has ${rotation.length} numbers: give 4 of a quaternion, 9 of a matrix, or 3`, 9);
    const name = rotation.length === 4 ? "_tamis_pose_of_quaternion" : "_tamis_pose_of_matrix";
    return this.written(6, name, "the rotation is off by more than rounding, or a number is not finite: give a rotation", (given) => [
      given.doubles(rotation), given.doubles(listed(position, 3, "position")),
    ]);
  }

  /** One link: position and rotation vector are linear in t. */
  interpolatedChain(start: Pose, end: Pose): Float64Array {
    return Float64Array.of(...listed(start, 6, "start"), ...listed(end, 6, "end"));
  }
  /** Two links: turns about a fixed axis by any angle, while `center`, in the body's frame, goes straight. */
  turnedChain(start: Pose, turn: Numbers, endPosition: Numbers, center: Numbers = [0, 0, 0]): Float64Array {
    return this.written(24, "_tamis_turned_chain", FINITE, (given) => [
      given.doubles(listed(start, 6, "start")), given.doubles(listed(turn, 3, "turn")), given.doubles(listed(endPosition, 3, "endPosition")),
      given.doubles(listed(center, 3, "center")),
    ]);
  }
  /** Two links: from one pose to the other by the shorter turn about a fixed axis, at constant speed (slerp). */
  chainBetween(start: Pose, end: Pose, center: Numbers = [0, 0, 0]): Float64Array {
    return this.written(24, "_tamis_chain_between", FINITE, (given) => [
      given.doubles(listed(start, 6, "start")), given.doubles(listed(end, 6, "end")), given.doubles(listed(center, 3, "center")),
    ]);
  }

  /** The pose of a chain's body at a time in [0, 1], for example after a step that is safe until then. */
  poseAt(chain: Chain, time: number): Float64Array {
    need(chain.length % 12 === 0, `chain has ${chain.length} numbers: give 12 for each link`, 9);
    return this.written(6, "_tamis_pose_at", `time is ${time}: give one in [0, 1], and finite numbers`, (given) => [
      given.doubles(chain), chain.length / 12, time,
    ]);
  }
  /** For engines that blend quaternions: no point is farther from its place by chainBetween than this part of its distance from the center. */
  nlerpDeviation(start: Pose, end: Pose): number {
    return this.written(1, "_tamis_nlerp_deviation", FINITE, (given) => [given.doubles(listed(start, 6, "start")), given.doubles(listed(end, 6, "end"))])[0];
  }

  private written(length: number, name: `_tamis_${string}`, refusal: string, numbers: (given: Memory) => number[]): Float64Array {
    return within(this.module, (given) => {
      const place = given.room(8 * length);
      const status = this.module[name](...numbers(given), place);
      need(status === 0, refusal, status);
      return given.viewOfDoubles(place, length).slice();
    });
  }
}

const FINITE = "a number is not finite: give finite ones";

export function listed(numbers: Numbers, length: number, name: string): number[] {
  need(numbers.length === length, `${name} has ${numbers.length} numbers: give ${length}`, 9);
  return Array.from(numbers);
}
