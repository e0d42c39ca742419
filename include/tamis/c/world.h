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
 * number of bodies. Bodies keep what they need of it, so it may be freed before them. */
typedef struct tamis_shape tamis_shape;

/** Options of a shape. A field that is zero has its default. */
typedef struct tamis_shape_options {
  size_t size;     /**< sizeof(tamis_shape_options) */
  const char* isa; /**< the instruction set that builds the hierarchy, as in tamis_options; NULL: "best" */
} tamis_shape_options;

/** Makes a shape. `points`: three coordinates for each vertex of the mesh. Copies mesh and points. `options` NULL: the
 * defaults.
 * Writes the handle, also if the call fails (tamis/tamis.h).
 * Returns TAMIS_INVALID_MESH if a point of a feature is not finite. Returns TAMIS_INVALID_OPTIONS if there is no such
 * instruction set, or if this machine lacks it. */
TAMIS_API tamis_status tamis_shape_create(const tamis_mesh* mesh, const double* points,
                                          const tamis_shape_options* options, tamis_shape** shape);
/** Frees the shape. NULL: does nothing. */
TAMIS_API void tamis_shape_free(tamis_shape* shape);
/** Returns the message of making this shape; "" after TAMIS_OK. */
TAMIS_API const char* tamis_shape_message(const tamis_shape* shape);

/** Bodies, and the questions of a detector about them. During t in [0,1] each body moves as it was told last. How
 * answers are proven: World in tamis/world.hpp. */
typedef struct tamis_world tamis_world;

/** Options of a world, as in tamis_options. A field that is zero has its default. */
typedef struct tamis_world_options {
  size_t size;                     /**< sizeof(tamis_world_options) */
  const char* isa;                 /**< NULL: "best" */
  int32_t threads;                 /**< as in tamis_options */
  int32_t rings;                   /**< for deforming bodies, which may touch themselves */
  double min_separation;           /**< as in tamis_options */
  int (*is_cancelled)(void* user); /**< as in tamis_options */
  void* user;                      /**< passed to is_cancelled and parallel_for */
  void (*parallel_for)(void* user, int32_t count, tamis_loop_body body, void* loop); /**< as in tamis_options */
} tamis_world_options;

/** Makes a world without bodies. `options` NULL: the defaults.
 * Writes the handle, also if the call fails (tamis/tamis.h).
 * Returns TAMIS_INVALID_OPTIONS where the constructor of World throws (tamis/world.hpp). */
TAMIS_API tamis_status tamis_world_create(const tamis_world_options* options, tamis_world** world);
/** Frees the world. NULL: does nothing. */
TAMIS_API void tamis_world_free(tamis_world* world);
/** Returns the message of the last call with this world; "" after TAMIS_OK. */
TAMIS_API const char* tamis_world_message(const tamis_world* world);

/** How some bodies move. Give either poses, or links, or start and end, and NULL for the others. If all are NULL, each
 * body stays where its shape's points are. Arrays hold one body after the other. */
typedef struct tamis_motions {
  size_t size;                   /**< sizeof(tamis_motions) */
  size_t count;                  /**< number of bodies */
  const tamis_pose* poses;       /**< one for each body, which stays there; or NULL */
  const tamis_rigid_link* links; /**< each body moves by a chain of links, outermost first; or NULL */
  size_t links_of_each;          /**< number of links of each body's chain; 0 with poses, or start and end */
  const double* start; /**< each body deforms: three coordinates a vertex, at t=0, in the frame of the world; or NULL */
  const double* end;   /**< the same at t=1; or NULL */
  int32_t vertex_count; /**< with start and end: the vertices of each body, as many as its shape has */
} tamis_motions;

/** Adds `motions->count` bodies of one shape. If one cannot be added, none is.
 * Writes their numbers: 0, 1, 2, ..., never given twice.
 * Returns TAMIS_INVALID_STEP if numbers are not finite, if `vertex_count` is not the shape's, if the links of a body
 * together turn by more than 4096 radians, or if a rotation vector is longer than 2^32. */
TAMIS_API tamis_status tamis_world_add(tamis_world* world, const tamis_shape* shape, const tamis_motions* motions,
                                       int32_t* bodies);
/** Tells `motions->count` bodies, each named once, their motion from now on. If one cannot move so, none does.
 * Returns TAMIS_INVALID_STEP as tamis_world_add. All calls that name a body that does not exist change nothing and
 * return TAMIS_INVALID_OPTIONS. */
TAMIS_API tamis_status tamis_world_move(tamis_world* world, const int32_t* bodies, const tamis_motions* motions);
/** Computes where a body's vertices are at a time in [0, 1] of its motion, on the curves that questions are about. Call
 * it for a contact's time, to draw the body or to compute a response. `vertex_count`: as many as the body's shape has.
 * Writes three coordinates a vertex to `points`. No coordinate of a vertex of a feature is off by more than *error; if
 * that is 0 these are the very points. `error` NULL: not wanted.
 * Returns TAMIS_INVALID_OPTIONS on a time outside [0, 1]. Returns TAMIS_INVALID_ARGUMENT if `vertex_count` is another
 * number. */
TAMIS_API tamis_status tamis_world_points_at(tamis_world* world, int32_t body, double time, int32_t vertex_count,
                                             double* points, double* error);
/** Removes `count` bodies, each named once. Their numbers are not given again.
 * Returns TAMIS_INVALID_OPTIONS if a body does not exist or is named twice. */
TAMIS_API tamis_status tamis_world_remove(tamis_world* world, const int32_t* bodies, size_t count);
/** Switches `count` bodies off (0) or on (1). Bodies that are off take no part in any question. Bodies begin switched
 * on.
 * Returns TAMIS_INVALID_OPTIONS if a body does not exist. */
TAMIS_API tamis_status tamis_world_set_enabled(tamis_world* world, const int32_t* bodies, size_t count, int is_enabled);
/** Gives `count` bodies a radius >= 0, half of their thickness; 0 at first. Two bodies are in contact where their
 * distance is at most the minimum separation plus both radii.
 * Returns TAMIS_INVALID_OPTIONS if the radius is out of its range, or if a body does not exist. */
TAMIS_API tamis_status tamis_world_set_radius(tamis_world* world, const int32_t* bodies, size_t count, double radius);
/** Sets whether bodies may touch. `bodies`: `count` pairs of bodies; a deforming body with itself is named twice.
 * `may_touch` 0 leaves the pairs out of every answer. At first all may touch, except a body with itself that does not
 * deform.
 * Returns TAMIS_INVALID_OPTIONS on 1 for a body with itself that does not deform; nothing is set then. */
TAMIS_API tamis_status tamis_world_set_may_touch(tamis_world* world, const int32_t* bodies, size_t count,
                                                 int may_touch);

/** Finds all contacts. `options` NULL: the defaults, for this and all other questions.
 * Writes their number. tamis_world_copy_contacts() copies them, sorted by kind, then bodies and vertices.
 * Returns TAMIS_INVALID_STEP and TAMIS_INVALID_OPTIONS where World::contacts throws (tamis/world.hpp). */
TAMIS_API tamis_status tamis_world_contacts(tamis_world* world, const tamis_path_options* options, size_t* count);
/** Finds the first contact of each pair of bodies that touches, and of each deforming body with itself. Of all contacts
 * of the pair this is the one with the least toi_lower. Of several such it is the first by kind, then bodies and
 * vertices.
 * Writes their number. tamis_world_copy_contacts() copies them, sorted by the smaller body, then the greater one.
 * Returns the statuses of tamis_world_contacts. */
TAMIS_API tamis_status tamis_world_first_contacts(tamis_world* world, const tamis_path_options* options, size_t* count);
/** Finds the first contact.
 * Writes a bracket of its time, as tamis_detector_earliest; tamis_world_copy_contacts() copies the contact.
 * Returns the statuses of tamis_world_contacts. */
TAMIS_API tamis_status tamis_world_earliest(tamis_world* world, const tamis_path_options* options, double* toi_lower,
                                            double* toi_upper, size_t* count);
/** The first contact of one of many motions. */
typedef struct tamis_earliest {
  double toi_lower;      /**< as tamis_detector_earliest writes it */
  double toi_upper;      /**< as tamis_detector_earliest writes it */
  int32_t has_contact;   /**< 0: the motion is free, and both times are 1 */
  tamis_contact contact; /**< the first contact; no meaning if has_contact is 0 */
} tamis_earliest;

/** Finds the first contact of each of many motions of `body_count` bodies, each named once, while all others move as
 * they were told. Planners need this: they move from configuration to configuration. `motions->count` is `body_count`
 * times the number of motions: for the first motion one entry for each of `bodies`, in their order, then for the
 * second, and so on. Threads share the motions. Afterwards the bodies have the motions of before.
 * Writes an answer of `answer_size` = sizeof(tamis_earliest) bytes for each motion, with the bits that it has alone.
 * Returns TAMIS_INVALID_STEP and TAMIS_INVALID_OPTIONS where World::earliest_many throws (tamis/world.hpp). */
TAMIS_API tamis_status tamis_world_earliest_many(tamis_world* world, const int32_t* bodies, size_t body_count,
                                                 const tamis_motions* motions, const tamis_path_options* options,
                                                 tamis_earliest* answers, size_t answer_size);
/** Tests whether the motion of all bodies is free of contacts.
 * Writes 1 if it is, else 0.
 * Returns the statuses of tamis_world_contacts. */
TAMIS_API tamis_status tamis_world_is_free(tamis_world* world, const tamis_path_options* options, int* is_free);
/** Finds how far all bodies may go, as tamis_detector_safe_step. If one of two bodies turns, the tolerance counts, and
 * a pair that starts nearer to its separation than doubles can tell ends the step at once.
 * Writes a bracket of the time, and the pair that ends the step.
 * Returns TAMIS_INVALID_OPTIONS unless 0 <= keep < 1, otherwise the statuses of tamis_world_contacts. */
TAMIS_API tamis_status tamis_world_safe_step(tamis_world* world, double keep, const tamis_path_options* options,
                                             tamis_safe_step* answer);
/** Finds pairs of features within `distance` plus both radii where all bodies are at t=0, rounded to doubles.
 * `include_static` 0: this question and the next two skip two bodies that stay at a pose, even where they pass through
 * each other. Other than 0: includes these, too, as needed before the first step.
 * Writes their number. tamis_world_copy_pairs_within() copies them, sorted as contacts.
 * Returns TAMIS_INVALID_OPTIONS unless `distance` is finite and >= 0. */
TAMIS_API tamis_status tamis_world_pairs_within(tamis_world* world, double distance, int include_static, size_t* count);
/** Finds every edge that passes through a triangle or touches it at t=0.
 * Writes their number. tamis_world_copy_intersections() copies them, sorted by bodies, edge and face. */
TAMIS_API tamis_status tamis_world_intersections(tamis_world* world, int include_static, size_t* count);
/** Tests whether there is any intersection. Ends at the first one.
 * Writes 1 if there is one, else 0. */
TAMIS_API tamis_status tamis_world_has_intersection(tamis_world* world, int include_static, int* has_intersection);

/** Copies contacts, as tamis_detector_copy_contacts. Vertices are numbered in the bodies' own meshes. */
TAMIS_API tamis_status tamis_world_copy_contacts(tamis_world* world, size_t first, size_t count,
                                                 tamis_contact* contacts, size_t contact_size);
/** Copies near pairs; otherwise the same. */
TAMIS_API tamis_status tamis_world_copy_pairs_within(tamis_world* world, size_t first, size_t count,
                                                     tamis_near_pair* pairs, size_t pair_size);
/** Copies intersections; otherwise the same. */
TAMIS_API tamis_status tamis_world_copy_intersections(tamis_world* world, size_t first, size_t count,
                                                      tamis_intersection* intersections, size_t intersection_size);
/** Writes the cost of the last question: sums over the detectors that it used. memory_bytes does not count shapes. */
TAMIS_API tamis_status tamis_world_statistics(tamis_world* world, tamis_statistics* statistics);

#ifdef __cplusplus
}
#endif
#endif
