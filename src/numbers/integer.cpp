#include "numbers/integer.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace tamis {
namespace {

constexpr int kLimbBits = std::numeric_limits<boost::multiprecision::limb_type>::digits;

}  // namespace

int Integer::bits() const {
  const auto count = static_cast<int>(value_.size());
  const auto highest = value_.limbs()[count - 1];
  return std::max(count * kLimbBits - std::countl_zero(highest), 1);
}

int Integer::trailing_zeros() const {
  TAMIS_ASSERT(!is_zero());
  int i = 0;
  while (value_.limbs()[i] == 0) ++i;
  return i * kLimbBits + std::countr_zero(value_.limbs()[i]);
}

std::uint64_t Integer::bits_from(int first) const {
  TAMIS_ASSERT(first >= 0);
  const auto count = static_cast<int>(value_.size());
  std::uint64_t result = 0;
  for (int i = first / kLimbBits, at = -(first % kLimbBits); i < count && at < 64; ++i, at += kLimbBits) {
    const std::uint64_t limb = value_.limbs()[i];
    result |= at < 0 ? limb >> -at : limb << at;
  }
  return result;
}

double Integer::fraction(int& exponent) const {
  constexpr int kMantissaBits = std::numeric_limits<double>::digits;
  const int dropped = std::max(bits() - kMantissaBits, 0);
  const auto leading = static_cast<double>(bits_from(dropped));
  const double fraction = std::frexp(leading, &exponent);
  exponent += dropped;
  return value_.sign() ? -fraction : fraction;
}

double Integer::to_double() const {
  int exponent = 0;
  const double mantissa = fraction(exponent);
  return std::ldexp(mantissa, exponent);
}

Integer& Integer::operator>>=(int bits) {
  TAMIS_ASSERT(bits >= 0);
  // Boost rounds downwards.
  const bool is_negative = value_.sign();
  if (is_negative) value_.negate();
  eval_right_shift(value_, static_cast<unsigned>(bits));
  if (is_negative) value_.negate();
  return *this;
}

}  // namespace tamis
