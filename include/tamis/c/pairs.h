/* Pairs of features, one or many: for callers who have a broad phase of their own. */
#ifndef TAMIS_C_PAIRS_H
#define TAMIS_C_PAIRS_H
#include "tamis/c/answers.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct tamis_pairs tamis_pairs;

typedef struct tamis_pair_options {
  size_t size;
  double min_separation; /**< d >= 0, as in tamis_options */
  int32_t threads;       /**< the same */
  const char* isa;       /**< the same */
  /** The latest time of interest, in [0,1]. A pair that is proven apart until then counts as free. The answers about
   * other pairs do not depend on it. NULL: 1. */
  const double* latest;
  /** Called again and again during a call with a list, from several threads. Once it returns other than 0, the call
   * ends with TAMIS_CANCELLED. */
  int (*is_cancelled)(void* user);
  void* user; /**< passed to is_cancelled */
} tamis_pair_options;

/** `options` NULL: the defaults. */
TAMIS_API tamis_status tamis_pairs_create(const tamis_pair_options* options, tamis_pairs** pairs);
TAMIS_API void tamis_pairs_free(tamis_pairs* pairs);
/** The message of the last call with these pairs; "" after TAMIS_OK. */
TAMIS_API const char* tamis_pairs_message(const tamis_pairs* pairs);
/** `count` pairs of a vertex p and a face a b c, each point moving on a straight line: a pair is 12 doubles, p a b c,
 * in `start` (t=0) and again in `end` (t=1). Writes `count` results of `result_size` = sizeof(tamis_pair_result) bytes;
 * after a failure the results have no meaning. */
TAMIS_API tamis_status tamis_vertex_face(tamis_pairs* pairs, size_t count, const double* start, const double* end,
                                         tamis_pair_result* results, size_t result_size);
/** Edge (0,1) against edge (2,3); otherwise the same. */
TAMIS_API tamis_status tamis_edge_edge(tamis_pairs* pairs, size_t count, const double* start, const double* end,
                                       tamis_pair_result* results, size_t result_size);
/** Points against segments: a pair is 9 doubles, p a b; otherwise the same. */
TAMIS_API tamis_status tamis_vertex_edge(tamis_pairs* pairs, size_t count, const double* start, const double* end,
                                         tamis_pair_result* results, size_t result_size);
/** Two points: a pair is 6 doubles; otherwise the same. */
TAMIS_API tamis_status tamis_vertex_vertex(tamis_pairs* pairs, size_t count, const double* start, const double* end,
                                           tamis_pair_result* results, size_t result_size);

/** One pair of a list: what a broad phase hands on. */
typedef struct tamis_feature_pair {
  int32_t kind;        /**< TAMIS_VERTEX_FACE, ... */
  int32_t vertices[4]; /**< rows of the step: p a b c, a0 a1 b0 b1, p a b, or p q; unused entries are not read */
} tamis_feature_pair;

/** The narrow phase of a list; otherwise the same. The positions may have any number of rows. The step's
 * min_separation, unless it is NULL, replaces that of `pairs`. */
TAMIS_API tamis_status tamis_narrow_phase(tamis_pairs* pairs, const tamis_feature_pair* list, size_t count,
                                          const tamis_step* step, tamis_pair_result* results, size_t result_size);

/** The distance of each pair of a list at the step's start, as tamis_detector_pairs_within returns it: no separation is
 * subtracted. Writes `count` answers of `answer_size` = sizeof(tamis_near_pair) bytes. The step's end is not read. */
TAMIS_API tamis_status tamis_distances_of(tamis_pairs* pairs, const tamis_feature_pair* list, size_t count,
                                          const tamis_step* step, tamis_near_pair* answers, size_t answer_size);
/** As tamis_detector_safe_step, for one pair; 0.1 is a usual fraction. It searches up to the latest time of interest; a
 * pair that keeps its fraction until then has `toi_lower` = that time. */
TAMIS_API tamis_status tamis_pair_safe_step(tamis_pairs* pairs, const tamis_feature_pair* pair, const tamis_step* step,
                                            double keep, tamis_safe_step* answer);

#ifdef __cplusplus
}
#endif
#endif
