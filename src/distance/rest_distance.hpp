// The distance of two features at rest, between proven bounds, in doubles or in lanes: closest points bound it from
// above, and from below the axis along which they lie. Error bounds: kGap, kAxisNow. Cost: about 200 operations.
#pragma once
#include "distance/closest.hpp"
#include "distance/difference_corners.hpp"
#include "distance/distance_along.hpp"
#include "motion/pair_motion.hpp"
#include "numerics/unit_vector.hpp"

namespace tamis {

/// A pair at rest: the vectors of PairMotion at one time, with their sizes and the separation.
template <class T>
struct PairPose {
  Vec3<T> e, f, d;
  T size_e, size_f, size_d;
  T separation;
};

/// In the unit of the pose.
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

template <PairKind kind, class T>
inline RestDistance<T> rest_distance(const PairPose<T>& p) {
  const ClosestPointsOf<T> closest = closest_points<kind>(p.e, p.f, p.d);
  const Vec3<T> direction = squared_gap<kind>(p.e, p.f, closest);
  const T size = p.size_d + p.size_e + p.size_f;
  return {closest, distance_along(difference_corners<kind>(p.e, p.f, p.d), direction, size),
          sqrt(dot(closest.gap, closest.gap)), error_bounds::bound<T>(error_bounds::kRestDistance, size), direction};
}

}  // namespace tamis
