/* Curved motion. */
#ifndef TAMIS_C_PATH_H
#define TAMIS_C_PATH_H
#include "tamis/c/answers.h"
#include "tamis/c/detector.h"

#ifdef __cplusplus
extern "C" {
#endif

/** How all vertices move for t in [0,1], on curves. Copies what it is made of, but for tamis_path_functions. May be
 * asked by several detectors at a time. */
typedef struct tamis_path tamis_path;

/** x goes to R x + position, R being the rotation by |rotation| radians about the direction of `rotation`. */
typedef struct tamis_pose {
  double position[3];
  double rotation[3];
} tamis_pose;

/** A pose whose position and rotation vector go linearly from `start` (t=0) to `end` (t=1). Any angle. */
typedef struct tamis_link {
  tamis_pose start;
  tamis_pose end;
} tamis_link;

/** Writes the two links of a body that from `start` turns at constant speed about the fixed axis of `turn` by |turn|
 * radians, while one point of it, `center` in its frame, goes straight to `end_position`: engines take the center of
 * mass. NULL as center: the origin of its frame. These calls have no handle to keep a sentence in. */
TAMIS_API tamis_status tamis_turned(const tamis_pose* start, const double* turn, const double* end_position,
                                    const double* center, tamis_link* links);
/** The same from one pose to the other, by the shorter turn (slerp). */
TAMIS_API tamis_status tamis_between(const tamis_pose* start, const tamis_pose* end, const double* center,
                                     tamis_link* links);
/** Writes where a chain takes its body at a time in [0,1], as after a step of which that part is safe. */
TAMIS_API tamis_status tamis_pose_at(const tamis_link* links, size_t count, double time, tamis_pose* pose);
/** For engines that blend quaternions and normalize them (nlerp): writes how far a point is at most from where
 * tamis_between has it, as a part of its distance from the center. Ask with as much separation. */
TAMIS_API tamis_status tamis_nlerp_deviation(const tamis_pose* start, const tamis_pose* end, double* part);
/** From a quaternion w x y z, or the rows of a matrix, also of float32: what rounding has made of a rotation becomes
 * the nearest one. TAMIS_INVALID_PATH: more than that, 1e-4 of |q|^2 - 1 or of an entry of R R^T - I; a reflection. */
TAMIS_API tamis_status tamis_pose_of_quaternion(const double* quaternion, const double* position, tamis_pose* pose);
TAMIS_API tamis_status tamis_pose_of_matrix(const double* rows, const double* position, tamis_pose* pose);

/** Bodies that move each on a chain of links. */
typedef struct tamis_rigid_path_input {
  size_t size;
  int32_t vertex_count;
  const double* rest;            /**< vertex_count x 3: each vertex in its body's own frame */
  const int32_t* body_of_vertex; /**< one each, in [0, body_count) */
  size_t body_count;
  /** How many links each body has; 0: at rest where it is given. A point of the body goes through the last one first.
   */
  const size_t* links_of_body;
  const tamis_link* links; /**< of all bodies, one after the other */
  const double* rest_end;  /**< vertex_count x 3: where each goes straight in that frame by t=1; NULL: all stay */
} tamis_rigid_path_input;

/** Frames of points: the control points of Bezier curves, or what a Catmull-Rom spline goes through. */
typedef struct tamis_spline_path_input {
  size_t size;
  int32_t vertex_count;
  size_t frame_count;
  const double* frames; /**< frame_count x vertex_count x 3 */
} tamis_spline_path_input;

/** Any motion. Both functions are asked from several threads, for `count` vertices by their numbers. */
typedef struct tamis_path_functions {
  size_t size;
  int32_t vertex_count;
  /** Writes where each is at `time`, count x 3, and for each a bound >= 0 of how far a coordinate may be off. */
  void (*points_at)(void* user, double time, const int32_t* vertices, size_t count, double* points, double* errors);
  /** Writes for each a bound >= 0 of how far it deviates, at any time of [from, to], from its chord walked at constant
   * speed; for smooth curves |x''| (to - from)^2 / 8. See Path in tamis/path.hpp. */
  void (*deviations)(void* user, double from, double to, const int32_t* vertices, size_t count, double* deviations);
  void* user; /**< handed to both */
} tamis_path_functions;

/** TAMIS_INVALID_PATH: sizes that do not fit, numbers that are not finite. */
TAMIS_API tamis_status tamis_rigid_path_create(const tamis_rigid_path_input* input, tamis_path** path);
/** Each vertex on a Bezier curve of degree frame_count - 1. */
TAMIS_API tamis_status tamis_bezier_path_create(const tamis_spline_path_input* input, tamis_path** path);
/** Through at least two frames at equal distances of time, smoothly. */
TAMIS_API tamis_status tamis_catmull_rom_path_create(const tamis_spline_path_input* input, tamis_path** path);
TAMIS_API tamis_status tamis_function_path_create(const tamis_path_functions* functions, tamis_path** path);
TAMIS_API void tamis_path_free(tamis_path* path);
/** What the last call with this path had to say; "" after TAMIS_OK. A detector that is asked about it keeps its own. */
TAMIS_API const char* tamis_path_message(const tamis_path* path);
/** Where the vertices are at a time in [0,1], rounded: vertex_count x 3. */
TAMIS_API tamis_status tamis_path_points_at(tamis_path* path, double time, double* points);

/** All zero but `size` are the defaults. */
typedef struct tamis_path_options {
  size_t size;
  double tolerance;             /**< widest bracket of a contact, in (0, 1], a fraction of the step; 0: 1e-9 */
  const double* min_separation; /**< of this question; NULL: the detector's, or 0 for pairs */
  /** Of lists of pairs, of which each may take seconds: asked again and again; other than 0 ends the call with
   * TAMIS_CANCELLED. A detector asks its own. */
  int (*is_cancelled)(void* user);
  void* user; /**< handed to it */
} tamis_path_options;

/** As without a path; NULL as options: the defaults. TAMIS_INVALID_PATH: one that does not fit the mesh, or breaks its
 * promises. A contact that cannot be decided, such as a touch without crossing, is unresolved. */
TAMIS_API tamis_status tamis_detector_contacts_on_path(tamis_detector* detector, const tamis_path* path,
                                                       const tamis_path_options* options, size_t* count);
TAMIS_API tamis_status tamis_detector_earliest_on_path(tamis_detector* detector, const tamis_path* path,
                                                       const tamis_path_options* options, double* toi_lower,
                                                       double* toi_upper, size_t* count);
TAMIS_API tamis_status tamis_detector_is_free_on_path(tamis_detector* detector, const tamis_path* path,
                                                      const tamis_path_options* options, int* is_free);

/** A list of pairs on a path: `count` rows of 4, 4, 3 or 2 vertices, by their numbers in the path. */
TAMIS_API tamis_status tamis_path_vertex_face(tamis_path* path, const tamis_path_options* options, size_t count,
                                              const int32_t* vertices, tamis_pair_result* results, size_t result_size);
TAMIS_API tamis_status tamis_path_edge_edge(tamis_path* path, const tamis_path_options* options, size_t count,
                                            const int32_t* vertices, tamis_pair_result* results, size_t result_size);
TAMIS_API tamis_status tamis_path_vertex_edge(tamis_path* path, const tamis_path_options* options, size_t count,
                                              const int32_t* vertices, tamis_pair_result* results, size_t result_size);
TAMIS_API tamis_status tamis_path_vertex_vertex(tamis_path* path, const tamis_path_options* options, size_t count,
                                                const int32_t* vertices, tamis_pair_result* results,
                                                size_t result_size);

#ifdef __cplusplus
}
#endif
#endif
