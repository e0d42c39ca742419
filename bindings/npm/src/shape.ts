import { Handle } from "./handle.js";
import { need } from "./memory.js";
import type { Numbers } from "./memory.js";
import { withMesh } from "./mesh.js";
import type { Mesh, MeshInput } from "./mesh.js";
import type { Module } from "./module.js";

/** A mesh with its points at rest, in the body's own frame: made once, for any number of bodies, which keep their own part of it. */
export class Shape extends Handle {
  readonly vertexCount: number;

  /** @internal Tamis.shape makes shapes. */
  constructor(module: Module, mesh: Mesh | MeshInput, points: Numbers) {
    super(module, "shape");
    this.vertexCount = withMesh(module, mesh, (made) => {
      const { vertexCount } = made;
      need(points.length === 3 * vertexCount, `points has ${points.length} numbers: give ${3 * vertexCount}, three a vertex`, 2);
      this.make("shape_create", (given) => [made.placeFor(module), given.doubles(points), 0]);
      return vertexCount;
    });
  }
}
