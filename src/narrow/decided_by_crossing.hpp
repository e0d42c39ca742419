// What doubles decide of nearly every pair that crosses: one crossing in what the slab clip on the coordinates leaves;
// and where that is not enough, in what the clip on all its axes leaves, one on each side of where the cubic turns. The
// same lines serve one pair and pairs in lanes, so that a pair has the same bits however it is asked.
#pragma once
#include "filters/slab_clip.hpp"
#include "narrow/crossing.hpp"
#include "narrow/sharp_bracket.hpp"

namespace tamis {

/// A face that meets the axes squarely is clipped to the very instant of contact, where no sign is certain any more.
template <class T>
inline TimeInterval<T> widened(const TimeInterval<T>& time) {
  const T room(1.0 / 1024);
  return {max(time.t_in - room, T(0)), min(time.t_out + room, T(1))};
}

/// Both false: not decided.
template <class T>
struct DecidedByCrossing {
  Mask<T> is_free, touches;
  T lower, upper;
  T u, v;
  Vec3<T> normal;  ///< unit
};

/// What a crossing found in widened(clip) decides. A contact whose bracket is not sharp is not decided.
template <class T>
inline DecidedByCrossing<T> decided_by_crossing(const Crossing<T>& c, const TimeInterval<T>& clip) {
  const T lower = max(c.lower, clip.t_in), upper = min(c.upper, clip.t_out), zero(0), one(1);
  const Mask<T> touches = c.touches & is_sharp(lower, upper);
  const auto within_one = [&](const T& weight) { return min(max(weight, zero), one); };
  return {c.is_free, touches, lower, upper, within_one(c.u), within_one(c.v), c.normal};
}

}  // namespace tamis
