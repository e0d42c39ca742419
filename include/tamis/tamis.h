/* Tamis for C, and for every language that can call C: contacts between moving, deforming triangle meshes.
 *
 * Handles are opaque. Whatever makes or asks something returns a status; its sentence stands in the handle until the
 * next call with it. A call that makes a handle writes one even if it fails, to read the sentence from, unless memory
 * ran out (then NULL): free it in either case. Freeing NULL does nothing. Nothing is thrown across this interface.
 *
 * Structs begin with their size: set it to sizeof, the rest to zero, then what you need. So they may grow, and an older
 * program still runs with a newer library: what a caller does not know of is left as it is by default, and what the
 * library does not know of must be zero.
 *
 * Pointers that are given are read during the call alone. One handle serves one thread at a time; calls at once with
 * a detector that is asking give TAMIS_BUSY. Different handles are independent. */
#ifndef TAMIS_TAMIS_H
#define TAMIS_TAMIS_H
#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define TAMIS_API __attribute__((visibility("default")))
#else
#define TAMIS_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef enum tamis_status {
  TAMIS_OK = 0,
  TAMIS_INVALID_ARGUMENT = 1, /**< a pointer that is NULL, a size or a place that cannot be */
  TAMIS_INVALID_MESH = 2,     /**< a topology that cannot be used */
  TAMIS_INVALID_STEP = 3,     /**< positions that do not fit the mesh, or are not finite */
  TAMIS_INVALID_OPTIONS = 4,  /**< an option outside its range, or an unknown name */
  TAMIS_CANCELLED = 5,        /**< tamis_options.is_cancelled said so; the detector may be asked again */
  TAMIS_BUSY = 6,             /**< the detector is answering another thread, or the filter's own caller */
  TAMIS_OUT_OF_MEMORY = 7,
  TAMIS_FAILED = 8,      /**< anything else */
  TAMIS_INVALID_PATH = 9 /**< a path that does not fit, or breaks its promises */
} tamis_status;

/** As the project's version, "0.1.0". Never freed, as all strings that are returned. */
TAMIS_API const char* tamis_version(void);

/* ---- Mesh: the topology, made once ---- */

typedef struct tamis_mesh tamis_mesh;

typedef struct tamis_mesh_input {
  size_t size;
  int32_t vertex_count;        /**< rows of the positions of every step, >= 0 */
  const int32_t* faces;        /**< face_count x 3 vertex indices, any winding */
  size_t face_count;           /**< may be 0 */
  const int32_t* loose_edges;  /**< loose_edge_count x 2: rods */
  size_t loose_edge_count;     /**< may be 0 */
  const int32_t* loose_points; /**< vertices of no face and no edge that still take part in contacts */
  size_t loose_point_count;    /**< may be 0 */
} tamis_mesh_input;

/** TAMIS_INVALID_MESH: an index outside [0, vertex_count), or no feature at all. */
TAMIS_API tamis_status tamis_mesh_create(const tamis_mesh_input* input, tamis_mesh** mesh);
TAMIS_API void tamis_mesh_free(tamis_mesh* mesh);
/** What the last call with this mesh had to say; "" after TAMIS_OK. */
TAMIS_API const char* tamis_mesh_message(const tamis_mesh* mesh);
/** Every edge of a triangle and every loose one, once: count x 2, vertices ascending, sorted. Lives as the mesh does;
 * NULL and 0 of a mesh that could not be made. */
TAMIS_API const int32_t* tamis_mesh_edges(const tamis_mesh* mesh, size_t* count);
/** The vertices that take part in contacts, ascending. Otherwise the same. */
TAMIS_API const int32_t* tamis_mesh_points(const tamis_mesh* mesh, size_t* count);
/** The two features of a contact, or of a near pair, by their places: of a face among those that the mesh was made of,
 * of an edge in tamis_mesh_edges(), of a vertex its number; -1 where the mesh has none. For who keeps data by feature.
 * TAMIS_INVALID_ARGUMENT: no such kind. */
TAMIS_API tamis_status tamis_mesh_features_of(tamis_mesh* mesh, int32_t kind, const int32_t* vertices, int32_t* first,
                                              int32_t* second);

/* ---- What all questions share ---- */

/** Kinds of pairs and their vertices. Vertex-face: the vertex, then the face's vertices in the mesh's order.
 * Edge-edge: each edge ascending, the smaller edge first. Vertex-edge: the vertex, then the edge's, ascending.
 * Vertex-vertex: ascending. Vertices that a kind does not use are -1. */
enum { TAMIS_VERTEX_FACE = 0, TAMIS_EDGE_EDGE = 1, TAMIS_VERTEX_EDGE = 2, TAMIS_VERTEX_VERTEX = 3 };
/** Certified: proven to touch at some time of the bracket. Unresolved: floating point could not decide; kept, because
 * a contact must never be missed. */
enum { TAMIS_CERTIFIED = 0, TAMIS_UNRESOLVED = 1 };

/** Each vertex moves on a straight line from its row of `start` (t=0) to that of `end` (t=1). */
typedef struct tamis_step {
  size_t size;
  int32_t vertex_count;         /**< rows of both */
  const double* start;          /**< three coordinates a row */
  const double* end;            /**< the same at t=1 */
  ptrdiff_t start_stride;       /**< doubles from one row to the next, >= 3; 0: 3 */
  ptrdiff_t end_stride;         /**< the same of end */
  const double* min_separation; /**< of this question alone; NULL: the detector's */
} tamis_step;

/** One pair of features that touches during the step. */
typedef struct tamis_contact {
  int32_t kind;
  int32_t certainty;
  int32_t vertices[4];
  double toi_lower; /**< fraction of the step: the pair is apart on [0, toi_lower) */
  double toi_upper; /**< if certified, it touches at some time of [toi_lower, toi_upper] */
  double u, v;      /**< vf: point = (1-u-v) f0 + u f1 + v f2; ee: u on the first edge, v on the second; ve: u */
  double normal[3]; /**< of unit length */
} tamis_contact;

/* ---- Detector: every contact of a mesh with itself, step after step ---- */

typedef struct tamis_detector tamis_detector;

/** All zero but `size` are the defaults. */
typedef struct tamis_options {
  size_t size;
  const char* method;    /**< as the command's --method: "tamis", "paper", "brute", "paper-sat", ...; NULL: tamis */
  const char* guarantee; /**< "conservative" or "exact"; NULL: the library's default */
  const char* isa;       /**< "best", "baseline", "avx2", "avx512"; NULL: best. Speed only */
  const char* bounding_volume;     /**< of method paper: "16-dop", "aabb", ...; NULL: 16-dop */
  int32_t threads;                 /**< 0: as many as the caller's oneTBB arena gives. Speed only */
  double min_separation;           /**< d >= 0: contact means Euclidean distance <= d */
  const int32_t* group_of_vertex;  /**< one a vertex of the mesh, in [0, group_count); NULL: all are in group 0 */
  int32_t group_count;             /**< 0: one group */
  const uint8_t* groups_may_touch; /**< group_count x group_count, symmetric; 0 leaves out; NULL: all are tested */
  /** Asked for every pair that is left, from several threads; 0 leaves the pair out. NULL: all are tested. */
  int (*accepts)(void* user, int32_t kind, const int32_t* vertices);
  /** Asked again and again during a question, from several threads; other than 0 ends it with TAMIS_CANCELLED. */
  int (*is_cancelled)(void* user);
  void* user;              /**< handed to both */
  const double* thickness; /**< a radius >= 0 for each group, group_count of them; NULL: all zero */
} tamis_options;

/** Copies the mesh. NULL as options: the defaults. TAMIS_INVALID_OPTIONS: see tamis/options.hpp. */
TAMIS_API tamis_status tamis_detector_create(const tamis_mesh* mesh, const tamis_options* options,
                                             tamis_detector** detector);
TAMIS_API void tamis_detector_free(tamis_detector* detector);
/** What the last call with this detector had to say; "" after TAMIS_OK. */
TAMIS_API const char* tamis_detector_message(const tamis_detector* detector);

/** All contacts of the step, by kind, then vertices; tamis_detector_copy_contacts() hands them out. */
TAMIS_API tamis_status tamis_detector_contacts(tamis_detector* detector, const tamis_step* step, size_t* count);
/** The first contact: the motion is free on [0, *toi_lower), proven; *toi_upper is 1 if none is certified. *count is 0,
 * and both times 1, if the step is free; else 1, for tamis_detector_copy_contacts(). */
TAMIS_API tamis_status tamis_detector_earliest(tamis_detector* detector, const tamis_step* step, double* toi_lower,
                                               double* toi_upper, size_t* count);
/** Writes 1 if the whole step is free of contacts, else 0. */
TAMIS_API tamis_status tamis_detector_is_free(tamis_detector* detector, const tamis_step* step, int* is_free);

typedef struct tamis_safe_step {
  size_t size;
  double lower;        /**< on [0, lower] every pair keeps the fraction, on [0, lower) none touches: proven */
  double upper;        /**< at this time some pair has no more than it left: proven; 1 if not known of any time */
  int32_t has_pair;    /**< 0: the whole step may go */
  int32_t kind;        /**< of the pair that ends the step, as in tamis_contact */
  int32_t vertices[4]; /**< the same */
  double distance;     /**< of the pair at t=0, rounded */
} tamis_safe_step;

/** How far may the step go so that every pair keeps at least `fraction`, 0 <= fraction < 1, of its distance? */
TAMIS_API tamis_status tamis_detector_keep_distance(tamis_detector* detector, const tamis_step* step, double fraction,
                                                    tamis_safe_step* answer);

/** A step for each vertex, so that one near pair does not stop all: all go together until the time `*together`, which
 * is keep_distance's, from there each up to its own time of `until`, one a vertex of the mesh, at a pace of its own: no
 * pair comes into contact. 0 < fraction < 1. See VertexSteps in tamis/contact.hpp. */
TAMIS_API tamis_status tamis_detector_vertex_steps(tamis_detector* detector, const tamis_step* step, double fraction,
                                                   double* together, double* until);
/** The positions to go to, by vertex steps: three doubles for each vertex of the mesh, whose straight path from the
 * start is proven free. *is_free is 0 if not even that is so, because something touches at the start; then they are
 * there. */
TAMIS_API tamis_status tamis_detector_truncate(tamis_detector* detector, const tamis_step* step, double fraction,
                                               double* positions, int* is_free);

/** A pair of features that are near each other at rest; see NearPair in tamis/near.hpp. */
typedef struct tamis_near_pair {
  int32_t kind;
  int32_t corners;     /**< bit i: vertex i has a share in the closest points */
  int32_t vertices[4]; /**< as in tamis_contact */
  double distance;
  double u, v;         /**< weights of two closest points */
  double direction[3]; /**< from the second feature's closest point to the first's */
} tamis_near_pair;

/** An edge that passes through a triangle, or touches it; see Intersection in tamis/near.hpp. */
typedef struct tamis_intersection {
  int32_t edge[2], face[3];
  double s_lower, s_upper; /**< the first common point lies between these on the edge */
  double u, v;             /**< and is (1-u-v) f0 + u f1 + v f2 */
} tamis_intersection;

/** Every pair whose distance at the step's start is at most `distance` plus both radii; the step's end is not read. */
TAMIS_API tamis_status tamis_detector_near(tamis_detector* detector, const tamis_step* step, double distance,
                                           size_t* count);
/** Every edge that passes through a triangle or touches it at the step's start: exactly. The end is not read. */
TAMIS_API tamis_status tamis_detector_intersections(tamis_detector* detector, const tamis_step* step, size_t* count);
/** Writes 1 if there is any, else 0. */
TAMIS_API tamis_status tamis_detector_has_intersection(tamis_detector* detector, const tamis_step* step,
                                                       int* has_intersection);
/** As tamis_detector_copy_contacts, of the last question for near pairs or for intersections. */
TAMIS_API tamis_status tamis_detector_copy_near(tamis_detector* detector, size_t first, size_t count,
                                                tamis_near_pair* pairs, size_t pair_size);
TAMIS_API tamis_status tamis_detector_copy_intersections(tamis_detector* detector, size_t first, size_t count,
                                                         tamis_intersection* intersections, size_t intersection_size);

/** Copies contacts [first, first + count) of the last question for contacts or the earliest one, of a step or a path,
 * into an array whose elements are `contact_size` = sizeof(tamis_contact) bytes. */
TAMIS_API tamis_status tamis_detector_copy_contacts(tamis_detector* detector, size_t first, size_t count,
                                                    tamis_contact* contacts, size_t contact_size);

typedef struct tamis_stage {
  const char* name;
  uint64_t vf, ee, ve, vv; /**< pairs of each kind that entered */
} tamis_stage;

enum { TAMIS_MOST_STAGES = 16 };

/** What the last question cost; times in seconds. */
typedef struct tamis_statistics {
  size_t size;
  const char* isa;
  int32_t threads;
  int32_t rebuilt; /**< 1: the hierarchy was built, not refitted */
  double seconds_total, seconds_bounds, seconds_build, seconds_traverse, seconds_filter, seconds_solve;
  uint64_t decided_by_lanes, decided_by_scalar, decided_by_exact, unresolved;
  uint64_t nodes_visited, memory_bytes;
  int32_t stage_count;
  tamis_stage stages[TAMIS_MOST_STAGES]; /**< in the pipeline's order; names live until the next call for statistics */
} tamis_statistics;

TAMIS_API tamis_status tamis_detector_statistics(tamis_detector* detector, tamis_statistics* statistics);

/* ---- Single pairs, and lists of them: for callers who have a broad phase of their own ---- */

typedef struct tamis_pairs tamis_pairs;

typedef struct tamis_pair_options {
  size_t size;
  const char* guarantee; /**< as in tamis_options */
  double min_separation; /**< the same */
  int32_t threads;       /**< the same */
  const char* isa;       /**< the same */
  /** The latest time of interest, in [0,1]: a pair that is proven apart until then is free. Of others it changes
   * nothing. NULL: 1. */
  const double* latest;
} tamis_pair_options;

/** Of a contact; what follows `touches` has no meaning if that is 0. */
typedef struct tamis_pair_result {
  int32_t touches; /**< 0: proven free */
  int32_t certainty;
  double toi_lower, toi_upper;
  double u, v;
  double normal[3];
} tamis_pair_result;

/** NULL as options: the defaults. */
TAMIS_API tamis_status tamis_pairs_create(const tamis_pair_options* options, tamis_pairs** pairs);
TAMIS_API void tamis_pairs_free(tamis_pairs* pairs);
/** What the last call with these pairs had to say; "" after TAMIS_OK. */
TAMIS_API const char* tamis_pairs_message(const tamis_pairs* pairs);
/** `count` vertices against `count` faces: a pair is 12 doubles, p a b c, at t=0 and again at t=1. Writes `count`
 * results of `result_size` = sizeof(tamis_pair_result) bytes. Nothing of use is written if it fails. */
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
typedef struct tamis_pair {
  int32_t kind;        /**< TAMIS_VERTEX_FACE, ... */
  int32_t vertices[4]; /**< rows of the step: p a b c, a0 a1 b0 b1, p a b, or p q; the rest is not read */
} tamis_pair;

/** What each pair of a list does during the step; the positions may have any number of rows. Otherwise the same; the
 * step's min_separation, where it is not NULL, takes the place of the handle's. */
TAMIS_API tamis_status tamis_narrow_phase(tamis_pairs* pairs, const tamis_pair* list, size_t count,
                                          const tamis_step* step, tamis_pair_result* results, size_t result_size);

/** How far apart each pair of a list is at the step's start; the end is not read. Writes `count` answers of
 * `answer_size` = sizeof(tamis_near_pair) bytes, as a detector's near pairs have them; no separation comes off. */
TAMIS_API tamis_status tamis_distances_of(tamis_pairs* pairs, const tamis_pair* list, size_t count,
                                          const tamis_step* step, tamis_near_pair* answers, size_t answer_size);
/** As tamis_detector_keep_distance, for one pair. It looks no further than the latest time of interest, which `lower`
 * then is. */
TAMIS_API tamis_status tamis_pair_keep_distance(tamis_pairs* pairs, const tamis_pair* pair, const tamis_step* step,
                                                double fraction, tamis_safe_step* answer);

/* ---- Curved motion ---- */

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
 * radians, while its origin goes straight to `end_position`. */
TAMIS_API tamis_status tamis_turned(const tamis_pose* start, const double* turn, const double* end_position,
                                    tamis_link* links);
/** The same from one pose to the other, by the shorter turn. */
TAMIS_API tamis_status tamis_between(const tamis_pose* start, const tamis_pose* end, tamis_link* links);

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
  /** Writes for each a bound >= 0 of how far it strays, at any time of [from, to], from its chord walked at constant
   * speed; for smooth curves |x''| (to - from)^2 / 8. See Path in tamis/path.hpp. */
  void (*strays)(void* user, double from, double to, const int32_t* vertices, size_t count, double* strays);
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
