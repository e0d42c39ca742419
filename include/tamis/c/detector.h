/* Detector: every contact of a mesh with itself, step after step. */
#ifndef TAMIS_C_DETECTOR_H
#define TAMIS_C_DETECTOR_H
#include "tamis/c/answers.h"
#include "tamis/c/mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct tamis_detector tamis_detector;

/** All zero but `size` are the defaults. */
typedef struct tamis_options {
  size_t size;
  const char* isa;                 /**< "best", "baseline", "avx2", "avx512"; NULL: best. Speed only */
  int32_t threads;                 /**< 0: as many as the caller's oneTBB arena gives. Speed only */
  double min_separation;           /**< d >= 0: contact means Euclidean distance <= d */
  const int32_t* group_of_vertex;  /**< one a vertex of the mesh, in [0, group_count), or -1 if no feature has it; NULL:
                                      all are in group 0, the only one, and groups_may_touch is NULL too */
  int32_t group_count;             /**< 0: one group */
  const uint8_t* groups_may_touch; /**< group_count x group_count, symmetric; 0 leaves out; NULL: all are tested */
  /** Asked for every pair that is left, from several threads; 0 leaves the pair out. NULL: all are tested. */
  int (*accepts)(void* user, int32_t kind, const int32_t* vertices);
  /** Asked again and again during a question, from several threads; other than 0 ends it with TAMIS_CANCELLED. */
  int (*is_cancelled)(void* user);
  void* user;          /**< handed to both */
  const double* radii; /**< a radius >= 0 for each group, group_count of them; NULL: all zero */
  int32_t rings;       /**< pairs are left out that are fewer edges apart along the mesh; 0: 1, a common vertex */
} tamis_options;

/** Copies the mesh. NULL as options: the defaults. TAMIS_INVALID_OPTIONS: see tamis/options.hpp. */
TAMIS_API tamis_status tamis_detector_create(const tamis_mesh* mesh, const tamis_options* options,
                                             tamis_detector** detector);
TAMIS_API void tamis_detector_free(tamis_detector* detector);
/** What the last call with this detector had to say; "" after TAMIS_OK. */
TAMIS_API const char* tamis_detector_message(const tamis_detector* detector);

/** All contacts of the step, by kind, then vertices; tamis_detector_copy_contacts() hands them out. */
TAMIS_API tamis_status tamis_detector_contacts(tamis_detector* detector, const tamis_step* step, size_t* count);
/** The first contact: the motion is free on [0, *toi_lower), proven; at *toi_upper some pair has touched. *count
 * is 0, and both times 1, if the step is free; else 1, for tamis_detector_copy_contacts(). */
TAMIS_API tamis_status tamis_detector_earliest(tamis_detector* detector, const tamis_step* step, double* toi_lower,
                                               double* toi_upper, size_t* count);
/** Writes 1 if the whole step is free of contacts, else 0. */
TAMIS_API tamis_status tamis_detector_is_free(tamis_detector* detector, const tamis_step* step, int* is_free);

/** How far may the step go so that every pair keeps at least `keep`, 0 <= keep < 1, of its distance? C has no
 * defaults: C++ and Python take 0.1, here and of tamis_detector_truncate. Which when: Detector in tamis/detector.hpp.
 */
TAMIS_API tamis_status tamis_detector_safe_step(tamis_detector* detector, const tamis_step* step, double keep,
                                                tamis_safe_step* answer);

/** The numbers in which the caller keeps positions between steps. */
enum { TAMIS_FLOAT64 = 0, TAMIS_FLOAT32 = 1 };

/** Positions to go to, each vertex as far as it may on its own line: three doubles for each vertex of the mesh, on the
 * straight way to which every pair keeps the fraction of its distance, 0 < keep < 1: proven. `fractions`, one a vertex,
 * is how much of its way each goes, in [0, 1]; NULL: not wanted. *is_free is 0 if something touches at the start,
 * and is not ignored for it; of that no pair comes nearer. `stored` is TAMIS_FLOAT64 or TAMIS_FLOAT32: with the latter
 * all positions are floats' values, so that storing them as floats changes nothing, and the step's start must be made
 * of such. See TruncatedStep in tamis/step_length.hpp. */
TAMIS_API tamis_status tamis_detector_truncate(tamis_detector* detector, const tamis_step* step, double keep,
                                               int32_t stored, double* positions, double* fractions, int* is_free);

/** Every pair whose distance at the step's start is at most `distance` plus both radii; the step's end is not read. */
TAMIS_API tamis_status tamis_detector_pairs_within(tamis_detector* detector, const tamis_step* step, double distance,
                                                   size_t* count);
/** Every edge that passes through a triangle or touches it at the step's start: exactly. The end is not read. */
TAMIS_API tamis_status tamis_detector_intersections(tamis_detector* detector, const tamis_step* step, size_t* count);
/** Writes 1 if there is any, else 0. */
TAMIS_API tamis_status tamis_detector_has_intersection(tamis_detector* detector, const tamis_step* step,
                                                       int* has_intersection);
/** As tamis_detector_copy_contacts, of the last question for near pairs or for intersections. */
TAMIS_API tamis_status tamis_detector_copy_pairs_within(tamis_detector* detector, size_t first, size_t count,
                                                        tamis_near_pair* pairs, size_t pair_size);
TAMIS_API tamis_status tamis_detector_copy_intersections(tamis_detector* detector, size_t first, size_t count,
                                                         tamis_intersection* intersections, size_t intersection_size);

/** Copies contacts [first, first + count) of the last question about a step or a path, if that was for contacts or the
 * earliest one, into an array whose elements are `contact_size` = sizeof(tamis_contact) bytes: after any other there
 * are none. */
TAMIS_API tamis_status tamis_detector_copy_contacts(tamis_detector* detector, size_t first, size_t count,
                                                    tamis_contact* contacts, size_t contact_size);

TAMIS_API tamis_status tamis_detector_statistics(tamis_detector* detector, tamis_statistics* statistics);

#ifdef __cplusplus
}
#endif
#endif
