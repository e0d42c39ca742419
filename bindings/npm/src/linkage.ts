import { Handle } from "./handle.js";
import { need, only, whole } from "./memory.js";
import type { Numbers } from "./memory.js";
import type { Module } from "./module.js";
import { listed } from "./poses.js";
import type { Pose } from "./poses.js";

/** A joint. Its frame in its parent's: `place`, then its own motion by its value, `factor` times a number of the configuration, plus `offset`. */
export interface Joint {
  /** The joint that carries it, before it in the list; -1: the world. */
  parent?: number;
  /** About its axis, in radians; along its axis; or not at all. */
  kind: "fixed" | "turning" | "sliding";
  /** Which number of a configuration moves it. */
  coordinate?: number;
  place?: Pose;
  /** In its own frame; the direction alone counts. */
  axis?: Numbers;
  /** 1, unless the joint mimics another one. */
  factor?: number;
  offset?: number;
}

/** A body that a joint carries. */
export interface CarriedBody {
  /** Its number in the world. */
  body: number;
  /** The joint's place in the list. */
  joint: number;
  /** Its frame in the joint's. */
  place?: Pose;
}

export interface LinkageInput {
  joints: readonly Joint[];
  bodies: readonly CarriedBody[];
}

const KINDS = ["fixed", "turning", "sliding"];
const SIZE = { joint: 112, carried: 56 };
const NONE = [0, 0, 0, 0, 0, 0];

/** A tree of joints, or several, and the bodies of a world that they carry: a robot. */
export class Linkage extends Handle {
  /** How many numbers a configuration has. */
  readonly dimension: number;

  /** @internal Tamis.linkage makes linkages. */
  constructor(module: Module, input: LinkageInput) {
    super(module, "linkage");
    only(input, "a linkage", "joints", "bodies");
    const { joints, bodies } = input;
    this.make("linkage_create", (given) => {
      const [first, carried] = [given.room(SIZE.joint * joints.length), given.room(SIZE.carried * bodies.length)];
      joints.forEach((joint, i) => {
        only(joint, "a joint", "parent", "kind", "coordinate", "place", "axis", "factor", "offset");
        const { parent = -1, kind, coordinate = 0, place = NONE, axis = [0, 0, 0], factor = 1, offset = 0 } = joint;
        need(KINDS.includes(kind), `joint ${i} is '${kind}': use ${KINDS.join(", ")}`, 4);
        given.fill(first + SIZE.joint * i, [whole(parent, "parent"), KINDS.indexOf(kind), whole(coordinate, "coordinate")], {
          16: listed(place, 6, "place"), 64: listed(axis, 3, "axis"), 88: [factor, offset],
        });
      });
      bodies.forEach((each, i) => {
        only(each, "a carried body", "body", "joint", "place");
        given.fill(carried + SIZE.carried * i, [whole(each.body, "body"), whole(each.joint, "joint")], { 8: listed(each.place ?? NONE, 6, "place") });
      });
      return [first, joints.length, carried, bodies.length];
    });
    this.dimension = module._tamis_linkage_dimension(this.placeFor(module));
  }
}
