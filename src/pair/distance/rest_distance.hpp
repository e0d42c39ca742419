// The distance of two features at rest, between proven bounds, in doubles or in lanes. Closest points bound it from
// above. The axis along their gap bounds it from below. And the direction from one to the other, where doubles tell it.
// Integers tell the rest. Error bounds: kGap, kAxisNow. Cost: about 200 operations.
#pragma once
#include "numbers/assert.hpp"
#include "numbers/unit_vector.hpp"
#include "pair/distance/closest.hpp"
#include "pair/motion/difference_corners.hpp"
#include "pair/motion/pair_motion.hpp"

namespace tamis {

/// In the unit of the vectors.
template <class T>
struct RestDistance {
  ClosestPointsOf<T> closest;
  T low;              ///< a proven lower bound
  T distance;         ///< the length of the closest points' gap
  T tolerance;        ///< what `distance` is off by at most, if is_sharp
  Vec3<T> direction;  ///< along the gap; of any length, zero or NaN where nothing tells it

  /// False where the bounds lie too far apart, or something overflowed.
  Mask<T> is_sharp() const { return (distance - low <= tolerance) & (tolerance < T(1)); }
};

/// The vectors of PairMotion at one time; `size`: D + E + F.
template <PairKind kind, class T>
inline RestDistance<T> rest_distance(const Vec3<T>& e, const Vec3<T>& f, const Vec3<T>& d, const T& size) {
  const ClosestPointsOf<T> closest = closest_points<kind>(e, f, d);
  const Vec3<T> direction = orthogonal_gap<kind>(e, f, closest);
  return {closest, distance_along(difference_corners<kind>(e, f, d), direction, size),
          sqrt(dot(closest.gap, closest.gap)), error_bounds::bound<T>(error_bounds::kRestDistance, size), direction};
}

/// NearPair::direction, zero if not known. `unit`: the unit vector along the closest points' gap; zero or NaN if
/// unknown.
template <PairKind kind, class T>
inline Vec3<T> near_direction(const Vec3<T>& unit) {
  const T zero(0), sign(kind == PairKind::edge_edge ? -1 : 1);  // edges have the gap from the first to the second
  const auto is_known = unit.x == unit.x;  // NOLINT(misc-redundant-expression): NaN where it is not
  const auto component = [&](const T& x) { return select(is_known, sign * x, zero) + zero; };  // none is -0
  return {component(unit.x), component(unit.y), component(unit.z)};
}

/// The direction in which a pair is apart at one time of its step.
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
  // Let g be the length of the gap. If all corners of the difference are at least c g along a unit vector, the gap is
  // at most acos(c) off that vector. This is below 1.01 sqrt(2 (1 - c)). The error of g is kGap, which is small beside
  // the error of `low`.
  constexpr double kSharp = 1 - 0x1p-20;
  const RestDistance<T> rest =
      rest_distance<kind>(at_time(m.e, time), at_time(m.f, time), at_time(m.d, time), m.size_d + m.size_e + m.size_f);
  const auto& [u, v, gap] = rest.closest;
  const Mask<T> is_sure = (rest.low > T(0)) & (rest.low >= constant<T>(kSharp) * rest.distance);
  return {u, v, near_direction<kind>(unit_vector(rest.direction)), is_sure};
}

}  // namespace tamis
