#include "exact/root_isolation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "numerics/assert.hpp"

namespace tamis {
namespace {

class RootIsolation {
 public:
  RootIsolation(const IntegerPolynomial& p, const DyadicCell& within)
      : polynomial_(p), within_(within), local_(p.on(within)) {}

  std::vector<AlgebraicTime> run() {
    add_if_root(within_);
    // Bisection ends only if all roots are simple; one sign variation means one simple root already.
    if (local_.sign_variations() > 1) {
      polynomial_ = polynomial_.squarefree_part();
      local_ = polynomial_.on(within_);
    }
    isolate();
    add_if_root({within_.n + 1, within_.k});
    return std::move(roots_);
  }

 private:
  void add_if_root(const DyadicCell& time) {
    if (polynomial_.sign_at(time) == 0) roots_.push_back(AlgebraicTime::exactly(time));
  }

  /// A cell that may hold roots.
  struct Part {
    DyadicCell cell;
    IntegerPolynomial local;  ///< the polynomial with the cell mapped to [0,1]
    int depth;
    unsigned long bits;
    bool may_start_with_root;
  };

  /// Finds the roots from left to right, by a list of cells in place of recursion: exponents make cells thousands of
  /// halvings deep.
  void isolate() {
    std::vector<Part> parts;
    parts.push_back({within_, local_, 0, 4, false});
    while (!parts.empty()) {
      const Part part = std::move(parts.back());
      parts.pop_back();
      if (part.may_start_with_root) add_if_root(part.cell);
      const int variations = part.local.sign_variations();
      if (variations == 1) roots_.emplace_back(polynomial_, part.local.sign_after_zero(), part.cell);
      if (variations > 1) divide(part, variations, parts);
    }
  }

  /// Halves the cell, which soon tells ordinary roots apart. After kHalvings, roots that are still together are first
  /// sought where Newton's method puts them, in one of 2^bits smaller cells (Sagraloff, Mehlhorn 2016): if that cell
  /// has all the variations, the rest of this one has none, and so no root; the next try is among twice as many bits.
  static void divide(const Part& part, int variations, std::vector<Part>& parts) {
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
    const unsigned long fewer_bits = std::max(bits / 2, 2UL);
    parts.push_back({cell.right_half(), local.on({1, 1}), depth + 1, fewer_bits, true});
    parts.push_back({cell.left_half(), local.on({0, 1}), depth + 1, fewer_bits, false});
  }

  /// That of 2^bits cells of [0,1] which may hold `roots` roots, by a step of Newton's method from the end 0 or 1.
  static DyadicCell cell_of_roots(const IntegerPolynomial& local, int roots, int end, unsigned long bits) {
    const Integer value = local.scaled_value({end, 0}), slope = local.derivative().scaled_value({end, 0});
    const Integer last = (Integer(1) << bits) - 1;
    Integer n = end == 0 ? Integer(0) : last;
    if (slope.sign() != 0) n -= quotient((value * roots) << bits, slope);
    if (n.sign() < 0) n = 0;
    return {(last - n).sign() < 0 ? last : n, bits};
  }

  IntegerPolynomial polynomial_;
  const DyadicCell within_;
  IntegerPolynomial local_;  ///< the polynomial with within_ mapped to [0,1]
  std::vector<AlgebraicTime> roots_;
};

/// The cell from 0 to the next power of two above `latest`, which is at most 1.
DyadicCell cell_until(double latest) {
  int exponent = 0;
  std::frexp(std::max(latest, std::numeric_limits<double>::denorm_min()), &exponent);
  return {0, static_cast<unsigned long>(std::max(-exponent, 0))};
}

}  // namespace

std::vector<AlgebraicTime> roots_in_unit_interval(const IntegerPolynomial& p, double latest) {
  TAMIS_ASSERT(!p.is_zero() && 0 <= latest && latest <= 1);
  return RootIsolation(p, cell_until(latest)).run();
}

}  // namespace tamis
