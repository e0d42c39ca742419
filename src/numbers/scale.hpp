// Scaling by a power of two, so no decision depends on the unit of length.
#pragma once
#include <algorithm>
#include <cmath>

namespace tamis {

/// The power of two that brings `size` into [1/2, 1), within [2^-1022, 2^1000]: a normal double, exact to multiply
/// with. 1 where `size` is zero, infinite or NaN. Sizes from 2^1022 on stay at 1 or above.
inline double scale_below_one(double size) {
  if (!(size > 0) || std::isinf(size)) return 1;
  return std::ldexp(1.0, std::clamp(-1 - std::ilogb(size), -1022, 1000));
}

}  // namespace tamis
