// In which direction does one feature of a pair lie from the other, at one time? Along the gap of their closest points,
// in doubles or in lanes, where these can tell; narrow/contact_normal.cpp asks integers for the rest.
// Error bounds: kGap, kAxisNow. Cost: that of a distance at rest.
#pragma once
#include "distance/near_facts.hpp"
#include "distance/rest_distance.hpp"
#include "numerics/assert.hpp"

namespace tamis {

template <class T>
struct DirectionApart {
  T u, v;             ///< weights of the closest points, as in Contact
  Vec3<T> direction;  ///< from the second feature's closest point to the first's; unit where `is_sure`
  Mask<T> is_sure;    ///< proven: the features are apart, and the direction is no more than 2^-9 off
};

/// REQUIRES: `m` is the motion of the whole step, `time` in [0,1].
template <PairKind kind, class T>
inline DirectionApart<T> direction_apart(const PairMotion<T>& m, const T& time) {
  TAMIS_ASSERT(is_whole(m) && !any(!((time >= T(0)) & (time <= T(1)))));
  // Where the corners of the difference are at least c g along a unit vector, g the length of the gap, the gap is no
  // more than acos(c) off it: below sqrt(2 (1 - c)), and g is off by kGap, which is small beside what `low` lost.
  constexpr double kSharp = 1 - 0x1p-20;
  const RestDistance<T> rest =
      rest_distance<kind>(at_time(m.e, time), at_time(m.f, time), at_time(m.d, time), m.size_d + m.size_e + m.size_f);
  const auto& [u, v, gap] = rest.closest;
  const Mask<T> is_sure = (rest.low > T(0)) & (rest.low >= error_bounds::constant<T>(kSharp) * rest.distance);
  return {u, v, near_facts<kind>(u, v, unit_vector(rest.direction)).direction, is_sure};
}

}  // namespace tamis
