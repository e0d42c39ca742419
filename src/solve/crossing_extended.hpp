// The crossing of solve/crossing.hpp in double-double: only the search of the root is another one.
#pragma once
#include "numerics/double_double.hpp"
#include "solve/crossing.hpp"

namespace tamis::crossing {

/// The root in double, then twice Newton's method. Not certified either.
template <>
inline DoubleDouble find_root(const std::array<DoubleDouble, 4>& k) {
  const DoubleDouble start = find_root(std::array{k[0].high, k[1].high, k[2].high, k[3].high});
  const double inverse_slope = 1 / slope(k, start).high;
  DoubleDouble t = start;
  for (int i = 0; i < 2; ++i) t = min(max(t - value(k, t) * inverse_slope, DoubleDouble(0)), DoubleDouble(1));
  return t;
}

}  // namespace tamis::crossing
