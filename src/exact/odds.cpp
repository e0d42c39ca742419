#include "exact/odds.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "numerics/assert.hpp"
#include "numerics/wide_double.hpp"

namespace tamis {
namespace {

/// Beyond these exponents a time lies between 0 and the smallest double, or between 1 and the largest double below.
constexpr long kNextToZero = -1080, kNextToOne = 60;

/// REQUIRES: kNextToZero <= exponent <= kNextToOne.
double value(const Odds& s) {
  TAMIS_ASSERT(kNextToZero <= s.exponent && s.exponent <= kNextToOne);
  return std::ldexp(s.mantissa, static_cast<int>(s.exponent));
}

}  // namespace

// The quotients are off by less than 2^-51 of themselves, and where they are subnormal by less than two units.
double OddsBracket::lower_time() const {
  if (low.exponent < kNextToZero) return 0;
  if (low.exponent > kNextToOne) return 1 - 0x1p-53;
  const double s = value(low), unit = std::numeric_limits<double>::denorm_min();
  if (s >= 1) return std::nextafter(1 - (1 + 0x1p-50) / (1 + s), 0.0);
  return std::max((1 - 0x1p-50) * (s / (1 + s)) - 4 * unit, 0.0);
}

double OddsBracket::upper_time() const {
  const double unit = std::numeric_limits<double>::denorm_min();
  if (high.exponent < kNextToZero) return unit;
  if (high.exponent > kNextToOne) return 1;
  const double s = value(high);
  if (s >= 1) return std::min(std::nextafter(1 - (1 - 0x1p-50) / (1 + s), 2.0), 1.0);
  return (1 + 0x1p-50) * (s / (1 + s)) + 4 * unit;
}

std::optional<DyadicCell> OddsBracket::cell() const {
  const bool is_next_to_one = low.exponent > kNextToOne;
  if (!is_next_to_one && high.exponent >= kNextToZero) return {};
  // The distance from the end is s or 1/s, to 2^-53 of itself: in units of 2^-k, near and far.
  for (long bits = 16; bits < 24; ++bits) {
    const Odds &nearer = is_next_to_one ? high : low, &farther = is_next_to_one ? low : high;
    const auto distance = [&](const Odds& s) {
      return is_next_to_one ? times_power_of_two(1 / s.mantissa, bits - s.exponent + nearer.exponent)
                            : times_power_of_two(s.mantissa, bits + s.exponent - nearer.exponent);
    };
    const double n = std::floor((1 - 0x1p-40) * distance(nearer));
    if (n != std::floor((1 + 0x1p-40) * distance(farther))) continue;
    const auto k = static_cast<unsigned long>(bits + std::labs(nearer.exponent));
    const Integer cells_before = static_cast<std::int64_t>(n);
    return is_next_to_one ? DyadicCell{(Integer(1) << k) - 1 - cells_before, k} : DyadicCell{cells_before, k};
  }
  return {};
}

}  // namespace tamis
