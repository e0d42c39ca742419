#include "pair/exact/root_isolation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "numbers/assert.hpp"

namespace tamis {
namespace {

/// A cell that may hold roots.
struct RootCell {
  DyadicCell cell;
  IntegerPolynomial local;  ///< the polynomial with the cell mapped to [0,1]
  int depth;
  int bits;
  bool may_start_with_root;
};

/// The one of 2^bits cells of [0,1] that may hold `roots` roots, by a step of Newton's method from the end 0 or 1.
DyadicCell cell_of_roots(const IntegerPolynomial& local, int roots, int end, int bits) {
  const Integer value = local.scaled_value({end, 0}), slope = local.derivative().scaled_value({end, 0});
  const Integer last = (Integer(1) << bits) - 1;
  Integer n = end == 0 ? Integer(0) : last;
  if (slope.sign() != 0) n -= quotient((value * roots) << bits, slope);
  if (n.sign() < 0) n = 0;
  return {(last - n).sign() < 0 ? last : n, bits};
}

/// Halves the cell, which soon tells ordinary roots apart. After kHalvings, roots that are still together are first
/// sought where Newton's method puts them, in one of 2^bits smaller cells (Sagraloff, Mehlhorn 2016). If that cell has
/// all the variations, the rest of this one has none. So it has no root. The next try is among twice as many bits.
void divide_cell(const RootCell& part, int variations, std::vector<RootCell>& parts) {
  constexpr int kHalvings = 3;
  const auto& [cell, local, depth, bits, is_right] = part;
  for (int end = 0; end < 2 && depth >= kHalvings; ++end) {
    const DyadicCell smaller = cell_of_roots(local, variations, end, bits);
    IntegerPolynomial there = local.on(smaller);
    if (there.sign_variations() == variations) {
      parts.push_back({cell.part(smaller), std::move(there), depth, 2 * bits, false});
      return;
    }
  }
  const int fewer_bits = std::max(bits / 2, 2);
  parts.push_back({cell.right_half(), local.on({1, 1}), depth + 1, fewer_bits, true});
  parts.push_back({cell.left_half(), local.on({0, 1}), depth + 1, fewer_bits, false});
}

/// The cell from 0 to the next power of two above `latest`, which is at most 1.
DyadicCell cell_until(double latest) {
  int exponent = 0;
  std::frexp(std::max(latest, std::numeric_limits<double>::denorm_min()), &exponent);
  return {0, std::max(-exponent, 0)};
}

}  // namespace

/// Finds the roots from left to right, by a list of cells instead of recursion. Exponents make cells thousands of
/// halvings deep.
std::vector<AlgebraicTime> roots_in_unit_interval(const IntegerPolynomial& p, double latest) {
  TAMIS_ASSERT(!p.is_zero() && 0 <= latest && latest <= 1);
  const DyadicCell within = cell_until(latest);
  IntegerPolynomial polynomial = p, local = p.on(within);
  // Bisection ends only if all roots are simple. One sign variation means one simple root already.
  if (local.sign_variations() > 1) {
    polynomial = p.squarefree_part();
    local = polynomial.on(within);
  }
  std::vector<AlgebraicTime> roots;
  const auto add_if_root = [&](const DyadicCell& time) {
    if (polynomial.sign_at(time) == 0) roots.push_back(AlgebraicTime::exactly(time));
  };
  std::vector<RootCell> parts;
  parts.push_back({within, std::move(local), 0, 4, true});
  while (!parts.empty()) {
    const RootCell part = std::move(parts.back());
    parts.pop_back();
    if (part.may_start_with_root) add_if_root(part.cell);
    const int variations = part.local.sign_variations();
    if (variations == 1) roots.emplace_back(polynomial, part.local.sign_after_zero(), part.cell);
    if (variations > 1) divide_cell(part, variations, parts);
  }
  add_if_root({within.n + 1, within.k});
  return roots;
}

}  // namespace tamis
