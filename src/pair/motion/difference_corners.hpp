// The corners of the Minkowski difference of a pair's two features, which is their convex hull. Its distance from zero
// is the distance of the features. Its fastest corner bounds the relative speed of any two points of the features.
#pragma once
#include <array>

#include "numbers/error_bounds.hpp"
#include "numbers/select.hpp"
#include "pair/motion/pair_motion.hpp"

namespace tamis {

/// `V`: vectors at one time, moving ones, or their projections on an axis. Named as in PairMotion.
template <PairKind kind, class V>
inline auto difference_corners([[maybe_unused]] const V& e, [[maybe_unused]] const V& f, const V& d) {
  if constexpr (kind == PairKind::vertex_face)
    return std::array{d, d - e, d - f};
  else if constexpr (kind == PairKind::edge_edge)
    return std::array{d, d - e, d + f, d + f - e};
  else if constexpr (kind == PairKind::vertex_edge)
    return std::array{d, d - e};
  else if constexpr (kind == PairKind::vertex_vertex)
    return std::array{d};
}

template <PairKind kind, class T>
inline auto difference_corners(const PairMotion<T>& m) {
  return difference_corners<kind>(m.e, m.f, m.d);
}

/// The velocity of the fastest corner. The relative velocity of any two points is a convex combination of the corners'
/// velocities.
template <PairKind kind, class T>
inline T squared_speed(const PairMotion<T>& m) {
  T square(0);
  for (const auto& corner : difference_corners<kind>(m)) {
    const Vec3<T> velocity = corner.at1 - corner.at0;
    square = max(square, dot(velocity, velocity));
  }
  return square;
}

/// The smallest and the largest projection of a corner on one axis.
template <class T>
struct Range {
  T low, high;
};

/// `e`, `f`, `d`: the projections of the vectors at one time.
template <PairKind kind, class T>
inline Range<T> range_of_differences(const T& e, const T& f, const T& d) {
  const auto corners = difference_corners<kind>(e, f, d);
  T low = corners[0], high = low;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    low = min(low, corners[i]);
    high = max(high, corners[i]);
  }
  return {low, high};
}

/// A lower bound, beyond all rounding, of the distance from zero to the hull of `corners`, by projection on
/// `direction`, of any length; 0 if that proves none. `size`: D + E + F.
template <class Corners, class T>
inline T distance_along(const Corners& corners, const Vec3<T>& direction, const T& size) {
  constexpr double kRoundoff = error_bounds::unit_roundoff<T>;
  const Vec3<T> n = (T(1) / largest_component(direction)) * direction;
  T lowest = dot(n, corners[0]);
  for (std::size_t i = 1; i < corners.size(); ++i) lowest = min(lowest, dot(n, corners[i]));
  const T error = constant<T>(kRoundoff) * size + constant<T>(error_bounds::underflow<T>);
  const T distance =
      (lowest - constant<T>(error_bounds::kAxisNow) * error) / (sqrt(dot(n, n)) * constant<T>(1 + 8 * kRoundoff));
  return select(distance > T(0), distance, T(0));
}

}  // namespace tamis
