// The distance of two features at rest, between proven bounds, in doubles or in lanes: closest points bound it from
// above, and from below the axis along which they lie. Error bounds: kGap, kAxisNow. Cost: about 200 operations.
#pragma once
#include "distance/closest.hpp"
#include "motion/difference_corners.hpp"
#include "motion/pair_motion.hpp"
#include "numerics/unit_vector.hpp"

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
  auto is_sharp() const { return distance - low <= tolerance; }
};

/// The vectors of PairMotion at one time; `size`: D + E + F.
template <PairKind kind, class T>
inline RestDistance<T> rest_distance(const Vec3<T>& e, const Vec3<T>& f, const Vec3<T>& d, const T& size) {
  const ClosestPointsOf<T> closest = closest_points<kind>(e, f, d);
  const Vec3<T> direction = squared_gap<kind>(e, f, closest);
  return {closest, distance_along(difference_corners<kind>(e, f, d), direction, size),
          sqrt(dot(closest.gap, closest.gap)), error_bounds::bound<T>(error_bounds::kRestDistance, size), direction};
}

}  // namespace tamis
