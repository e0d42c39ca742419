/* adapters/clamp.hpp for other languages: on top of the C interface, and in one library with it. */
#ifndef TAMIS_ADAPTERS_CLAMP_H
#define TAMIS_ADAPTERS_CLAMP_H
#include "tamis/tamis.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A step that an engine wants to make: tamis::adapters::WantedStep. `user` is handed to each function. */
typedef struct tamis_wanted_step {
  size_t size;
  void* user;
  const int32_t* moving; /**< bodies that may be held back, each once; all others stay as tamis_world_move says */
  size_t moving_count;
  /** Writes where a body is after this part of its way, as the engine keeps it. */
  void (*pose)(void* user, int32_t body, double fraction, tamis_pose* pose);
  double (*radius)(void* user, int32_t body);
  int (*collides)(void* user, int32_t first, int32_t second); /**< the smaller number first */
  double gap;
  int32_t rounds;
  /** Of two that it collides: at these vertices of their shapes, too? For bodies of several parts. NULL: everywhere. */
  int (*collides_at)(void* user, int32_t first, int32_t first_vertex, int32_t second, int32_t second_vertex);
} tamis_wanted_step;

typedef struct tamis_clamped {
  int32_t questions;  /**< 1 where nobody is held back */
  size_t overlapping; /**< pairs of bodies that overlap at the start, which are not held back because of each other */
} tamis_clamped;

/** tamis::adapters::clamp, for the pairs that overlap where the bodies are at t=0. Writes which part of its way each of
 * `moving` may go; tamis_world_copy_contacts then hands out `contact_count` contacts that held bodies back.
 * TAMIS_INVALID_ARGUMENT: a function that is NULL; TAMIS_INVALID_OPTIONS: `gap` or `rounds` out of range, a body that
 * is not there. */
TAMIS_API tamis_status tamis_world_clamp(tamis_world* world, const tamis_wanted_step* step, double* fractions,
                                         size_t* contact_count, tamis_clamped* clamped);

#ifdef __cplusplus
}
#endif
#endif
