// A double with an exponent of any size, such as the leading bits of an integer.
#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "numbers/assert.hpp"

namespace tamis {

class Integer;

/// x 2^exponent, with the exponent cut to [-900, 900]. A term below 2^-900 of the rest of a sum does not count. Nor
/// does it matter how far a term is above 2^900 of the rest.
inline double times_power_of_two(double x, int exponent) {
  constexpr int kBias = 1023, kMantissaBits = 52;
  const auto biased = static_cast<std::uint64_t>(kBias + std::clamp(exponent, -900, 900));
  return x * std::bit_cast<double>(biased << kMantissaBits);
}

/// mantissa 2^exponent. Operations on positive numbers are off by at most 2^-51 of the result.
struct WideDouble {
  double mantissa = 0;
  int exponent = 0;

  /// Cut, not rounded: off by less than 2 u of itself.
  static WideDouble of(const Integer& a);
  static WideDouble of(double a) {
    int exponent = 0;
    const double mantissa = std::frexp(a, &exponent);
    return {mantissa, exponent};
  }

  WideDouble times_two_to(int power) const { return {mantissa, exponent + power}; }
  /// REQUIRES: 0 <= mantissa < 4, as the other operations leave it.
  WideDouble root() const {
    TAMIS_ASSERT(0 <= mantissa && mantissa < 4);
    const bool is_odd = exponent % 2 != 0;
    return {std::sqrt(is_odd ? 2 * mantissa : mantissa), (exponent - (is_odd ? 1 : 0)) / 2};
  }
  friend WideDouble operator/(const WideDouble& a, const WideDouble& b) {
    return {a.mantissa / b.mantissa, a.exponent - b.exponent};
  }
  friend WideDouble operator+(const WideDouble& a, const WideDouble& b) {
    if (a.exponent < b.exponent) return b + a;
    return {a.mantissa + times_power_of_two(b.mantissa, b.exponent - a.exponent), a.exponent};
  }

  double value() const { return std::ldexp(mantissa, std::clamp(exponent, -5000, 5000)); }
  /// A double below it by 2^-46 of it, or by one spacing of the smallest doubles. REQUIRES (not checked:
  /// exact): positive.
  double rounded_down() const {
    constexpr double kError = 0x1p-46, kNormal = std::numeric_limits<double>::min();
    const double rounded = WideDouble{mantissa * (1 - kError), exponent}.value();
    return rounded < kNormal ? std::nextafter(rounded, 0) : rounded;
  }
};

}  // namespace tamis
