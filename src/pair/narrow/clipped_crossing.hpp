// Doubles decide nearly every pair that crosses by one crossing, in the times that the slab clip on the coordinate axes
// leaves. If that fails, by a crossing on each side of the cubic's turning point, in the times that the clip on all
// axes leaves. A single pair and pairs in lanes run the same code. So a pair has the same bits in both.
#pragma once
#include "pair/filters/slab_clip.hpp"
#include "pair/narrow/crossing.hpp"
#include "pair/narrow/sharp_bracket.hpp"

namespace tamis {

/// Adds a margin. Where a face is orthogonal to an axis its clip ends at the contact itself, where no sign is certain.
template <class T>
inline TimeInterval<T> widened(const TimeInterval<T>& time) {
  const T margin(1.0 / 1024);
  return {max(time.t_in - margin, T(0)), min(time.t_out + margin, T(1))};
}

/// Restricts a crossing that was found in widened(clip) to `clip`. The result decides the pair if it is free or
/// touches. A contact whose bracket is not sharp is not decided, so `touches` is false there.
template <class T>
inline Crossing<T> clipped_crossing(Crossing<T> c, const TimeInterval<T>& clip) {
  c.lower = max(c.lower, clip.t_in);
  c.upper = min(c.upper, clip.t_out);
  c.touches = c.touches & is_sharp(c.lower, c.upper);
  for (T* weight : {&c.u, &c.v}) *weight = min(max(*weight, T(0)), T(1));
  return c;
}

}  // namespace tamis
