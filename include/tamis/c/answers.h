/* What is asked about, and what is answered, by more than one handle. */
#ifndef TAMIS_C_ANSWERS_H
#define TAMIS_C_ANSWERS_H
#include "tamis/c/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Kinds of pairs and their vertices. Vertex-face: the vertex, then the face's vertices in the mesh's order.
 * Edge-edge: each edge ascending, the smaller edge first. Vertex-edge: the vertex, then the edge's, ascending.
 * Vertex-vertex: ascending. Vertices that a kind does not use are -1. */
enum { TAMIS_VERTEX_FACE = 0, TAMIS_EDGE_EDGE = 1, TAMIS_VERTEX_EDGE = 2, TAMIS_VERTEX_VERTEX = 3 };
/** Certified: proven to touch at some time of the bracket. Unresolved, on a path alone: arithmetic could not decide;
 * kept, because a contact must never be missed. */
enum { TAMIS_CERTIFIED = 0, TAMIS_UNRESOLVED = 1 };

/** What becomes of pairs that touch at t=0: they are contacts; they count once they have come apart; or the question
 * ends with TAMIS_INVALID_STEP, and its sentence names the first of them. */
enum { TAMIS_REPORT = 0, TAMIS_IGNORE = 1, TAMIS_FAIL = 2 };

/** Each vertex moves on a straight line from its row of `start` (t=0) to that of `end` (t=1). */
typedef struct tamis_step {
  size_t size;
  int32_t vertex_count;         /**< rows of both */
  const double* start;          /**< three coordinates a row */
  const double* end;            /**< the same at t=1 */
  ptrdiff_t start_stride;       /**< doubles from one row to the next, >= 3; 0: 3 */
  ptrdiff_t end_stride;         /**< the same of end */
  const double* min_separation; /**< of this question alone; NULL: the detector's */
  int32_t at_start;             /**< of a question to a detector: TAMIS_REPORT, TAMIS_IGNORE or TAMIS_FAIL */
} tamis_step;

/** One pair of features that touches during the step. */
typedef struct tamis_contact {
  int32_t kind;
  int32_t certainty;
  int32_t vertices[4];
  double toi_lower; /**< fraction of the step: the pair is apart on [0, toi_lower) */
  double toi_upper; /**< if certified, it touches at some time of [toi_lower, toi_upper] */
  double u, v;      /**< vf: point = (1-u-v) f0 + u f1 + v f2; ee: u on the first edge, v on the second; ve: u */
  /** Of unit length: the direction in which the first feature must go, or the second be pushed back, so that they part.
   * With a separation along the closest points at toi_lower; else of the face, or of both edges, on the side where the
   * first feature is just before they touch. Special cases: tamis/contact.hpp. */
  double normal[3];
  int32_t bodies[2]; /**< of a world: whose the first feature is, and the second; of a detector: -1 */
} tamis_contact;

/** Writes a signed weight for each of the four vertices of a contact, a near pair or a pair's result. The sum of
 * weights times positions is the vector from the second feature's point to the first's; over the first feature's
 * vertices alone it is the point there. TAMIS_INVALID_ARGUMENT: no such kind, or `weights` is NULL. */
TAMIS_API tamis_status tamis_weights_of(int32_t kind, double u, double v, double* weights);

/** A pair of features that are near each other; see NearPair in tamis/proximity.hpp. */
typedef struct tamis_near_pair {
  int32_t kind;
  int32_t vertices[4]; /**< as in tamis_contact */
  double distance;     /**< off by 2^-41 of the pair's extent at most; by 2^-1075 more if it is no normal double */
  double u, v;         /**< weights of two closest points; tamis_weights_of is 0 for vertices without a share */
  double direction[3]; /**< from the second feature's closest point to the first's */
  int32_t bodies[2];   /**< as in tamis_contact */
} tamis_near_pair;

/** How far a step may go so that a fraction of every distance is kept. */
typedef struct tamis_safe_step {
  size_t size;
  double lower;         /**< on [0, lower] every pair keeps the fraction, on [0, lower) none touches: proven */
  double upper;         /**< at this time some pair has no more than it left: proven; 1 if not known of any time */
  int32_t has_pair;     /**< 0: the whole step may go */
  tamis_near_pair pair; /**< the one that ends the step, at t=0; without meaning if has_pair is 0 */
} tamis_safe_step;

/** An edge that passes through a triangle, or touches it; see Intersection in tamis/proximity.hpp. */
typedef struct tamis_intersection {
  int32_t edge[2], face[3];
  double s_lower, s_upper; /**< the first common point lies between these on the edge */
  double u, v;             /**< and is (1-u-v) f0 + u f1 + v f2 */
  int32_t bodies[2];       /**< of a world: whose the edge is, and the face; of a detector: -1 */
} tamis_intersection;

/** What one pair does, as of a contact; what follows `touches` has no meaning if that is 0. */
typedef struct tamis_pair_result {
  int32_t touches; /**< 0: proven free */
  int32_t certainty;
  double toi_lower, toi_upper;
  double u, v;
  double normal[3];
} tamis_pair_result;

enum { TAMIS_MOST_STAGES = 16, TAMIS_MOST_KINDS = 8 };

typedef struct tamis_stage {
  const char* name;
  uint64_t pairs[TAMIS_MOST_KINDS]; /**< that entered, of each kind: pairs[TAMIS_EDGE_EDGE]; 0 of kinds to come */
} tamis_stage;

/** What the last question cost; times in seconds. */
typedef struct tamis_statistics {
  size_t size;
  const char* isa;
  int32_t threads;
  int32_t rebuilt; /**< 1: the hierarchy was built, not refitted */
  double seconds_total, seconds_bounds, seconds_build, seconds_traverse, seconds_filter, seconds_solve;
  uint64_t decided_by_lanes, decided_by_scalar, decided_by_exact, unresolved; /**< the last on paths alone */
  uint64_t nodes_visited, memory_bytes;
  int32_t stage_count;
  tamis_stage stages[TAMIS_MOST_STAGES]; /**< in the pipeline's order; names live until the next call for statistics */
  uint64_t ignored; /**< with TAMIS_IGNORE: pairs that touch at t=0, and not again once they are apart */
} tamis_statistics;

#ifdef __cplusplus
}
#endif
#endif
