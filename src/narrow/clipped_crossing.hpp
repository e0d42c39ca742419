// What doubles decide of nearly every pair that crosses: one crossing in what the slab clip on the coordinates leaves;
// and where that is not enough, in what the clip on all its axes leaves, one on each side of where the cubic turns. The
// same lines serve one pair and pairs in lanes, so that a pair has the same bits however it is asked.
#pragma once
#include "filters/slab_clip.hpp"
#include "narrow/crossing.hpp"
#include "narrow/sharp_bracket.hpp"

namespace tamis {

/// The clip of a face that is orthogonal to an axis ends at the very time of contact, where no sign is certain.
template <class T>
inline TimeInterval<T> widened(const TimeInterval<T>& time) {
  const T margin(1.0 / 1024);
  return {max(time.t_in - margin, T(0)), min(time.t_out + margin, T(1))};
}

/// Restricts a crossing that was found in widened(clip) to `clip`. It decides the pair if it is free or touches then; a
/// contact whose bracket is not sharp does not count as decided.
template <class T>
inline Crossing<T> clipped_crossing(Crossing<T> c, const TimeInterval<T>& clip) {
  c.lower = max(c.lower, clip.t_in);
  c.upper = min(c.upper, clip.t_out);
  c.touches = c.touches & is_sharp(c.lower, c.upper);
  for (T* weight : {&c.u, &c.v}) *weight = min(max(*weight, T(0)), T(1));
  return c;
}

}  // namespace tamis
