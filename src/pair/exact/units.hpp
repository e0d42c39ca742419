// The largest unit that makes coordinates integers, so the integers are short.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <climits>
#include <cstdint>
#include <span>

#include "pair/motion/make_motion.hpp"

namespace tamis {

/// x = mantissa 2^exponent.
struct Parts {
  std::int64_t mantissa;
  int exponent;
};

inline Parts parts_of(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto biased = static_cast<int>(bits >> 52 & 0x7ff);
  auto mantissa = static_cast<std::int64_t>(bits & 0xfffffffffffff);
  if (biased > 0) mantissa |= std::int64_t{1} << 52;
  return {x < 0 ? -mantissa : mantissa, std::max(biased, 1) - 1075};
}

/// The exponent of the last bit that is set; INT_MAX for zero.
inline int lowest_exponent(double x) {
  if (x == 0) return INT_MAX;
  const Parts parts = parts_of(x);
  return parts.exponent + std::countr_zero(static_cast<std::uint64_t>(parts.mantissa));
}

/// One for each axis.
using Exponents = std::array<int, 3>;

/// For each axis the lowest of `lowest` and the lowest_exponent() of the points' coordinates. INT_MAX if all are zero.
inline Exponents lowest_exponents(std::span<const Point> points, Exponents lowest = {INT_MAX, INT_MAX, INT_MAX}) {
  for (const Point& point : points)
    for (std::size_t k = 0; k < 3; ++k) lowest[k] = std::min(lowest[k], lowest_exponent(point[k]));
  return lowest;
}

inline Exponents lowest_exponents(const PairPoints& points) {
  return lowest_exponents(points.end, lowest_exponents(points.start));
}

/// The lowest of all axes and of the separation, for each axis; 0 if all are zero.
inline Exponents common_unit(const Exponents& lowest, double separation) {
  const int common = std::min({lowest[0], lowest[1], lowest[2], lowest_exponent(separation)});
  const int unit = common == INT_MAX ? 0 : common;
  return {unit, unit, unit};
}

}  // namespace tamis
