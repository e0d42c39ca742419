// Tests whether a pair's clearance at t=0 suffices for its speed. The clearance is bounded from below on the 13 axes of
// the 26-DOP. Error bound: twice the bounds of a projection and of a velocity. So a pair culled here is also beyond
// reach by the bounds in doubles of pair/narrow/kept_distance.hpp. Cost: about 150 operations.
#pragma once
#include "numbers/axes.hpp"
#include "numbers/error_bounds.hpp"
#include "pair/motion/difference_corners.hpp"

namespace tamis {

struct StartGap {
  /// True if the clearance is proven larger than `reach` times the relative speed.
  template <PairKind kind, class T>
  static auto exceeds(const PairMotion<T>& m, const T& reach) {
    const T size = m.size_d + m.size_e + m.size_f;
    const T margin = error_bounds::bound<T>(2 * error_bounds::kProjection, size) +
                     constant<T>(1 + 8 * error_bounds::unit_roundoff<T>) * m.separation;
    const T gap = gap_of<kind>(m) - margin;
    const T length = sqrt(squared_speed<kind>(m)) * constant<T>(1 + 8 * error_bounds::unit_roundoff<T>);
    const T speed = length + error_bounds::bound<T>(2 * error_bounds::kVelocity, size);
    return gap > reach * speed;
  }

 private:
  template <PairKind kind, class T>
  static T gap_of(const PairMotion<T>& m) {
    T gap(0);
    for_each_axis<13>([&](auto axis) {
      constexpr std::size_t i = decltype(axis)::value;
      const auto range = range_of_differences<kind>(project<i>(m.e.at0), project<i>(m.f.at0), project<i>(m.d.at0));
      gap = max(gap, constant<T>(1 / axis_length(i)) * max(range.low, -range.high));
    });
    return gap;
  }
};

}  // namespace tamis
