// Integers modulo 2^128, in two words.
#pragma once
#include <bit>
#include <cmath>
#include <cstdint>

#include "numbers/assert.hpp"
#include "numbers/platform.hpp"

namespace tamis {

struct TwoWords {
  std::uint64_t low = 0, high = 0;

  static TwoWords of(std::int64_t value) {
    return {static_cast<std::uint64_t>(value), value < 0 ? ~std::uint64_t{0} : 0};
  }

  bool operator==(const TwoWords&) const = default;
  TAMIS_ALWAYS_INLINE friend TwoWords operator+(TwoWords a, TwoWords b) {
    const std::uint64_t sum = a.low + b.low;
    return {sum, a.high + b.high + (sum < a.low)};
  }
  TAMIS_ALWAYS_INLINE friend TwoWords operator-(TwoWords a) { return {0 - a.low, ~a.high + (a.low == 0)}; }
  TAMIS_ALWAYS_INLINE friend TwoWords operator*(TwoWords a, TwoWords b) {
    return {a.low * b.low, high_product(a.low, b.low) + a.low * b.high + a.high * b.low};
  }
  /// a 2^bits. REQUIRES: 0 < bits < 128.
  friend TwoWords operator<<(TwoWords a, int bits) {
    TAMIS_ASSERT(0 < bits && bits < 128);
    if (bits >= 64) return {0, a.low << (bits - 64)};
    return {a.low << bits, a.high << bits | a.low >> (64 - bits)};
  }
  /// The nearest double to the one value in [-2^127, 2^127).
  double to_double() const {
    const bool is_negative = high >> 63 != 0;
    const TwoWords magnitude = is_negative ? -*this : *this;
    if (magnitude.high == 0)
      return is_negative ? -static_cast<double>(magnitude.low) : static_cast<double>(magnitude.low);
    // The first 64 bits round as all bits do. The last of them tells whether any that follow are set.
    const int zeros = std::countl_zero(magnitude.high);
    const TwoWords shifted = zeros > 0 ? magnitude << zeros : magnitude;
    const auto rounded = static_cast<double>(shifted.high | (shifted.low != 0));
    return std::ldexp(is_negative ? -rounded : rounded, 64 - zeros);
  }
};

}  // namespace tamis
