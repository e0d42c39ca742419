/* Linkages: joints that move bodies of a world, and a planner's questions about edges between configurations. */
#ifndef TAMIS_C_LINKAGE_H
#define TAMIS_C_LINKAGE_H
#include "tamis/c/world.h"

#ifdef __cplusplus
extern "C" {
#endif

/** How a joint moves what it carries. */
enum {
  TAMIS_FIXED = 0,   /**< not at all */
  TAMIS_TURNING = 1, /**< about its axis, by its value in radians */
  TAMIS_SLIDING = 2  /**< along its axis, by its value */
};

/** A joint. Its frame in the frame of its parent: first its own motion by its value, then `place`. The value is
 * `factor` times a number of the configuration, plus `offset`. */
typedef struct tamis_joint {
  int32_t parent;     /**< the joint that carries it, before it in the list; -1: the world */
  int32_t joint_kind; /**< TAMIS_FIXED, TAMIS_TURNING or TAMIS_SLIDING */
  int32_t coordinate; /**< which number of a configuration moves it; no matter if it is fixed */
  tamis_pose place;   /**< its frame at the value 0, in the frame of its parent */
  double axis[3];     /**< in its own frame; the direction alone counts. No matter if it is fixed */
  double factor;      /**< of that number; 1 unless the joint mimics another one */
  double offset;      /**< added to the product */
} tamis_joint;

/** A body that a joint carries. */
typedef struct tamis_carried_body {
  int32_t body;     /**< its number in the world */
  int32_t joint;    /**< its place in the list of joints */
  tamis_pose place; /**< its frame in the frame of the joint */
} tamis_carried_body;

/** A tree of joints, or several, and the bodies that they carry: Linkage in tamis/linkage.hpp. */
typedef struct tamis_linkage tamis_linkage;

/** Makes a linkage.
 * Writes the handle, also if the call fails (tamis/tamis.h).
 * Returns TAMIS_INVALID_OPTIONS where the constructor of Linkage throws (tamis/linkage.hpp). */
TAMIS_API tamis_status tamis_linkage_create(const tamis_joint* joints, size_t joint_count,
                                            const tamis_carried_body* carried, size_t carried_count,
                                            tamis_linkage** linkage);
/** Frees the linkage. NULL: does nothing. */
TAMIS_API void tamis_linkage_free(tamis_linkage* linkage);
/** Returns the message of making this linkage; "" after TAMIS_OK. */
TAMIS_API const char* tamis_linkage_message(const tamis_linkage* linkage);
/** Returns how many numbers a configuration has. NULL, or a linkage that could not be made: 0. */
TAMIS_API size_t tamis_linkage_dimension(const tamis_linkage* linkage);

/** How far a linkage may go along an edge. */
typedef struct tamis_edge_answer {
  double fraction;           /**< the edge is free on [0, fraction): proven. 1 if it is free, 0 if its start overlaps */
  double fraction_upper;     /**< a certified contact happens at or before this fraction */
  int32_t overlaps_at_start; /**< 1: two bodies pass through each other at the start, or one is inside another */
  int32_t has_contact;       /**< 1: a contact ends the edge */
  int32_t bodies[2];         /**< which touch or overlap first; -1: the edge is free */
  double point[3];           /**< where the contact is, in the world's frame; 0 if has_contact is 0 */
  tamis_contact contact;     /**< no meaning if has_contact is 0 */
} tamis_edge_answer;

/** Tests which configurations are free: nothing overlaps, and nothing touches. In this and all questions below, a
 * configuration has as many numbers as tamis_linkage_dimension() returns. Only pairs with a body of the linkage count;
 * all other bodies take part with their own motions. Threads share the work. `at_start` of the options must be 0.
 * Writes 1 for each configuration that is proven free, else 0.
 * Returns TAMIS_INVALID_STEP and TAMIS_INVALID_OPTIONS where World::configurations_are_free throws (tamis/world.hpp).
 */
TAMIS_API tamis_status tamis_world_configurations_are_free(tamis_world* world, const tamis_linkage* linkage,
                                                           const double* configurations, size_t count,
                                                           const tamis_path_options* options, uint8_t* are_free);
/** Tests which edges are free: nothing overlaps at their start, and nothing touches along them. `starts_are_free` other
 * than 0: the starts are known not to overlap, and not tested.
 * Writes 1 for each edge that is proven free, else 0.
 * Returns the statuses of tamis_world_configurations_are_free. */
TAMIS_API tamis_status tamis_world_edges_are_free(tamis_world* world, const tamis_linkage* linkage,
                                                  const double* starts, const double* ends, size_t count,
                                                  int starts_are_free, const tamis_path_options* options,
                                                  uint8_t* are_free);
/** Finds how far each edge is free, and the contact that ends it.
 * Writes an answer of `answer_size` = sizeof(tamis_edge_answer) bytes for each edge.
 * Returns the statuses of tamis_world_configurations_are_free. */
TAMIS_API tamis_status tamis_world_last_valid(tamis_world* world, const tamis_linkage* linkage, const double* starts,
                                              const double* ends, size_t count, int starts_are_free,
                                              const tamis_path_options* options, tamis_edge_answer* answers,
                                              size_t answer_size);
/** Finds the first edge of a trajectory of `waypoint_count` waypoints that is not free. Only the first waypoint is
 * tested for an overlap, unless `starts_are_free`; if other bodies move, all that come after it, too. Writes its
 * number, or waypoint_count - 1 if all edges are free; and the answer about it, of `answer_size` bytes. Returns the
 * statuses of tamis_world_configurations_are_free, TAMIS_INVALID_OPTIONS for fewer than two waypoints. */
TAMIS_API tamis_status tamis_world_first_bad_edge(tamis_world* world, const tamis_linkage* linkage,
                                                  const double* waypoints, size_t waypoint_count, int starts_are_free,
                                                  const tamis_path_options* options, size_t* edge,
                                                  tamis_edge_answer* answers, size_t answer_size);
/** Tests a roadmap. `edge_ends`: the numbers of two configurations each. An edge is free if both are, and if nothing
 * touches along it.
 * Writes 1 for each configuration and each edge that is proven free, else 0.
 * Returns the statuses of tamis_world_configurations_are_free, TAMIS_INVALID_OPTIONS also for an edge that names a
 * configuration that is not there. */
TAMIS_API tamis_status tamis_world_roadmap(tamis_world* world, const tamis_linkage* linkage,
                                           const double* configurations, size_t count, const int32_t* edge_ends,
                                           size_t edge_count, const tamis_path_options* options,
                                           uint8_t* configurations_are_free, uint8_t* edges_are_free);

#ifdef __cplusplus
}
#endif
#endif
