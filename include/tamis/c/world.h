/* World: bodies, each with its own shape and motion. */
#ifndef TAMIS_C_WORLD_H
#define TAMIS_C_WORLD_H
#include "tamis/c/answers.h"
#include "tamis/c/mesh.h"
#include "tamis/c/path.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A mesh with its points at rest, in the body's own frame, and the hierarchy over them: made once, then shared by any
 * number of bodies, which keep what they need of it. */
typedef struct tamis_shape tamis_shape;

/** All zero but `size` are the defaults. */
typedef struct tamis_shape_options {
  size_t size;
  const char* isa; /**< of what makes the hierarchy, as in tamis_options; NULL: best */
} tamis_shape_options;

/** `points`: three coordinates for each vertex of the mesh. Copies both. NULL as options: the defaults.
 * TAMIS_INVALID_MESH: a point of a feature that is not finite. TAMIS_INVALID_OPTIONS: an instruction set that is none,
 * or that this machine lacks. */
TAMIS_API tamis_status tamis_shape_create(const tamis_mesh* mesh, const double* points,
                                          const tamis_shape_options* options, tamis_shape** shape);
TAMIS_API void tamis_shape_free(tamis_shape* shape);
/** What making this shape had to say; "" after TAMIS_OK. */
TAMIS_API const char* tamis_shape_message(const tamis_shape* shape);

/** Bodies, and the questions of a detector about them: each moves during t in [0,1] as it was told last. What is proven
 * of which motion: World in tamis/world.hpp. */
typedef struct tamis_world tamis_world;

/** All zero but `size` are the defaults; each as in tamis_options. */
typedef struct tamis_world_options {
  size_t size;
  const char* isa; /**< NULL: best */
  int32_t threads;
  int32_t rings; /**< of a deforming body, which may touch itself */
  double min_separation;
  int (*is_cancelled)(void* user);
  void* user; /**< handed to it */
} tamis_world_options;

/** A world without bodies. NULL as options: the defaults. */
TAMIS_API tamis_status tamis_world_create(const tamis_world_options* options, tamis_world** world);
TAMIS_API void tamis_world_free(tamis_world* world);
/** What the last call with this world had to say; "" after TAMIS_OK. */
TAMIS_API const char* tamis_world_message(const tamis_world* world);

/** How some bodies move. Give poses, or links, or start and end, and NULL for the others; all NULL: each stays where
 * its shape is given. Arrays hold one body after the other. */
typedef struct tamis_motions {
  size_t size;
  size_t count;            /**< bodies */
  const tamis_pose* poses; /**< each stays at its own. NULL: see above */
  const tamis_link* links; /**< each goes by a chain of so many links, outermost first. NULL: see above */
  size_t links_of_each;    /**< with poses, or start and end: 0 */
  const double* start;     /**< each deforms: three coordinates a vertex, at t=0. NULL: see above */
  const double* end;       /**< the same at t=1. NULL: see above */
  int32_t vertex_count;    /**< of each, with start and end; as many as its shape has */
} tamis_motions;

/** Adds `motions->count` bodies of one shape and writes their numbers: 0, 1, 2, ..., never given twice. If one cannot
 * be added, none is. TAMIS_INVALID_STEP: numbers that are not finite, other than one point a vertex, a body that turns
 * by more than 4096 radians, a rotation vector longer than 2^32. */
TAMIS_API tamis_status tamis_world_add(tamis_world* world, const tamis_shape* shape, const tamis_motions* motions,
                                       int32_t* bodies);
/** Says how `motions->count` bodies move from now on, each named once; if one cannot, none does. All calls that name a
 * body that is not there change nothing and give TAMIS_INVALID_OPTIONS. */
TAMIS_API tamis_status tamis_world_move(tamis_world* world, const int32_t* bodies, const tamis_motions* motions);
/** Where the vertices of a body are at a time in [0, 1] of its motion, on the curves that questions are about: at a
 * contact's time, say. `points`: three coordinates each; `vertex_count`: as many as its shape has. No coordinate of a
 * vertex of a feature is off by more than `error`, which may be NULL; where it is 0 these are the very points. */
TAMIS_API tamis_status tamis_world_points_at(tamis_world* world, int32_t body, double time, int32_t vertex_count,
                                             double* points, double* error);
/** Takes `count` bodies out, each named once; their numbers are not given again. */
TAMIS_API tamis_status tamis_world_remove(tamis_world* world, const int32_t* bodies, size_t count);
/** 0 switches `count` bodies off, so that they take no part in any question until they are switched on by 1. */
TAMIS_API tamis_status tamis_world_set_enabled(tamis_world* world, const int32_t* bodies, size_t count, int is_enabled);
/** Gives `count` bodies a radius >= 0, half of their thickness: contact means a distance of at most the minimum
 * separation plus both radii. At first 0. */
TAMIS_API tamis_status tamis_world_set_radius(tamis_world* world, const int32_t* bodies, size_t count, double radius);
/** `bodies`: `count` pairs. 0: leave them out of every answer; a deforming body with itself is twice the same. At first
 * all may touch but two that both stay. TAMIS_INVALID_OPTIONS: 1 for two that both stay, or for one with itself that
 * does not deform; what was said of the pairs before them holds. */
TAMIS_API tamis_status tamis_world_set_may_touch(tamis_world* world, const int32_t* bodies, size_t count,
                                                 int may_touch);

/** Of one question. All zero but `size` are the defaults. */
typedef struct tamis_query_options {
  size_t size;
  const double* min_separation; /**< NULL: the world's */
  int32_t at_start;             /**< TAMIS_REPORT, TAMIS_IGNORE or TAMIS_FAIL */
  double tolerance; /**< where one of two bodies turns: widest bracket of a contact, in (0, 1], a fraction of the step;
                         0: 1e-9 */
} tamis_query_options;

/** All contacts, by kind, then bodies and vertices; tamis_world_copy_contacts() hands them out. NULL as options: the
 * defaults; so of all questions. */
TAMIS_API tamis_status tamis_world_contacts(tamis_world* world, const tamis_query_options* options, size_t* count);
/** As tamis_detector_earliest. */
TAMIS_API tamis_status tamis_world_earliest(tamis_world* world, const tamis_query_options* options, double* toi_lower,
                                            double* toi_upper, size_t* count);
/** Of one of many motions. */
typedef struct tamis_earliest {
  double toi_lower, toi_upper; /**< as of tamis_detector_earliest */
  int32_t has_contact;         /**< 0: the motion is free, both times are 1 */
  tamis_contact contact;       /**< the first one */
} tamis_earliest;

/** As of a planner, from configuration to configuration: the first contact for each of many motions of `body_count`
 * bodies, each named once, while all others move as they were told. `motions->count` is `body_count` for each motion:
 * one for each body, in their order, then again for the next. Writes an answer of `answer_size` =
 * sizeof(tamis_earliest) bytes for each motion. Threads share the motions; each answer has the bits that it has alone.
 * The bodies themselves go on moving as they were told. */
TAMIS_API tamis_status tamis_world_earliest_many(tamis_world* world, const int32_t* bodies, size_t body_count,
                                                 const tamis_motions* motions, const tamis_query_options* options,
                                                 tamis_earliest* answers, size_t answer_size);
/** Writes 1 if the motion of all bodies is free of contacts, else 0. */
TAMIS_API tamis_status tamis_world_is_free(tamis_world* world, const tamis_query_options* options, int* is_free);
/** As tamis_detector_safe_step; where one of two bodies turns, the tolerance counts. */
TAMIS_API tamis_status tamis_world_safe_step(tamis_world* world, double keep, const tamis_query_options* options,
                                             tamis_safe_step* answer);
/** Every pair of features within `distance` plus both radii at t=0, in the same order. Two static bodies are left out
 * here and of the next two questions, even where they pass through each other: before the first step tell
 * them a link whose pose is the same at both ends, ask, and tell them their poses again. */
TAMIS_API tamis_status tamis_world_pairs_within(tamis_world* world, double distance, size_t* count);
/** Every edge that passes through a triangle or touches it at t=0, by bodies, edge and face; not of two static
 * bodies. */
TAMIS_API tamis_status tamis_world_intersections(tamis_world* world, size_t* count);
/** Writes 1 if there is any, not of two static bodies, else 0. */
TAMIS_API tamis_status tamis_world_has_intersection(tamis_world* world, int* has_intersection);

/** As those of a detector; vertices are those of the bodies' own meshes. */
TAMIS_API tamis_status tamis_world_copy_contacts(tamis_world* world, size_t first, size_t count,
                                                 tamis_contact* contacts, size_t contact_size);
TAMIS_API tamis_status tamis_world_copy_pairs_within(tamis_world* world, size_t first, size_t count,
                                                     tamis_near_pair* pairs, size_t pair_size);
TAMIS_API tamis_status tamis_world_copy_intersections(tamis_world* world, size_t first, size_t count,
                                                      tamis_intersection* intersections, size_t intersection_size);
/** Sums over the detectors that the last question asked; memory without shapes. */
TAMIS_API tamis_status tamis_world_statistics(tamis_world* world, tamis_statistics* statistics);

#ifdef __cplusplus
}
#endif
#endif
