// Integers of any size by Boost.Multiprecision. Up to 768 bits they need no heap: an exact decision makes hundreds of
// them, and malloc would take half of its time. This header alone includes Boost, which takes a second to compile.
#pragma once
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>

#include "numbers/assert.hpp"

namespace tamis {

/// Has the operations that the templates of pair/motion/polynomials.hpp and Horner's rule need. Numbers of bits are of
/// the absolute value.
class Integer {
 public:
  Integer() = default;
  Integer(std::int64_t value) : value_(static_cast<boost::multiprecision::signed_double_limb_type>(value)) {}
  /// mantissa 2^shift, cut to an integer. REQUIRES: shift > -64.
  static Integer scaled(std::int64_t mantissa, int shift) {
    TAMIS_ASSERT(shift > -64);
    if (shift <= 0) return mantissa >> -shift;
    return Integer(mantissa) << shift;
  }

  int sign() const { return value_.sign() ? -1 : is_zero() ? 0 : 1; }
  /// 1 for zero.
  int bits() const;
  /// Zeros below the lowest bit that is set. REQUIRES: not zero.
  int trailing_zeros() const;
  /// 64 bits of the absolute value, from the bit `first` upwards. REQUIRES: first >= 0.
  std::uint64_t bits_from(int first) const;
  /// fraction 2^exponent. The fraction is cut, not rounded, and 0.5 <= |fraction| < 1, or 0.
  double fraction(int& exponent) const;
  /// Towards zero.
  double to_double() const;

  Integer& operator+=(const Integer& b) { return eval_add(value_, b.value_), *this; }
  Integer& operator-=(const Integer& b) { return eval_subtract(value_, b.value_), *this; }
  Integer& operator*=(const Integer& b) { return *this = *this * b; }
  /// REQUIRES: bits >= 0.
  Integer& operator<<=(int bits) {
    TAMIS_ASSERT(bits >= 0);
    return eval_left_shift(value_, static_cast<unsigned>(bits)), *this;
  }
  /// Towards zero. REQUIRES: bits >= 0.
  Integer& operator>>=(int bits);

  friend Integer operator-(Integer a) { return a.value_.negate(), a; }
  friend Integer operator+(const Integer& a, const Integer& b) {
    return make([&](Value& result) { eval_add(result, a.value_, b.value_); });
  }
  friend Integer operator-(const Integer& a, const Integer& b) {
    return make([&](Value& result) { eval_subtract(result, a.value_, b.value_); });
  }
  friend Integer operator*(const Integer& a, const Integer& b) {
    return make([&](Value& result) { eval_multiply(result, a.value_, b.value_); });
  }
  /// Towards zero. REQUIRES: b is not zero.
  friend Integer quotient(const Integer& a, const Integer& b) {
    TAMIS_ASSERT(!b.is_zero());
    return make([&](Value& result) { eval_divide(result, a.value_, b.value_); });
  }
  friend Integer greatest_common_divisor(const Integer& a, const Integer& b) {
    return make([&](Value& result) { eval_gcd(result, a.value_, b.value_); });
  }
  friend Integer operator<<(Integer a, int bits) { return a <<= bits, a; }
  friend Integer operator>>(Integer a, int bits) { return a >>= bits, a; }

 private:
  using Value = boost::multiprecision::cpp_int_backend<768>;

  template <class Operation>
  static Integer make(const Operation& operation) {
    Integer result;
    operation(result.value_);
    return result;
  }
  bool is_zero() const { return value_.size() == 1 && *value_.limbs() == 0; }

  Value value_;
};

}  // namespace tamis
