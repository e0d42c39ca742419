/** Every contact between moving, deforming triangle meshes, and a proof for all other pairs.
 *
 * ```js
 * import { load } from "tamis";
 * const tamis = await load();
 * using detector = tamis.detector({ faces: [0, 1, 2, 3, 4, 5] });
 * for (const { vertices, toiLower } of detector.contacts(start, end)) console.log(vertices[0], toiLower);
 * ```
 */
import { KINDS } from "./answers.js";
import type { Kind } from "./answers.js";
import { Detector } from "./detector.js";
import { Linkage } from "./linkage.js";
import type { LinkageInput } from "./linkage.js";
import { need, TamisError, within } from "./memory.js";
import type { Numbers } from "./memory.js";
import { Mesh } from "./mesh.js";
import type { MeshInput } from "./mesh.js";
import { createModule, version } from "./module.js";
import type { Module } from "./module.js";
import type { DetectorOptions, PairOptions, WorldOptions } from "./options.js";
import { Pairs } from "./pairs.js";
import { functionPath, rigidPath, splinePath } from "./path.js";
import type { FunctionPathInput, Path, RigidPathInput } from "./path.js";
import { Poses } from "./poses.js";
import { Shape } from "./shape.js";
import { World } from "./world.js";

export { Rows } from "./answers.js";
export type { Contact, Earliest, EdgeAnswer, Intersection, Kind, NearPair, OfBodies, PairResult, SafeStep } from "./answers.js";
export type { Detector, Motion, Positions } from "./detector.js";
export type { CarriedBody, Joint, Linkage, LinkageInput } from "./linkage.js";
export { TamisError } from "./memory.js";
export type { Numbers } from "./memory.js";
export type { Mesh, MeshInput } from "./mesh.js";
export type { Module } from "./module.js";
export type { Motions } from "./motions.js";
export type { DetectorOptions, EdgeOptions, PairOptions, PathOptions, QueryOptions, WorldOptions } from "./options.js";
export type { Kinds, Pairs } from "./pairs.js";
export type { FunctionPathInput, Path, RigidPathInput } from "./path.js";
export type { Chain, Pose } from "./poses.js";
export type { Statistics } from "./questions.js";
export type { Shape } from "./shape.js";
export type { World } from "./world.js";
export type { Tamis };

/** The library, loaded, with memory of its own. */
class Tamis extends Poses {
  /** Such as "0.1.0". */
  get version(): string {
    return this.module.UTF8ToString(this.module._tamis_version());
  }

  /** A mesh that detectors and shapes may share. Refuses as the C interface does, with its sentence; so do all of these. */
  mesh(input: MeshInput): Mesh {
    return new Mesh(this.module, input);
  }
  /** A detector for a mesh: keep it from step to step. */
  detector(mesh: Mesh | MeshInput, options: DetectorOptions = {}): Detector {
    return new Detector(this.module, mesh, options);
  }
  /** A shape for bodies of worlds. `points`: three numbers a vertex, in the body's own frame. */
  shape(mesh: Mesh | MeshInput, points: Numbers): Shape {
    return new Shape(this.module, mesh, points);
  }
  /** A world without bodies. */
  world(options: WorldOptions = {}): World {
    return new World(this.module, options);
  }
  /** A robot of bodies that a world has. */
  linkage(input: LinkageInput): Linkage {
    return new Linkage(this.module, input);
  }
  /** For pairs of your own broad phase. */
  pairs(options: PairOptions = {}): Pairs {
    return new Pairs(this.module, options);
  }

  /** Bodies that each move on a chain of links. */
  rigidPath(input: RigidPathInput): Path {
    return rigidPath(this.module, input);
  }
  /** Each vertex on a Bezier curve: a control point of every vertex, then the next one of every vertex, ... */
  bezierPath(controlPoints: Numbers, vertexCount: number): Path {
    return splinePath(this.module, "bezier_path_create", controlPoints, vertexCount);
  }
  /** Through frames at equal distances of time, smoothly. */
  catmullRomPath(frames: Numbers, vertexCount: number): Path {
    return splinePath(this.module, "catmull_rom_path_create", frames, vertexCount);
  }
  /** Any motion, by two functions. */
  functionPath(input: FunctionPathInput): Path {
    return functionPath(this.module, input);
  }

  /** The signed weights of a contact's four vertices: positions, weighted and summed, give the vector from the second point to the first. */
  weightsOf({ kind, u, v }: { kind: Kind; u: number; v: number }): Float64Array {
    return within(this.module, (given) => {
      const weights = given.room(32);
      const status = this.module._tamis_weights_of(KINDS.indexOf(kind), u, v, weights);
      need(status === 0, `there is no kind '${kind}': use ${KINDS.join(", ")}`, status);
      return given.viewOfDoubles(weights, 4).slice();
    });
  }
}

/** Compiles the library. Each call makes one with a memory of its own, which grows up to 2 GB. */
export async function load(): Promise<Tamis> {
  const tamis = new Tamis(await createModule());
  if (tamis.version !== version)
    throw new TamisError(`module.js holds tamis ${tamis.version}, but the package is ${version}: install the package anew`, 8);
  return tamis;
}
