import { KINDS, VERTICES } from "./answers.js";
import type { Kind } from "./answers.js";
import { Handle } from "./handle.js";
import { need, only, rowsOf, whole } from "./memory.js";
import type { Memory, Numbers } from "./memory.js";
import type { Module } from "./module.js";

/** What moves: triangles, and loose edges and points. Numbers are rows of the positions. */
export interface MeshInput {
  /** Three vertices a triangle. */
  faces?: Numbers;
  /** Two vertices an edge. */
  looseEdges?: Numbers;
  loosePoints?: Numbers;
  /** Rows of the positions; one more than the largest number, if it is not given. */
  vertexCount?: number;
}

const SIZE = 32;

/** The topology of what moves. Detectors and shapes take it, or what it is made of. */
export class Mesh extends Handle {
  /** Rows of the positions. */
  readonly vertexCount: number;

  /** @internal Tamis.mesh makes meshes. */
  constructor(module: Module, input: MeshInput) {
    super(module, "mesh");
    only(input, "a mesh", "faces", "looseEdges", "loosePoints", "vertexCount");
    const { faces = [], looseEdges = [], loosePoints = [] } = input;
    this.vertexCount = whole(input.vertexCount ?? countOf([faces, looseEdges, loosePoints]), "vertexCount");
    const counts = [rowsOf(faces, 3, "faces", "triangle"), rowsOf(looseEdges, 2, "looseEdges", "edge")];
    this.make("mesh_create", (given) => [
      given.struct(SIZE, [
        this.vertexCount, given.integers(faces), counts[0], given.integers(looseEdges), counts[1], given.integers(loosePoints), loosePoints.length,
      ]),
    ]);
  }

  /** Two vertices for each edge of a triangle and each loose edge, ascending; a view that lives as long as the mesh. */
  get edges(): Int32Array {
    return this.listed("edges", 2);
  }
  /** The vertices that take part in contacts. */
  get points(): Int32Array {
    return this.listed("points", 1);
  }

  /** Both features of a contact: a face by its place in `faces`, an edge by its place in `edges`, a vertex by its number. */
  featuresOf(kind: Kind, vertices: Numbers): [first: number, second: number] {
    const number = KINDS.indexOf(kind);
    need(number >= 0 && vertices.length >= VERTICES[number], `'${kind}' with ${vertices.length} vertices: give a kind and its vertices`);
    const [first, second] = this.found(2, (given, place) => {
      this.call("mesh_features_of", number, given.integers(vertices), place, place + 4);
    });
    return [first, second];
  }
  /** For each edge, two vertices in any order, its place in `edges`, or -1. */
  findEdges(edges: Numbers): Int32Array {
    const count = rowsOf(edges, 2, "edges", "edge");
    return this.found(count, (given, place) => this.call("mesh_find_edges", given.integers(edges), count, place));
  }
  /** For each face, three vertices in the mesh's order, its place in `faces`, or -1. */
  findFaces(faces: Numbers): Int32Array {
    const count = rowsOf(faces, 3, "faces", "face");
    return this.found(count, (given, place) => this.call("mesh_find_faces", given.integers(faces), count, place));
  }

  private found(count: number, find: (given: Memory, place: number) => void): Int32Array {
    return this.ask((given) => {
      const place = given.room(4 * count);
      find(given, place);
      return given.viewOfIntegers(place, count).slice();
    });
  }

  private listed(name: "edges" | "points", width: number): Int32Array {
    return this.ask((given) => {
      const count = given.room(4);
      const place = this.module[`_tamis_mesh_${name}`](this.placeFor(this.module), count);
      return this.kept.viewOfIntegers(place, width * this.module.HEAPU32[count / 4]);
    });
  }
}

/** Uses a mesh that was given, or one that is made for this alone. */
export function withMesh<T>(module: Module, mesh: Mesh | MeshInput, use: (mesh: Mesh) => T): T {
  if (mesh instanceof Mesh) return use(mesh);
  const made = new Mesh(module, mesh);
  try {
    return use(made);
  } finally {
    made.free();
  }
}

function countOf(lists: Numbers[]): number {
  let largest = -1;
  for (const numbers of lists) for (let i = 0; i < numbers.length; ++i) largest = Math.max(largest, numbers[i]);
  return largest + 1;
}
