/* Pairs of features, one or many: for callers who have a broad phase of their own. */
#ifndef TAMIS_C_PAIRS_H
#define TAMIS_C_PAIRS_H
#include "tamis/c/answers.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Holds options and buffers for questions about pairs. */
typedef struct tamis_pairs tamis_pairs;

/** Options of questions about pairs. A field that is zero has its default. */
typedef struct tamis_pair_options {
  size_t size;           /**< sizeof(tamis_pair_options) */
  double min_separation; /**< d >= 0, as in tamis_options */
  int32_t threads;       /**< the same */
  const char* isa;       /**< the same */
  /** The latest time of interest, in [0,1]. A pair that is proven apart until then counts as free. The answers about
   * other pairs do not depend on it. NULL: 1. */
  const double* latest;
  /** Called again and again during a call with a list, from several threads. Once it returns other than 0, the call
   * ends with TAMIS_CANCELLED. */
  int (*is_cancelled)(void* user);
  void* user; /**< passed to is_cancelled and parallel_for */
  void (*parallel_for)(void* user, int32_t count, tamis_loop_body body, void* loop); /**< for a list: as in
                                                                                        tamis_options */
} tamis_pair_options;

/** Makes a handle for questions about pairs. `options` NULL: the defaults.
 * Writes the handle, also if the call fails (tamis/tamis.h).
 * Returns TAMIS_INVALID_OPTIONS if an option is out of its range. */
TAMIS_API tamis_status tamis_pairs_create(const tamis_pair_options* options, tamis_pairs** pairs);
/** Frees the handle. NULL: does nothing. */
TAMIS_API void tamis_pairs_free(tamis_pairs* pairs);
/** Returns the message of the last call with these pairs; "" after TAMIS_OK. */
TAMIS_API const char* tamis_pairs_message(const tamis_pairs* pairs);
/** Decides `count` pairs of a vertex p and a face a b c, each point moving on a straight line. A pair is 12 doubles, p
 * a b c, in `start` (t=0) and again in `end` (t=1).
 * Writes `count` results of `result_size` = sizeof(tamis_pair_result) bytes. After a failure the results have no
 * meaning.
 * Returns TAMIS_INVALID_STEP if a coordinate is not finite. */
TAMIS_API tamis_status tamis_vertex_face(tamis_pairs* pairs, size_t count, const double* start, const double* end,
                                         tamis_pair_result* results, size_t result_size);
/** Decides edge (0,1) against edge (2,3); otherwise the same. */
TAMIS_API tamis_status tamis_edge_edge(tamis_pairs* pairs, size_t count, const double* start, const double* end,
                                       tamis_pair_result* results, size_t result_size);
/** Decides points against segments: a pair is 9 doubles, p a b; otherwise the same. */
TAMIS_API tamis_status tamis_vertex_edge(tamis_pairs* pairs, size_t count, const double* start, const double* end,
                                         tamis_pair_result* results, size_t result_size);
/** Decides two points: a pair is 6 doubles; otherwise the same. */
TAMIS_API tamis_status tamis_vertex_vertex(tamis_pairs* pairs, size_t count, const double* start, const double* end,
                                           tamis_pair_result* results, size_t result_size);

/** One pair of a list, as a broad phase finds it. */
typedef struct tamis_feature_pair {
  int32_t kind;        /**< TAMIS_VERTEX_FACE, ... */
  int32_t vertices[4]; /**< rows of the step: p a b c, a0 a1 b0 b1, p a b, or p q; unused entries are not read */
} tamis_feature_pair;

/** Decides the pairs of a list: the narrow phase. The positions may have any number of rows. The step's min_separation,
 * unless it is NULL, replaces that of `pairs`.
 * Writes `count` results, as tamis_vertex_face.
 * Returns TAMIS_INVALID_STEP and TAMIS_INVALID_OPTIONS where narrow_phase throws (tamis/pair.hpp). */
TAMIS_API tamis_status tamis_narrow_phase(tamis_pairs* pairs, const tamis_feature_pair* list, size_t count,
                                          const tamis_step* step, tamis_pair_result* results, size_t result_size);

/** Computes the distance of each pair of a list at the step's start, as tamis_detector_pairs_within returns it: no
 * separation is subtracted. The step's end is not read.
 * Writes `count` answers of `answer_size` = sizeof(tamis_near_pair) bytes.
 * Returns TAMIS_INVALID_STEP as tamis_narrow_phase. */
TAMIS_API tamis_status tamis_distances_of(tamis_pairs* pairs, const tamis_feature_pair* list, size_t count,
                                          const tamis_step* step, tamis_near_pair* answers, size_t answer_size);
/** Finds how far one pair may go, as tamis_detector_safe_step; 0.1 is a usual fraction. It searches up to the latest
 * time of interest.
 * Writes a bracket of the time. A pair that keeps its fraction until the latest time of interest has `toi_lower` = that
 * time.
 * Returns TAMIS_INVALID_OPTIONS unless 0 <= keep < 1, TAMIS_INVALID_STEP as tamis_narrow_phase. */
TAMIS_API tamis_status tamis_pair_safe_step(tamis_pairs* pairs, const tamis_feature_pair* pair, const tamis_step* step,
                                            double keep, tamis_safe_step* answer);

#ifdef __cplusplus
}
#endif
#endif
