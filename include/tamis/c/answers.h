/* Steps, answers and statistics, which several kinds of handles share. */
#ifndef TAMIS_C_ANSWERS_H
#define TAMIS_C_ANSWERS_H
#include "tamis/c/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Kinds of pairs and their vertices. Vertex-face: the vertex, then the face's vertices in the mesh's order. Edge-edge:
 * the vertices of each edge ascending, the smaller edge first. Vertex-edge: the vertex, then the edge's vertices,
 * ascending. Vertex-vertex: ascending. Entries that a kind does not use are -1. */
enum { TAMIS_VERTEX_FACE = 0, TAMIS_EDGE_EDGE = 1, TAMIS_VERTEX_EDGE = 2, TAMIS_VERTEX_VERTEX = 3 };
/** TAMIS_CERTIFIED, proven: the closed features touch (come within the minimum separation) at some time of the bracket.
 * TAMIS_UNRESOLVED, only on a path: arithmetic could not decide; kept, because a contact must never be missed. */
enum { TAMIS_CERTIFIED = 0, TAMIS_UNRESOLVED = 1 };

/** How a question counts pairs that touch at t=0. TAMIS_REPORT: they are contacts. TAMIS_IGNORE: a pair is a contact
 * only when it touches again, after a time at which it does not touch. TAMIS_FAIL: the question ends with
 * TAMIS_INVALID_STEP, and the message names the first such pair. */
enum { TAMIS_REPORT = 0, TAMIS_IGNORE = 1, TAMIS_FAIL = 2 };

/** One part of a loop, which parallel_for is given: `loop` as given, 0 <= i < count. Throws nothing. */
typedef void (*tamis_loop_body)(void* loop, int32_t i);

/** Each vertex moves on a straight line from its row of `start` (t=0) to that of `end` (t=1). */
typedef struct tamis_step {
  size_t size;                  /**< sizeof(tamis_step) */
  int32_t vertex_count;         /**< rows of both */
  const double* start;          /**< three coordinates a row */
  const double* end;            /**< the same at t=1 */
  ptrdiff_t start_stride;       /**< doubles from one row to the next, >= 3; 0: 3 */
  ptrdiff_t end_stride;         /**< the same of end */
  const double* min_separation; /**< for this question alone; NULL: the detector's */
  int32_t at_start;             /**< only for a detector's questions: TAMIS_REPORT, TAMIS_IGNORE or TAMIS_FAIL */
} tamis_step;

/** One pair of features that touches during the step. */
typedef struct tamis_contact {
  int32_t kind;        /**< 0: a vertex and a face, 1: two edges, 2: a vertex and an edge, 3: two vertices */
  int32_t certainty;   /**< TAMIS_CERTIFIED or TAMIS_UNRESOLVED */
  int32_t vertices[4]; /**< of the first feature, then of the second; -1 where the kind has fewer */
  double toi_lower;    /**< fraction of the step in [0, 1]: the pair is apart on [0, toi_lower) */
  double toi_upper;    /**< if certified, it touches at some time of [toi_lower, toi_upper] */
  double u;            /**< weight. vf: point = (1-u-v) f0 + u f1 + v f2; ee: on the first edge; ve: on the edge */
  double v;            /**< weight. vf: as above; ee: on the second edge */
  /** Unit vector. To part the features, move the first one along it, or the second one against it. With a minimum
   * separation or radii, and for vertex-edge and vertex-vertex: from the second feature's closest point to the first's
   * at toi_lower. Otherwise: the normal of the face, or the cross product of both edges, on the side where the first
   * feature is just before they touch. Special cases: Contact in tamis/contact.hpp. */
  double normal[3];
  int32_t bodies[2]; /**< in a world the first feature's body and the second's; from a detector -1 */
} tamis_contact;

/** Computes a signed weight for each of the four vertices of a contact, a near pair or a pair's result. The first
 * feature's vertices, weighted and summed, give its point. The second feature's give its point, negative. So the sum
 * over all is the vector from the second point to the first.
 * Writes the four weights; 0 for unused entries.
 * Returns TAMIS_INVALID_ARGUMENT if there is no such kind or `weights` is NULL. */
TAMIS_API tamis_status tamis_weights_of(int32_t kind, double u, double v, double* weights);

/** A pair of features that are near each other; see NearPair in tamis/proximity.hpp. */
typedef struct tamis_near_pair {
  int32_t kind;        /**< as in tamis_contact */
  int32_t vertices[4]; /**< as in tamis_contact */
  double distance; /**< proven: off by at most 2^-41 of the largest |component| of the differences between the pair's
                      vertices, and by at most 2^-1075 more below the smallest normal double */
  double u;        /**< weight of two closest points; tamis_weights_of gives 0 to vertices without a share */
  double v;        /**< second weight */
  double direction[3]; /**< unit vector from the second feature's closest point to the first's */
  int32_t bodies[2];   /**< as in tamis_contact */
} tamis_near_pair;

/** How far a step may go while every pair keeps a fraction of its distance. */
typedef struct tamis_safe_step {
  size_t size;          /**< sizeof(tamis_safe_step) */
  double toi_lower;     /**< on [0, toi_lower] every pair keeps the fraction, on [0, toi_lower) none touches: proven */
  double toi_upper;     /**< at this time some pair has at most the fraction left: proven; 1 if none is known */
  int32_t has_pair;     /**< 0: the whole step may go */
  tamis_near_pair pair; /**< the pair that ends the step, as it is at t=0; no meaning if has_pair is 0 */
} tamis_safe_step;

/** An edge that passes through a triangle, or touches it; see Intersection in tamis/proximity.hpp. */
typedef struct tamis_intersection {
  int32_t edge[2];   /**< vertices of the edge, ascending */
  int32_t face[3];   /**< vertices of the face, in the mesh's order */
  double s_lower;    /**< parameter of the first common point, from edge[0] on: in [s_lower, s_upper] */
  double s_upper;    /**< upper bound of that parameter */
  double u;          /**< weight: that point is (1-u-v) f0 + u f1 + v f2, rounded */
  double v;          /**< second weight */
  int32_t bodies[2]; /**< in a world the edge's body and the face's; from a detector -1 */
} tamis_intersection;

/** Whether and when one pair touches during the step; members as in tamis_contact. If `touches` is 0, the others have
 * no meaning. */
typedef struct tamis_pair_result {
  int32_t touches;   /**< 0: proven free */
  int32_t certainty; /**< as in tamis_contact */
  double toi_lower;  /**< as in tamis_contact */
  double toi_upper;  /**< as in tamis_contact */
  double u;          /**< as in tamis_contact */
  double v;          /**< as in tamis_contact */
  double normal[3];  /**< as in tamis_contact */
} tamis_pair_result;

/** Sizes of the arrays in tamis_statistics. */
enum { TAMIS_MOST_STAGES = 16, TAMIS_MOST_KINDS = 8 };

/** How many pairs enter one stage of the pipeline. */
typedef struct tamis_stage {
  const char* name;                 /**< the stage, such as "boxes" */
  uint64_t pairs[TAMIS_MOST_KINDS]; /**< how many pairs of each kind entered, as in pairs[TAMIS_EDGE_EDGE]; 0 for kinds
                                       to come */
} tamis_stage;

/** The cost of the last question; times in seconds. */
typedef struct tamis_statistics {
  size_t size;                /**< sizeof(tamis_statistics) */
  const char* isa;            /**< the instruction set that ran */
  int32_t threads;            /**< how many threads worked on it */
  int32_t rebuilt;            /**< 1: the hierarchy was built, not refitted */
  double seconds_total;       /**< the whole question */
  double seconds_bounds;      /**< computing boxes */
  double seconds_build;       /**< building or refitting trees, and listing pairs ahead */
  double seconds_traverse;    /**< searching the trees for pairs whose boxes meet */
  double seconds_filter;      /**< filtering pairs */
  double seconds_solve;       /**< deciding the remaining pairs */
  uint64_t decided_by_lanes;  /**< pairs decided in SIMD doubles with error bounds */
  uint64_t decided_by_scalar; /**< pairs decided one by one, without exact algebra */
  uint64_t decided_by_exact;  /**< pairs decided by exact algebra */
  uint64_t unresolved;        /**< unresolved contacts, on paths only */
  uint64_t nodes_visited;     /**< nodes of the trees, also to list pairs ahead; 0 if pairs had been listed */
  uint64_t memory_bytes;      /**< memory that the detector holds */
  int32_t stage_count;        /**< how many of `stages` there are */
  tamis_stage stages[TAMIS_MOST_STAGES]; /**< in the pipeline's order; names live until the next call for statistics */
  uint64_t ignored; /**< with TAMIS_IGNORE: pairs that touch at t=0 and do not touch again once they are apart */
} tamis_statistics;

#ifdef __cplusplus
}
#endif
#endif
