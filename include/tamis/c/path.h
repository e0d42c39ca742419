/* Curved motion: where every vertex is at each time of a step, and questions about it. */
#ifndef TAMIS_C_PATH_H
#define TAMIS_C_PATH_H
#include "tamis/c/answers.h"
#include "tamis/c/detector.h"

#ifdef __cplusplus
extern "C" {
#endif

/** How all vertices move for t in [0,1], on continuous curves. Copies all arrays that it is made with. The functions
 * and `user` of tamis_path_functions must live as long as the path. Several detectors may use it at a time. */
typedef struct tamis_path tamis_path;

/** x goes to R x + position, R being the rotation by |rotation| radians about the direction of `rotation`. */
typedef struct tamis_pose {
  double position[3]; /**< where the body's origin is */
  double rotation[3]; /**< rotation vector */
} tamis_pose;

/** A pose whose position and rotation vector go linearly from `start` (t=0) to `end` (t=1). Any angle. */
typedef struct tamis_rigid_link {
  tamis_pose start; /**< at t=0 */
  tamis_pose end;   /**< at t=1 */
} tamis_rigid_link;

/** Makes the chain of a body that turns from `start` at constant speed about the fixed axis of `turn`, by |turn|
 * radians. Meanwhile one point of it, `center` in its frame, goes straight to `end_position`. Engines take the center
 * of mass. `center` NULL: the origin of the body's frame.
 * Writes the two links of the chain.
 * Returns TAMIS_INVALID_PATH on numbers that are not finite. This call and the next five have no handle that keeps a
 * message. */
TAMIS_API tamis_status tamis_turned_chain(const tamis_pose* start, const double* turn, const double* end_position,
                                          const double* center, tamis_rigid_link* links);
/** Makes the chain from one pose to the other by the shorter turn about a fixed axis, at constant speed (slerp);
 * otherwise the same. */
TAMIS_API tamis_status tamis_chain_between(const tamis_pose* start, const tamis_pose* end, const double* center,
                                           tamis_rigid_link* links);
/** Computes the pose of a chain's body at a time in [0,1], for example after a step that is safe until then.
 * Writes the pose.
 * Returns TAMIS_INVALID_PATH on numbers that are not finite, and on a time outside [0,1]. */
TAMIS_API tamis_status tamis_pose_at(const tamis_rigid_link* links, size_t count, double time, tamis_pose* pose);
/** Bounds the deviation of engines that blend quaternions and normalize them (nlerp). They go the way of
 * tamis_chain_between at another speed. A motion that is free by tamis_chain_between, with this deviation as
 * additional separation, is free by nlerp.
 * Writes a factor. No point is ever farther from its place by tamis_chain_between than *part times its distance from
 * the center.
 * Returns TAMIS_INVALID_PATH on numbers that are not finite. */
TAMIS_API tamis_status tamis_nlerp_deviation(const tamis_pose* start, const tamis_pose* end, double* part);
/** Converts a quaternion (w x y z), as engines keep it, also in floats. It is a rotation with rounding errors: the
 * nearest rotation is taken.
 * Writes the pose.
 * Returns TAMIS_INVALID_PATH if the quaternion is off by more than rounding: |q|^2 - 1 beyond 1e-4. Returns it also on
 * numbers that are not finite. */
TAMIS_API tamis_status tamis_pose_of_quaternion(const double* quaternion, const double* position, tamis_pose* pose);
/** Converts a rotation matrix, given by its rows (9 doubles); otherwise the same.
 * Writes the pose.
 * Returns TAMIS_INVALID_PATH if the matrix is off by more than rounding: an entry of R R^T - I beyond 1e-4; a
 * reflection. Returns it also on numbers that are not finite. */
TAMIS_API tamis_status tamis_pose_of_matrix(const double* rows, const double* position, tamis_pose* pose);

/** Bodies that each move on a chain of links. */
typedef struct tamis_rigid_path_input {
  size_t size;                   /**< sizeof(tamis_rigid_path_input) */
  int32_t vertex_count;          /**< number of vertices */
  const double* rest;            /**< vertex_count x 3: each vertex in its body's own frame */
  const int32_t* body_of_vertex; /**< the body of each vertex, in [0, body_count) */
  size_t body_count;             /**< number of bodies */
  /** How many links each body has; 0: the body stays where its points are given. A point of the body goes through the
   * last link first. */
  const size_t* links_of_body;
  const tamis_rigid_link* links; /**< the links of all bodies, one body after the other */
  const double* rest_end; /**< vertex_count x 3: where each vertex, which goes straight in that frame, is at t=1; NULL:
                             all stay */
} tamis_rigid_path_input;

/** Frames of points: the control points of Bezier curves, or the frames through which a Catmull-Rom spline goes. */
typedef struct tamis_spline_path_input {
  size_t size;          /**< sizeof(tamis_spline_path_input) */
  int32_t vertex_count; /**< number of vertices */
  size_t frame_count;   /**< number of frames */
  const double* frames; /**< frame_count x vertex_count x 3 */
} tamis_spline_path_input;

/** Any motion. Both functions are called from several threads, for `count` vertices by their numbers. */
typedef struct tamis_path_functions {
  size_t size;          /**< sizeof(tamis_path_functions) */
  int32_t vertex_count; /**< number of vertices */
  /** Writes where each vertex is at `time`, count x 3, and for each a bound >= 0: no coordinate is off by more than
   * this. */
  void (*points_at)(void* user, double time, const int32_t* vertices, size_t count, double* points, double* errors);
  /** Writes for each vertex a bound, >= 0, of its deviation: its Euclidean distance, at any time t of [from, to], from
   * ((to - t) x(from) + (t - from) x(to)) / (to - from), which goes along the chord at constant speed. The bound must
   * go to zero as the piece gets shorter, for smooth curves with the square of its length: |x''| (to - from)^2 / 8. */
  void (*deviations)(void* user, double from, double to, const int32_t* vertices, size_t count, double* deviations);
  void* user; /**< passed to both */
} tamis_path_functions;

/** Makes a path of bodies that each move on a chain of links.
 * Writes the handle, also if the call fails (tamis/tamis.h).
 * Returns TAMIS_INVALID_PATH on sizes that do not fit and on numbers that are not finite. */
TAMIS_API tamis_status tamis_rigid_path_create(const tamis_rigid_path_input* input, tamis_path** path);
/** Makes a path whose vertices move on Bezier curves of degree frame_count - 1; otherwise the same. */
TAMIS_API tamis_status tamis_bezier_path_create(const tamis_spline_path_input* input, tamis_path** path);
/** Makes a path whose vertices move through at least two frames at equal distances of time, smoothly; otherwise the
 * same. */
TAMIS_API tamis_status tamis_catmull_rom_path_create(const tamis_spline_path_input* input, tamis_path** path);
/** Makes a path that calls the caller's functions; otherwise the same. */
TAMIS_API tamis_status tamis_function_path_create(const tamis_path_functions* functions, tamis_path** path);
/** Frees the path. NULL: does nothing. */
TAMIS_API void tamis_path_free(tamis_path* path);
/** Returns the message of the last call with this path; "" after TAMIS_OK. A detector that uses the path keeps its own
 * message. */
TAMIS_API const char* tamis_path_message(const tamis_path* path);
/** Computes where the vertices are at a time in [0,1], rounded to doubles.
 * Writes vertex_count x 3 doubles.
 * Returns TAMIS_INVALID_ARGUMENT on a time outside [0,1]. */
TAMIS_API tamis_status tamis_path_points_at(tamis_path* path, double time, double* points);

/** Options of one question about a path, or about a world, whose bodies may turn. A field that is zero has its default.
 */
typedef struct tamis_path_options {
  size_t size;                  /**< sizeof(tamis_path_options) */
  double tolerance;             /**< the widest bracket of a contact, a fraction of the step in (0, 1]; 0: 1e-9 */
  const double* min_separation; /**< for this question alone; NULL: the detector's, the world's, or 0 for pairs */
  /** Only for lists of pairs, where one pair may take seconds. Called again and again. Once it returns other than 0,
   * the call ends with TAMIS_CANCELLED. Detectors and worlds have this in their own options. */
  int (*is_cancelled)(void* user);
  void* user;       /**< passed to is_cancelled */
  int32_t at_start; /**< of a detector's or world's questions: TAMIS_REPORT, TAMIS_IGNORE or TAMIS_FAIL */
} tamis_path_options;

/** Finds all contacts of a motion on curves, as tamis_detector_contacts. `options` NULL: the defaults. A contact that
 * cannot be decided, such as a touch without crossing, is unresolved.
 * Writes their number. tamis_detector_copy_contacts() copies them.
 * Returns TAMIS_INVALID_PATH if the path does not fit the mesh or breaks its promises. Returns TAMIS_INVALID_STEP and
 * TAMIS_INVALID_OPTIONS where Detector::contacts throws (tamis/detector.hpp). */
TAMIS_API tamis_status tamis_detector_contacts_on_path(tamis_detector* detector, const tamis_path* path,
                                                       const tamis_path_options* options, size_t* count);
/** Finds the first contact on the path.
 * Writes a bracket of its time, as tamis_detector_earliest.
 * Returns the statuses of tamis_detector_contacts_on_path. */
TAMIS_API tamis_status tamis_detector_earliest_on_path(tamis_detector* detector, const tamis_path* path,
                                                       const tamis_path_options* options, double* toi_lower,
                                                       double* toi_upper, size_t* count);
/** Tests whether the whole path is free of contacts.
 * Writes 1 if it is, else 0.
 * Returns the statuses of tamis_detector_contacts_on_path. */
TAMIS_API tamis_status tamis_detector_is_free_on_path(tamis_detector* detector, const tamis_path* path,
                                                      const tamis_path_options* options, int* is_free);

/** Decides a list of pairs on a path. `vertices` has `count` rows of their numbers in the path: four for a vertex and a
 * face.
 * Writes `count` results of `result_size` = sizeof(tamis_pair_result) bytes.
 * Returns TAMIS_INVALID_PATH and TAMIS_INVALID_OPTIONS where vertex_face throws (tamis/path.hpp). */
TAMIS_API tamis_status tamis_path_vertex_face(tamis_path* path, const tamis_path_options* options, size_t count,
                                              const int32_t* vertices, tamis_pair_result* results, size_t result_size);
/** Decides pairs of two edges, each of four vertices; otherwise the same. */
TAMIS_API tamis_status tamis_path_edge_edge(tamis_path* path, const tamis_path_options* options, size_t count,
                                            const int32_t* vertices, tamis_pair_result* results, size_t result_size);
/** Decides pairs of a vertex and an edge, each of three vertices; otherwise the same. */
TAMIS_API tamis_status tamis_path_vertex_edge(tamis_path* path, const tamis_path_options* options, size_t count,
                                              const int32_t* vertices, tamis_pair_result* results, size_t result_size);
/** Decides pairs of two vertices; otherwise the same. */
TAMIS_API tamis_status tamis_path_vertex_vertex(tamis_path* path, const tamis_path_options* options, size_t count,
                                                const int32_t* vertices, tamis_pair_result* results,
                                                size_t result_size);

#ifdef __cplusplus
}
#endif
#endif
