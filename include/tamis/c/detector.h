/* Detector: every contact of a mesh with itself, step after step. */
#ifndef TAMIS_C_DETECTOR_H
#define TAMIS_C_DETECTOR_H
#include "tamis/c/answers.h"
#include "tamis/c/mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Holds a mesh and the hierarchy over it: keep it from step to step. */
typedef struct tamis_detector tamis_detector;

/** Options of a detector. A field that is zero has its default. */
typedef struct tamis_options {
  size_t size;           /**< sizeof(tamis_options) */
  const char* isa;       /**< "best", "baseline", "avx2", "avx512"; NULL: "best". Changes speed only */
  int32_t threads;       /**< 0: as many as the caller's oneTBB arena gives; without oneTBB 1. Changes speed only */
  double min_separation; /**< d >= 0: contact means Euclidean distance <= d */
  const int32_t* group_of_vertex;  /**< the group of each vertex, in [0, group_count), or -1 for a vertex that takes no
                                      part in contacts; NULL: all vertices are in group 0, group_count is 0 or 1 and
                                      groups_may_touch is NULL, too */
  int32_t group_count;             /**< 0: one group */
  const uint8_t* groups_may_touch; /**< group_count x group_count, symmetric; 0 skips the pairs of these two groups;
                                      NULL: none are skipped */
  /** Called, after the groups, for each pair that may still be in the answer, from several threads. 0 skips the pair.
   * NULL: no pair is skipped. */
  int (*accepts)(void* user, int32_t kind, const int32_t* vertices);
  /** Called again and again during a question, from several threads. Once it returns other than 0, the question ends
   * with TAMIS_CANCELLED. */
  int (*is_cancelled)(void* user);
  void* user;          /**< passed to all of these functions */
  const double* radii; /**< a radius >= 0 for each group, group_count of them: half of its thickness; NULL: all zero */
  int32_t rings;       /**< skips pairs whose features are fewer than `rings` edges apart along the mesh; 0: 1, which
                          skips pairs with a common vertex */
  /** Your own threads: runs a loop of the detector, on `threads` threads (0: one a core). Must call body(loop, i) once
   * for each i in [0, count), on any threads, in any order, and return when all calls have returned. Called by the
   * calling thread, never from within a body, and not if `threads` is 1. NULL: oneTBB's threads; without oneTBB
   * (tamis_has_threads()) the calling thread. */
  void (*parallel_for)(void* user, int32_t count, tamis_loop_body body, void* loop);
} tamis_options;

/** Makes a detector. Copies the mesh. `options` NULL: the defaults.
 * Writes the handle, also if the call fails (tamis/tamis.h).
 * Returns TAMIS_INVALID_OPTIONS where the constructor of Detector throws InvalidOptions (tamis/detector.hpp). */
TAMIS_API tamis_status tamis_detector_create(const tamis_mesh* mesh, const tamis_options* options,
                                             tamis_detector** detector);
/** Frees the detector. NULL: does nothing. */
TAMIS_API void tamis_detector_free(tamis_detector* detector);
/** Returns the message of the last call with this detector; "" after TAMIS_OK. */
TAMIS_API const char* tamis_detector_message(const tamis_detector* detector);

/** Finds all contacts of the step.
 * Writes their number. tamis_detector_copy_contacts() copies them, sorted by kind, then vertices.
 * Returns TAMIS_INVALID_STEP and TAMIS_INVALID_OPTIONS where Detector::contacts throws (tamis/detector.hpp). */
TAMIS_API tamis_status tamis_detector_contacts(tamis_detector* detector, const tamis_step* step, size_t* count);
/** Finds the first contact.
 * Writes a bracket of its time. The motion is free on [0, *toi_lower): proven. A certified contact happens at or before
 * *toi_upper. If the step is free, *count is 0 and both times are 1. Otherwise *count is 1, and
 * tamis_detector_copy_contacts() copies the contact.
 * Returns TAMIS_INVALID_STEP and TAMIS_INVALID_OPTIONS as tamis_detector_contacts. */
TAMIS_API tamis_status tamis_detector_earliest(tamis_detector* detector, const tamis_step* step, double* toi_lower,
                                               double* toi_upper, size_t* count);
/** Tests whether the whole step is free of contacts.
 * Writes 1 if it is, else 0.
 * Returns TAMIS_INVALID_STEP and TAMIS_INVALID_OPTIONS as tamis_detector_contacts. */
TAMIS_API tamis_status tamis_detector_is_free(tamis_detector* detector, const tamis_step* step, int* is_free);

/** Finds how far the step may go while every pair keeps at least the fraction `keep` of its distance at t=0. The
 * distance that counts is what exceeds the minimum separation and both radii. 0 <= keep < 1. C has no default
 * arguments: C++ and Python take 0.1, here and for tamis_detector_truncate. Which value when: Detector in
 * tamis/detector.hpp.
 * Writes a bracket of the time, and the pair that ends the step.
 * Returns TAMIS_INVALID_OPTIONS if `keep` is out of its range, otherwise as tamis_detector_contacts. */
TAMIS_API tamis_status tamis_detector_safe_step(tamis_detector* detector, const tamis_step* step, double keep,
                                                tamis_safe_step* answer);

/** The number type of the positions that the caller keeps between steps. */
enum { TAMIS_FLOAT64 = 0, TAMIS_FLOAT32 = 1 };

/** Finds positions to go to, each vertex as far as it may on its own line. On the straight way there every pair keeps
 * the fraction `keep` of its distance, 0 < keep < 1: proven. `stored`: TAMIS_FLOAT64 or TAMIS_FLOAT32. With
 * TAMIS_FLOAT32 all positions are float values, so storing them as floats changes nothing. Then the step's start must
 * consist of float values. See Detector::truncate in tamis/detector.hpp.
 * Writes three doubles for each vertex of the mesh to `positions`. Writes to `fractions` for each vertex the fraction
 * of its way that it goes, in [0, 1]; NULL: not wanted. *is_free is 0 if some pair touches at the start and is not
 * ignored; such a pair comes no nearer.
 * Returns TAMIS_INVALID_OPTIONS if `keep` is out of its range. Returns TAMIS_INVALID_ARGUMENT if `stored` is neither of
 * the two. With TAMIS_FLOAT32 returns TAMIS_INVALID_STEP if the start does not consist of float values, or if the end
 * is beyond their range. Otherwise as tamis_detector_contacts. */
TAMIS_API tamis_status tamis_detector_truncate(tamis_detector* detector, const tamis_step* step, double keep,
                                               int32_t stored, double* positions, double* fractions, int* is_free);

/** Finds every pair of features whose distance at the step's start is at most `distance` plus both radii. The step's
 * end is not read.
 * Writes their number. tamis_detector_copy_pairs_within() copies them.
 * Returns TAMIS_INVALID_STEP and TAMIS_INVALID_OPTIONS where Detector::pairs_within throws (tamis/detector.hpp). */
TAMIS_API tamis_status tamis_detector_pairs_within(tamis_detector* detector, const tamis_step* step, double distance,
                                                   size_t* count);
/** Finds every edge that passes through a triangle or touches it at the step's start, and shares no vertex with it.
 * Decided exactly. The step's end is not read.
 * Writes their number. tamis_detector_copy_intersections() copies them.
 * Returns TAMIS_INVALID_STEP where Detector::intersections throws (tamis/detector.hpp). */
TAMIS_API tamis_status tamis_detector_intersections(tamis_detector* detector, const tamis_step* step, size_t* count);
/** Tests whether there is any intersection. Ends at the first one.
 * Writes 1 if there is one, else 0.
 * Returns TAMIS_INVALID_STEP as tamis_detector_intersections. */
TAMIS_API tamis_status tamis_detector_has_intersection(tamis_detector* detector, const tamis_step* step,
                                                       int* has_intersection);
/** Copies near pairs of the last question about them, as tamis_detector_copy_contacts copies contacts. */
TAMIS_API tamis_status tamis_detector_copy_pairs_within(tamis_detector* detector, size_t first, size_t count,
                                                        tamis_near_pair* pairs, size_t pair_size);
/** Copies intersections of the last question about them, as tamis_detector_copy_contacts copies contacts. */
TAMIS_API tamis_status tamis_detector_copy_intersections(tamis_detector* detector, size_t first, size_t count,
                                                         tamis_intersection* intersections, size_t intersection_size);

/** Copies contacts [first, first + count) of the last question about a step or a path. Only questions for contacts or
 * for the earliest one leave contacts to copy.
 * Writes them into an array whose elements are `contact_size` = sizeof(tamis_contact) bytes.
 * Returns TAMIS_INVALID_ARGUMENT if the last question left fewer contacts. */
TAMIS_API tamis_status tamis_detector_copy_contacts(tamis_detector* detector, size_t first, size_t count,
                                                    tamis_contact* contacts, size_t contact_size);

/** Writes the cost of the last question. */
TAMIS_API tamis_status tamis_detector_statistics(tamis_detector* detector, tamis_statistics* statistics);

#ifdef __cplusplus
}
#endif
#endif
