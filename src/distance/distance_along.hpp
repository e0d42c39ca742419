// How far apart are two features at least, along one direction?
#pragma once
#include "numerics/error_bounds.hpp"
#include "numerics/select.hpp"
#include "numerics/vec.hpp"

namespace tamis {

/// A lower bound, beyond all rounding, of the distance of zero from the hull of `corners` (difference_corners) by a
/// direction of any length; 0 if it proves none. `size`: D + E + F.
template <class Corners, class T>
inline T distance_along(const Corners& corners, const Vec3<T>& direction, const T& size) {
  constexpr double kRoundoff = error_bounds::unit_roundoff<T>;
  const T largest = max(max(abs(direction.x), abs(direction.y)), abs(direction.z));
  const Vec3<T> n = (T(1) / largest) * direction;
  T lowest = dot(n, corners[0]);
  for (std::size_t i = 1; i < corners.size(); ++i) lowest = min(lowest, dot(n, corners[i]));
  const T error = error_bounds::constant<T>(kRoundoff) * size + error_bounds::constant<T>(error_bounds::underflow<T>);
  const T distance = (lowest - error_bounds::constant<T>(error_bounds::kAxisNow) * error) /
                     (sqrt(dot(n, n)) * error_bounds::constant<T>(1 + 8 * kRoundoff));
  return select(distance > T(0), distance, T(0));
}

}  // namespace tamis
