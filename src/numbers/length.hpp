// The length of a vector that may be too long for a double, or for the square of one.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

namespace tamis {

/// Infinite where a component is. std::hypot of three numbers has other bits in each standard library. These are
/// libstdc++'s. REQUIRES (not checked: hot): no component is NaN.
inline double length_of(double x, double y, double z) {
  const double largest = std::max({std::fabs(x), std::fabs(y), std::fabs(z)});
  if (largest == 0 || largest == std::numeric_limits<double>::infinity()) return largest;
  const auto square = [&](double part) { return (part / largest) * (part / largest); };
  return largest * std::sqrt(square(x) + square(y) + square(z));
}

/// The same up to a rounding or two. Saves the 20 ns of hypot wherever squares neither overflow nor underflow.
inline double quick_length_of(double x, double y, double z) {
  const double square = x * x + y * y + z * z;
  return 0x1p-900 < square && square < 0x1p900 ? std::sqrt(square) : length_of(x, y, z);
}

}  // namespace tamis
