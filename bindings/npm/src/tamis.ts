/** Every contact between moving, deforming triangle meshes, and a proof for all other pairs.
 *
 * ```js
 * import { load } from "tamis";
 * const tamis = await load();
 * using detector = tamis.detector({ faces: [0, 1, 2, 3, 4, 5] });
 * for (const { vertices, toiLower } of detector.contacts(start, end)) console.log(vertices[0], toiLower);
 * ```
 */
import { Detector } from "./detector.js";
import type { DetectorOptions, MeshInput } from "./detector.js";
import { TamisError } from "./memory.js";
import { createModule, version } from "./module.js";
import type { Module } from "./module.js";

export { Rows } from "./answers.js";
export type { Contact, Intersection, Kind, NearPair } from "./answers.js";
export type { Detector, DetectorOptions, MeshInput, Positions, QueryOptions } from "./detector.js";
export { TamisError } from "./memory.js";
export type { Module } from "./module.js";
export type { Tamis };

/** The library, loaded, with memory of its own. */
class Tamis {
  /** @internal Use load(). */
  constructor(
    /** Every function of the C interface, with `_` before its name: for what Detector does not offer, such as worlds. */
    readonly module: Module,
  ) {}

  /** Such as "0.1.0". */
  get version(): string {
    return this.module.UTF8ToString(this.module._tamis_version());
  }

  /** A detector for a mesh: keep it from step to step. Refuses what the C interface refuses, with its sentence. */
  detector(mesh: MeshInput, options: DetectorOptions = {}): Detector {
    return new Detector(this.module, mesh, options);
  }
}

/** Compiles the library. Each call makes one with a memory of its own, which grows up to 2 GB. */
export async function load(): Promise<Tamis> {
  const tamis = new Tamis(await createModule());
  if (tamis.version !== version)
    throw new TamisError(`module.js holds tamis ${tamis.version}, but the package is ${version}: install the package anew`, 8);
  return tamis;
}
