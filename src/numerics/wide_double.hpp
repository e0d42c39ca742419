// A double with room for any exponent: what is left of an integer when most of its bits are not needed.
#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>

#include "numerics/integer.hpp"

namespace tamis {

/// mantissa 2^exponent.
struct WideDouble {
  double mantissa = 0;
  long exponent = 0;

  /// Cut, not rounded: off by less than 2 u of itself.
  static WideDouble of(const Integer& a) {
    WideDouble result;
    if (a.sign() != 0) result.mantissa = mpz_get_d_2exp(&result.exponent, a.get());
    return result;
  }
};

/// x 2^exponent; what is 2^-900 of the rest does not count, nor how much more than 2^900 of it.
inline double times_power_of_two(double x, long exponent) {
  constexpr long kBias = 1023, kMantissaBits = 52;
  const auto biased = static_cast<std::uint64_t>(kBias + std::clamp(exponent, -900L, 900L));
  return x * std::bit_cast<double>(biased << kMantissaBits);
}

}  // namespace tamis
