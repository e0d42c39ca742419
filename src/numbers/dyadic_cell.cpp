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
constexpr int kFinestSpacing = 1074;

/// s, where doubles from n / 2^k upward have the spacing 2^-s.
int spacing_above(const DyadicCell& cell) {
  if (cell.n.sign() == 0) return kFinestSpacing;
  return std::min(kDigits - (cell.n.bits() - cell.k), kFinestSpacing);
}

}  // namespace

DyadicCell cell_above(double lower) {
  TAMIS_ASSERT(0 <= lower && lower <= 1);
  int spacing = kFinestSpacing;
  if (lower > 0) spacing = std::min(kDigits - 1 - std::ilogb(lower), kFinestSpacing);
  // Two steps: 2^1074 is not a double.
  const double half_scaled = std::ldexp(lower, spacing / 2);
  return {static_cast<std::int64_t>(std::ldexp(half_scaled, spacing - spacing / 2)), spacing};
}

DyadicCell shortest_cell_at(double time) {
  DyadicCell cell = cell_above(time);
  if (cell.n.sign() == 0) return {};
  const int common = std::min(cell.n.trailing_zeros(), cell.k);
  return {cell.n >> common, cell.k - common};
}

double middle_double(double a, double b) {
  TAMIS_ASSERT(0 <= a && a <= b);
  const auto bits_a = std::bit_cast<std::uint64_t>(a), bits_b = std::bit_cast<std::uint64_t>(b);
  return std::bit_cast<double>(bits_a + (bits_b - bits_a) / 2);
}

int compare_lower_ends(const DyadicCell& a, const DyadicCell& b) {
  const int k = std::max(a.k, b.k);
  return ((a.n << (k - a.k)) - (b.n << (k - b.k))).sign();
}

DyadicCell between(const DyadicCell& a, const DyadicCell& b) {
  const int k = std::max(a.k, b.k) + 1;
  const Integer from = a.n << (k - a.k), gap = (b.n << (k - b.k)) - from;
  TAMIS_ASSERT(gap.sign() > 0);
  // The first multiple after `from` of a power of two that is at most half of the gap.
  const int spacing = std::min(gap.bits() - 2, k);
  return {(from >> spacing) + 1, k - spacing};
}

double lower_end(const DyadicCell& cell) {
  TAMIS_ASSERT(cell.n.sign() >= 0 && ((Integer(1) << cell.k) - cell.n).sign() >= 0);
  const int spacing = spacing_above(cell);
  const int excess = cell.k - spacing;
  if (excess <= 0) return std::ldexp(cell.n.to_double(), -cell.k);
  const Integer kept = cell.n >> excess;
  return std::ldexp(kept.to_double(), -spacing);
}

bool lower_end_is_double(const DyadicCell& cell) {
  const int excess = cell.k - spacing_above(cell);
  return excess <= 0 || cell.n.sign() == 0 || cell.n.trailing_zeros() >= excess;
}

}  // namespace tamis
