// Integers of any size by GMP. Up to 768 bits they need no heap. An exact decision makes hundreds of them, and
// mpz_class spends half of its time in malloc. Most operations are sums of numbers below 2^126 or products of two limbs
// by two. These bypass GMP.
#pragma once
#include <gmp.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "numbers/assert.hpp"

namespace tamis {

/// Has the operations that the templates of pair/motion/polynomials.hpp and Horner's rule need. get() gives the rest of
/// GMP.
class Integer {
 public:
  Integer() noexcept { use_own_limbs(); }
  Integer(std::int64_t value) noexcept;
  /// mantissa 2^shift, cut to an integer. REQUIRES: shift > -64.
  static Integer scaled(std::int64_t mantissa, int shift) {
    TAMIS_ASSERT(shift > -64);
    if (shift <= 0) return mantissa >> -shift;
    return Integer(mantissa) << static_cast<unsigned long>(shift);
  }
  Integer(const Integer& other) : Integer() { *this = other; }
  Integer(Integer&& other) noexcept : Integer() { *this = static_cast<Integer&&>(other); }
  ~Integer() { release(); }
  Integer& operator=(const Integer& other);
  Integer& operator=(Integer&& other) noexcept;
  /// Takes the value of any GMP integer.
  void assign(mpz_srcptr value);

  mpz_srcptr get() const { return value_; }
  int sign() const { return mpz_sgn(value_); }
  /// Number of bits of the absolute value; 1 for zero.
  long bits() const { return static_cast<long>(mpz_sizeinbase(value_, 2)); }
  /// Towards zero.
  double to_double() const { return mpz_get_d(value_); }

  Integer& operator+=(const Integer& b);
  Integer& operator-=(const Integer& b);
  Integer& operator*=(const Integer& b) { return *this = *this * b; }
  Integer& operator<<=(unsigned long bits) { return *this = *this << bits; }
  /// Towards zero.
  Integer& operator>>=(unsigned long bits) { return *this = *this >> bits; }

  friend Integer operator-(const Integer& a) { return make(a.limbs(), mpz_neg, a.get()); }
  friend Integer operator+(const Integer& a, const Integer& b) {
    if (are_short(a, b)) return of(a.wide() + b.wide());
    return make(sum_limbs(a, b), mpz_add, a.get(), b.get());
  }
  friend Integer operator-(const Integer& a, const Integer& b) {
    if (are_short(a, b)) return of(a.wide() - b.wide());
    return make(sum_limbs(a, b), mpz_sub, a.get(), b.get());
  }
  friend Integer operator*(const Integer& a, const Integer& b) {
    if (a.sign() == 0 || b.sign() == 0) return {};
    if (a.limbs() <= 2 && b.limbs() <= 2) return product_of_two_limbs(a, b);
    return make(a.limbs() + b.limbs(), mpz_mul, a.get(), b.get());
  }
  /// Towards zero. REQUIRES: b is not zero.
  friend Integer quotient(const Integer& a, const Integer& b) {
    TAMIS_ASSERT(b.sign() != 0);
    return make(std::max(a.limbs(), 1), mpz_tdiv_q, a.get(), b.get());
  }
  /// REQUIRES (not checked: exact): b divides a, and is not zero.
  friend Integer exact_quotient(const Integer& a, const Integer& b) {
    return make(std::max(a.limbs(), 1), mpz_divexact, a.get(), b.get());
  }
  friend Integer greatest_common_divisor(const Integer& a, const Integer& b) {
    return make(std::max(a.limbs(), b.limbs()), mpz_gcd, a.get(), b.get());
  }
  friend Integer operator<<(const Integer& a, unsigned long bits) {
    if (a.limbs() < 2 && bits < GMP_NUMB_BITS) {
      Integer result;
      result.set(a.sign() < 0, UnsignedWide{a.limb(0)} << bits);
      return result;
    }
    return make(a.shifted_limbs(bits), mpz_mul_2exp, a.get(), bits);
  }
  friend Integer operator>>(const Integer& a, unsigned long bits) {
    return make(a.limbs(), mpz_tdiv_q_2exp, a.get(), bits);
  }

 private:
  static constexpr int kOwnLimbs = 12;
  static_assert(GMP_NUMB_BITS == 64);

  __extension__ using Wide = __int128;
  __extension__ using UnsignedWide = unsigned __int128;

  static Integer of(Wide value) {
    Integer result;
    result.set(value);
    return result;
  }
  void set(Wide value) { set(value < 0, static_cast<UnsignedWide>(value < 0 ? -value : value)); }
  void set(bool is_negative, UnsignedWide magnitude) {
    mp_limb_t* const to = value_->_mp_d;
    to[0] = static_cast<mp_limb_t>(magnitude);
    to[1] = static_cast<mp_limb_t>(magnitude >> GMP_NUMB_BITS);
    const int size = to[1] != 0 ? 2 : to[0] != 0;
    value_->_mp_size = is_negative ? -size : size;
  }
  /// Below 2^126, so sums are below 2^127.
  bool is_short() const {
    const int count = limbs();
    return count < 2 || (count == 2 && value_->_mp_d[1] >> 62 == 0);
  }
  static bool are_short(const Integer& a, const Integer& b) { return a.is_short() && b.is_short(); }
  /// REQUIRES: is_short().
  Wide wide() const {
    TAMIS_ASSERT(is_short());
    const int count = limbs();
    const mp_limb_t* const from = value_->_mp_d;
    const auto magnitude =
        static_cast<Wide>((count > 1 ? UnsignedWide{from[1]} << GMP_NUMB_BITS : 0) | (count > 0 ? from[0] : 0));
    return sign() < 0 ? -magnitude : magnitude;
  }
  /// REQUIRES: room for the other's limbs. Mostly these are few: calling memmove would take longer than copying.
  void copy_limbs(const Integer& other) {
    TAMIS_ASSERT(other.limbs() <= value_->_mp_alloc);
    const int count = other.limbs();
    const mp_limb_t* const from = other.value_->_mp_d;
    mp_limb_t* const to = value_->_mp_d;
    if (count > 0) to[0] = from[0];
    if (count > 1) to[1] = from[1];
    if (count > 2) std::copy(from + 2, from + count, to + 2);
    value_->_mp_size = other.value_->_mp_size;
  }
  /// Zero beyond the last limb.
  mp_limb_t limb(int i) const { return i < limbs() ? value_->_mp_d[i] : 0; }
  static Integer product_of_two_limbs(const Integer& a, const Integer& b) {
    const UnsignedWide a0 = a.limb(0), a1 = a.limb(1), b0 = b.limb(0), b1 = b.limb(1);
    const auto low = [](UnsignedWide x) { return static_cast<mp_limb_t>(x); };
    const UnsignedWide first = a0 * b0, cross = a0 * b1, across = a1 * b0;
    const UnsignedWide middle = (first >> GMP_NUMB_BITS) + low(cross) + low(across);
    const UnsignedWide high =
        a1 * b1 + (cross >> GMP_NUMB_BITS) + (across >> GMP_NUMB_BITS) + (middle >> GMP_NUMB_BITS);
    Integer result;
    mp_limb_t* const to = result.value_->_mp_d;
    to[0] = low(first);
    to[1] = low(middle);
    to[2] = low(high);
    to[3] = low(high >> GMP_NUMB_BITS);
    int size = 4;
    while (size > 0 && to[size - 1] == 0) --size;
    result.value_->_mp_size = a.sign() == b.sign() ? size : -size;
    return result;
  }

  bool has_own_limbs() const { return value_->_mp_d == limbs_; }
  void use_own_limbs() {
    value_->_mp_d = limbs_;
    value_->_mp_alloc = kOwnLimbs;
    value_->_mp_size = 0;
  }
  void release() {
    if (!has_own_limbs()) mpz_clear(value_);
  }
  int limbs() const { return std::abs(value_->_mp_size); }
  int shifted_limbs(unsigned long bits) const { return limbs() + static_cast<int>(bits / GMP_NUMB_BITS) + 1; }
  static int sum_limbs(const Integer& a, const Integer& b) { return std::max(a.limbs(), b.limbs()) + 1; }
  /// The result of GMP's `operation`, which has at most `limbs` limbs.
  template <class Operation, class... Operands>
  static Integer make(int limbs, Operation operation, const Operands&... operands) {
    Integer result;
    result.reserve(limbs);
    operation(result.value_, operands...);
    return result;
  }
  /// Makes room for a result before the operation: GMP must not reallocate our own limbs.
  void reserve(int limbs) {
    if (limbs > value_->_mp_alloc) grow(limbs);
  }
  void grow(int limbs);

  mpz_t value_;
  mp_limb_t limbs_[kOwnLimbs];
};

inline Integer::Integer(std::int64_t value) noexcept : Integer() {
  const auto magnitude = static_cast<std::uint64_t>(value);
  limbs_[0] = value < 0 ? 0 - magnitude : magnitude;
  value_->_mp_size = (value > 0) - (value < 0);
}

inline void Integer::assign(mpz_srcptr value) {
  reserve(static_cast<int>(mpz_size(value)));
  mpz_set(value_, value);
}

inline Integer& Integer::operator=(const Integer& other) {
  if (this == &other) return *this;
  if (other.limbs() <= kOwnLimbs) {  // fits anywhere
    copy_limbs(other);
  } else {
    assign(other.get());
  }
  return *this;
}

inline Integer& Integer::operator=(Integer&& other) noexcept {
  if (this == &other) return *this;
  if (other.has_own_limbs()) {  // fits anywhere
    copy_limbs(other);
  } else {
    release();
    value_[0] = other.value_[0];
    other.use_own_limbs();
  }
  return *this;
}

inline Integer& Integer::operator+=(const Integer& b) {
  if (are_short(*this, b)) return set(wide() + b.wide()), *this;
  reserve(sum_limbs(*this, b));
  mpz_add(value_, value_, b.value_);
  return *this;
}

inline Integer& Integer::operator-=(const Integer& b) {
  if (are_short(*this, b)) return set(wide() - b.wide()), *this;
  reserve(sum_limbs(*this, b));
  mpz_sub(value_, value_, b.value_);
  return *this;
}

}  // namespace tamis
