/* integrations/clamp.hpp for other languages: an addition to the C interface, in one library with it. */
#ifndef TAMIS_ADAPTERS_CLAMP_H
#define TAMIS_ADAPTERS_CLAMP_H
#include "tamis/tamis.h"

#ifdef __cplusplus
extern "C" {
#endif

/** As tamis::adapters::Inertia: how a body answers impulses. All zero: it does not. */
typedef struct tamis_inertia {
  double inverse_mass[3];    /**< along each axis of the world */
  double inverse_inertia[9]; /**< in the world's axes, row by row */
} tamis_inertia;

/** In the unit of the positions, and radians, a second. */
typedef struct tamis_velocity {
  double linear[3];  /**< of the origin of the body's poses */
  double angular[3]; /**< about it */
} tamis_velocity;

/** A step that an engine wants to make; members as in tamis::adapters::WantedStep and ClampOptions. `user` is passed to
 * each function; all functions but collides_at are needed. */
typedef struct tamis_wanted_step {
  size_t size;
  void* user;
  const int32_t* moving; /**< bodies that may be held back, each once; all others stay as tamis_world_move says */
  size_t moving_count;
  /** Writes the pose of a body after `fraction` of its way, in [0, 1], rounded as the engine will keep it. */
  void (*pose)(void* user, int32_t body, double fraction, tamis_pose* pose);
  double (*radius)(void* user, int32_t body);
  int (*collides)(void* user, int32_t first, int32_t second); /**< the smaller number first */
  double gap;
  int32_t rounds;
  /** Does the engine collide two bodies, for which `collides` is true, at these vertices of their shapes? For bodies of
   * several parts. NULL: it does everywhere. */
  int (*collides_at)(void* user, int32_t first, int32_t first_vertex, int32_t second, int32_t second_vertex);
  double seconds;
  double carried_at;
  const tamis_shape* (*shape)(void* user, int32_t body);
  void (*inertia)(void* user, int32_t body, tamis_inertia* inertia);
  double (*friction)(void* user, int32_t first, int32_t second); /**< the smaller number first */
  void (*velocity)(void* user, int32_t body, tamis_velocity* velocity);
  void (*way)(void* user, int32_t body, tamis_velocity* way);
  void (*set_way)(void* user, int32_t body, const tamis_velocity* way);
} tamis_wanted_step;

/** What a body does: the fraction of its way that it may go, and the velocity with which it begins the next step. */
typedef struct tamis_body_end {
  double fraction;         /**< the part of its way that it may go, in [0, 1] */
  tamis_velocity velocity; /**< with which it begins the next step */
} tamis_body_end;

typedef struct tamis_clamped {
  int32_t questions;  /**< 1 if no body is held back */
  size_t overlapping; /**< pairs of bodies that overlap at the start; they are not held back because of each other */
} tamis_clamped;

/** Shortens the ways of the bodies, as tamis::adapters::clamp. The excepted pairs are those that overlap at t=0.
 * Writes for each body of `moving` its end. Writes the number of contacts that held bodies back, which
 * tamis_world_copy_contacts copies.
 * Returns TAMIS_INVALID_ARGUMENT if a function or a shape is NULL. Returns TAMIS_INVALID_OPTIONS if `gap`, `rounds` or
 * `seconds` is out of range, or if a body does not exist. */
TAMIS_API tamis_status tamis_world_clamp(tamis_world* world, const tamis_wanted_step* step, tamis_body_end* ends,
                                         size_t* contact_count, tamis_clamped* clamped);

#ifdef __cplusplus
}
#endif
#endif
