// The constant axes of the k-DOPs (Klosowski et al. 1998). Every family is a prefix: 3 axes are the box, 8 the 16-DOP,
// 9 the 18-DOP, 13 the 26-DOP.
#pragma once
#include <cstddef>
#include <utility>

#include "numbers/vec.hpp"

namespace tamis {

/// Dot product of `v` with axis `i`: its components are -1, 0 or 1.
template <std::size_t i, class T>
inline T project(const Vec3<T>& v) {
  static_assert(i < 13);
  if constexpr (i == 0) return v.x;
  if constexpr (i == 1) return v.y;
  if constexpr (i == 2) return v.z;
  if constexpr (i == 3) return v.x + v.y;
  if constexpr (i == 4) return v.x - v.y;
  if constexpr (i == 5) return v.x + v.z;
  if constexpr (i == 6) return v.x - v.z;
  if constexpr (i == 7) return v.y + v.z;
  if constexpr (i == 8) return v.y - v.z;
  if constexpr (i == 9) return v.x + v.y + v.z;
  if constexpr (i == 10) return v.x + v.y - v.z;
  if constexpr (i == 11) return v.x - v.y + v.z;
  if constexpr (i == 12) return v.x - v.y - v.z;
}

/// Rounded up. A vector that is off by one on each of three axes is off by the root of three in length.
inline constexpr double kRootOfTwo = 1.41421356237309515, kRootOfThree = 1.73205080756887742;

/// Euclidean length of axis `i`, rounded up.
constexpr double axis_length(std::size_t i) { return i < 3 ? 1 : i < 9 ? kRootOfTwo : kRootOfThree; }

/// Calls f(integral_constant) for the first `count` axes.
template <std::size_t count, class F>
inline void for_each_axis(const F& f) {
  [&]<std::size_t... i>(std::index_sequence<i...>) { (f(std::integral_constant<std::size_t, i>{}), ...); }
  (std::make_index_sequence<count>{});
}

}  // namespace tamis
