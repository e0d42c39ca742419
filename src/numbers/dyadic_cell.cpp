#include "numbers/dyadic_cell.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "numbers/assert.hpp"

namespace tamis {
namespace {

constexpr int kDigits = std::numeric_limits<double>::digits;
/// 2^-1074 is the spacing of the smallest doubles.
constexpr long kFinestSpacing = 1074;

/// s, where doubles from n / 2^k upward have the spacing 2^-s.
long spacing_above(const DyadicCell& cell) {
  if (cell.n.sign() == 0) return kFinestSpacing;
  const long above_binary_point = cell.n.bits() - static_cast<long>(cell.k);
  return std::min(kDigits - above_binary_point, kFinestSpacing);
}

}  // namespace

DyadicCell cell_above(double lower) {
  TAMIS_ASSERT(0 <= lower && lower <= 1);
  long spacing = kFinestSpacing;
  if (lower > 0) spacing = std::min<long>(kDigits - 1 - std::ilogb(lower), kFinestSpacing);
  // Two steps: 2^1074 is not a double.
  const double half_scaled = std::ldexp(lower, static_cast<int>(spacing / 2));
  return {static_cast<std::int64_t>(std::ldexp(half_scaled, static_cast<int>(spacing - spacing / 2))),
          static_cast<unsigned long>(spacing)};
}

DyadicCell shortest_cell_at(double time) {
  DyadicCell cell = cell_above(time);
  if (cell.n.sign() == 0) return {};
  const unsigned long common = std::min<unsigned long>(mpz_scan1(cell.n.get(), 0), cell.k);
  return {cell.n >> common, cell.k - common};
}

double middle_double(double a, double b) {
  TAMIS_ASSERT(0 <= a && a <= b);
  const auto bits_a = std::bit_cast<std::uint64_t>(a), bits_b = std::bit_cast<std::uint64_t>(b);
  return std::bit_cast<double>(bits_a + (bits_b - bits_a) / 2);
}

int compare_lower_ends(const DyadicCell& a, const DyadicCell& b) {
  const unsigned long k = std::max(a.k, b.k);
  return ((a.n << (k - a.k)) - (b.n << (k - b.k))).sign();
}

DyadicCell between(const DyadicCell& a, const DyadicCell& b) {
  const unsigned long k = std::max(a.k, b.k) + 1;
  const Integer from = a.n << (k - a.k), gap = (b.n << (k - b.k)) - from;
  TAMIS_ASSERT(gap.sign() > 0);
  // The first multiple after `from` of a power of two that is at most half of the gap.
  const auto spacing = std::min(static_cast<unsigned long>(gap.bits() - 2), k);
  return {(from >> spacing) + 1, k - spacing};
}

double lower_end(const DyadicCell& cell) {
  TAMIS_ASSERT(cell.n.sign() >= 0 && ((Integer(1) << cell.k) - cell.n).sign() >= 0);
  const long spacing = spacing_above(cell);
  const long excess = static_cast<long>(cell.k) - spacing;
  if (excess <= 0) return std::ldexp(cell.n.to_double(), -static_cast<int>(cell.k));
  const Integer kept = cell.n >> static_cast<unsigned long>(excess);
  return std::ldexp(kept.to_double(), -static_cast<int>(spacing));
}

bool lower_end_is_double(const DyadicCell& cell) {
  const long excess = static_cast<long>(cell.k) - spacing_above(cell);
  return excess <= 0 || cell.n.sign() == 0 ||
         mpz_divisible_2exp_p(cell.n.get(), static_cast<unsigned long>(excess)) != 0;
}

}  // namespace tamis
