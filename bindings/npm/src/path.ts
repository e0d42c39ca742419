import type { PairResult, Rows } from "./answers.js";
import { Handle } from "./handle.js";
import { pairResult } from "./layouts.js";
import { need, only, rowsOf, whole, within } from "./memory.js";
import type { Memory, Numbers } from "./memory.js";
import type { Module } from "./module.js";
import { pathOptions } from "./options.js";
import type { Cancellable, PathOptions } from "./options.js";
import type { Chain } from "./poses.js";

/** Bodies that each move on a chain of links. */
export interface RigidPathInput {
  /** Each vertex in its body's own frame, three numbers a vertex. */
  rest: Numbers;
  /** The body of each vertex, in [0, chains.length). */
  bodyOfVertex: Numbers;
  chains: readonly Chain[];
  /** Where each vertex, which goes straight in that frame, is at t=1; by default all stay. */
  restEnd?: Numbers;
}

/** Any motion. Answers are only as true as the bounds that these functions write. */
export interface FunctionPathInput {
  vertexCount: number;
  /** Writes where these vertices are, three numbers each, and for each a bound: no coordinate is off by more. */
  pointsAt(time: number, vertices: Int32Array, points: Float64Array, errors: Float64Array): void;
  /** Writes for each vertex a bound of its distance from the chord between two times, as |x''| (to - from)^2 / 8. */
  deviations(from: number, to: number, vertices: Int32Array, deviations: Float64Array): void;
}

/** Options of a list of pairs on a path. */
export type PathPairOptions = Omit<PathOptions, "atStart"> & Cancellable;

const SIZE = { rigid: 32, spline: 16, functions: 20 };

/** How all vertices move for t in [0, 1], on curves. Detectors take it instead of start and end. */
export class Path extends Handle {
  /** @internal */
  constructor(
    module: Module,
    /** Rows of the positions. */
    readonly vertexCount: number,
    create: string,
    input: (given: Memory, kept: Memory) => number,
  ) {
    super(module, "path");
    this.make(create, (given) => [input(given, this.kept)]);
  }

  /** Where the vertices are at a time in [0, 1], rounded to doubles. */
  pointsAt(time: number): Float64Array {
    return within(this.module, (given) => {
      const place = given.room(24 * this.vertexCount);
      this.call("path_points_at", time, place);
      return given.viewOfDoubles(place, 3 * this.vertexCount).slice();
    });
  }

  /** Decides pairs of a vertex and a face, four vertices each. */
  vertexFace(vertices: Numbers, options: PathPairOptions = {}): Rows<PairResult> {
    return this.decided("vertex_face", 4, vertices, options);
  }
  /** Pairs of two edges, four vertices each. */
  edgeEdge(vertices: Numbers, options: PathPairOptions = {}): Rows<PairResult> {
    return this.decided("edge_edge", 4, vertices, options);
  }
  /** Pairs of a vertex and an edge, three vertices each. */
  vertexEdge(vertices: Numbers, options: PathPairOptions = {}): Rows<PairResult> {
    return this.decided("vertex_edge", 3, vertices, options);
  }
  /** Pairs of two vertices. */
  vertexVertex(vertices: Numbers, options: PathPairOptions = {}): Rows<PairResult> {
    return this.decided("vertex_vertex", 2, vertices, options);
  }

  private decided(name: string, width: number, vertices: Numbers, options: PathPairOptions): Rows<PairResult> {
    const count = rowsOf(vertices, width, "vertices", "pair");
    return this.ask((given) => {
      const asked = [pathOptions(given, options, "isCancelled"), count, given.integers(vertices)];
      return this.table(pairResult, count, (place, bytes) => this.call(`path_${name}`, ...asked, place, bytes));
    });
  }
}

export function rigidPath(module: Module, input: RigidPathInput): Path {
  only(input, "a rigid path", "rest", "bodyOfVertex", "chains", "restEnd");
  const { rest, bodyOfVertex, chains, restEnd } = input;
  const count = rowsOf(rest, 3, "rest", "vertex");
  need(bodyOfVertex.length === count, `bodyOfVertex has ${bodyOfVertex.length} numbers, rest ${count} vertices: give as many`, 9);
  need(!restEnd || restEnd.length === rest.length, `restEnd has ${restEnd?.length} numbers, rest ${rest.length}: give as many`, 9);
  const links = chains.map((chain, body) => rowsOf(chain, 12, `chain ${body}`, "link"));
  return new Path(module, count, "rigid_path_create", (given) =>
    given.struct(SIZE.rigid, [
      count, given.doubles(rest), given.integers(bodyOfVertex), chains.length, given.integers(links),
      given.doubles(chains.flatMap((chain) => Array.from(chain))), restEnd ? given.doubles(restEnd) : 0,
    ]),
  );
}

export function splinePath(module: Module, create: string, frames: Numbers, vertexCount: number): Path {
  const count = rowsOf(frames, 3 * whole(vertexCount, "vertexCount"), "frames", `frame of ${vertexCount} vertices`);
  return new Path(module, vertexCount, create, (given) => given.struct(SIZE.spline, [vertexCount, count, given.doubles(frames)]));
}

/** Coordinates that a function does not write are not numbers, and the library refuses them. */
export function functionPath(module: Module, input: FunctionPathInput): Path {
  only(input, "a function path", "vertexCount", "pointsAt", "deviations");
  const vertexCount = whole(input.vertexCount, "vertexCount");
  return new Path(module, vertexCount, "function_path_create", (given, kept) => {
    const written = (place: number, length: number) => kept.viewOfDoubles(place, length).fill(NaN);
    const pointsAt = kept.callback(
      (_user, time, vertices, count, points, errors) => {
        const views = [written(points, 3 * count), written(errors, count)] as const;
        input.pointsAt(time, kept.viewOfIntegers(vertices, count), ...views);
        return 0;
      },
      "vidiiii", (_user, _time, _vertices, count, _points, errors) => (written(errors, count), 0),
    );
    const deviations = kept.callback(
      (_user, from, to, vertices, count, place) => {
        input.deviations(from, to, kept.viewOfIntegers(vertices, count), written(place, count));
        return 0;
      },
      "viddiii", (_user, _from, _to, _vertices, count, place) => (written(place, count), 0),
    );
    return given.struct(SIZE.functions, [vertexCount, pointsAt, deviations]);
  });
}
