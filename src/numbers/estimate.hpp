// An estimate of an integer: a double with a bound of its rounding, and the value modulo 2^128. Together they hold
// values below 2^127 exactly, so zeros and small values are known. Tried before Integer.
#pragma once
#include <cmath>
#include <cstdint>

#include "numbers/assert.hpp"
#include "numbers/double_double.hpp"
#include "numbers/platform.hpp"
#include "numbers/two_words.hpp"
#include "numbers/wide_double.hpp"

namespace tamis {

/// Has the operations that the templates of pair/motion/polynomials.hpp need, as Integer does. Tells whether its sign
/// is known.
class Estimate {
 public:
  Estimate() = default;
  Estimate(int value) : value_(value), rest_(TwoWords::of(value)) {}
  /// mantissa 2^shift, an integer. REQUIRES: |mantissa| <= 2^53.
  static Estimate scaled(std::int64_t mantissa, int shift) {
    TAMIS_ASSERT(std::int64_t{-1} << 53 <= mantissa && mantissa <= std::int64_t{1} << 53);
    if (shift <= 0) return {static_cast<double>(mantissa >> -shift), 0, TwoWords::of(mantissa >> -shift)};
    if (shift > 900) return {0, HUGE_VAL, {}};
    return {times_power_of_two(static_cast<double>(mantissa), shift), 0,
            shift < 128 ? TwoWords::of(mantissa) << shift : TwoWords()};
  }

  double value() const { return value_; }
  bool has_sign() const { return is_zero() || std::fabs(value_) > error_; }
  /// Means nothing unless has_sign(), which callers may test afterwards.
  int sign() const { return value_ > 0 ? 1 : value_ < 0 ? -1 : 0; }
  /// True if the value is off by at most a few roundings, 2^-48 of `size`.
  bool is_sharp(double size) const { return error_ <= 0x1p-48 * size && std::isfinite(size); }
  bool is_sharp() const { return is_sharp(std::fabs(value_)); }

  // Forced inline. A pair takes hundreds, and a call would pass the 32 bytes of each through memory.
  TAMIS_ALWAYS_INLINE friend Estimate operator-(const Estimate& a) { return {-a.value_, a.error_, -a.rest_}; }
  TAMIS_ALWAYS_INLINE friend Estimate operator+(const Estimate& a, const Estimate& b) {
    const DoubleDouble sum = DoubleDouble::sum_of(a.value_, b.value_);
    return Estimate{sum.high, kUp * (a.error_ + b.error_ + std::fabs(sum.low)), a.rest_ + b.rest_}.sharpened();
  }
  TAMIS_ALWAYS_INLINE friend Estimate operator-(const Estimate& a, const Estimate& b) { return a + -b; }
  TAMIS_ALWAYS_INLINE friend Estimate operator*(const Estimate& a, const Estimate& b) {
    const double product = a.value_ * b.value_ + 0;  // never -0
    const double inherited = std::fabs(a.value_) * b.error_ + a.error_ * (std::fabs(b.value_) + b.error_);
    return {product, kUp * (inherited + kRounding * std::fabs(product)), a.rest_ * b.rest_};
  }

 private:
  static constexpr double kRounding = 0x1p-53, kUp = 1 + 0x1p-50;  // kUp: for roundings of the bound

  Estimate(double value, double error, TwoWords rest) : value_(value), error_(error), rest_(rest) {}

  bool is_zero() const { return value_ == 0 && error_ == 0; }
  /// After an addition that cancelled much: the value that is known modulo 2^128, if it is surely below 2^126.
  Estimate sharpened() const {
    if (is_sharp() || !(std::fabs(value_) + error_ < 0x1p126)) return *this;
    const auto value = rest_.to_double();
    return {value, kRounding * std::fabs(value), rest_};
  }

  double value_ = 0, error_ = 0;  ///< integers do not underflow; after an overflow the error is infinite or NaN
  TwoWords rest_;
};

}  // namespace tamis
