#include "solve/root_isolation.hpp"

#include <cmath>
#include <utility>

namespace tamis {
namespace {

class RootIsolation {
 public:
  explicit RootIsolation(const IntegerPolynomial& p) : polynomial_(p) {}

  std::vector<AlgebraicTime> run() {
    // Bisection ends only if all roots are simple; one sign variation means one simple root already.
    if (polynomial_.sign_variations() > 1) polynomial_ = polynomial_.squarefree_part();
    add_if_root({0, 0});
    isolate(0, 1, polynomial_, 0);
    add_if_root({1, 0});
    return std::move(roots_);
  }

 private:
  void add_if_root(const DyadicCell& time) {
    if (polynomial_.sign_at(time) == 0) roots_.push_back(AlgebraicTime::exactly(time));
  }

  /// Between two doubles. `local`: the polynomial with that interval mapped to [0,1].
  void isolate(double lower, double upper, const IntegerPolynomial& local, int depth) {
    const int variations = local.sign_variations();
    if (variations == 1) roots_.emplace_back(polynomial_, local.sign_after_zero(), lower, upper);
    if (variations <= 1) return;
    if (std::nextafter(lower, 2.0) == upper) return isolate_in(cell_above(lower), local);
    // Ordinary roots are soon told apart; those among the smallest doubles by halving exponents.
    constexpr int kHalvings = 6;
    const double halfway = 0.5 * (lower + upper);
    const bool is_ordinary = depth < kHalvings && lower < halfway && halfway < upper;
    const double middle = is_ordinary ? halfway : middle_double(lower, upper);
    isolate(lower, middle, between(lower, middle), depth + 1);
    add_if_root(cell_above(middle));
    isolate(middle, upper, between(middle, upper), depth + 1);
  }

  IntegerPolynomial between(double lower, double upper) const {
    const auto [first, width] = cells_between(lower, upper);
    return polynomial_.on(first, width);
  }

  /// Between neighbouring doubles.
  void isolate_in(const DyadicCell& cell, const IntegerPolynomial& local) {
    const int variations = local.sign_variations();
    if (variations == 1) roots_.emplace_back(polynomial_, cell);
    if (variations <= 1) return;
    const DyadicCell right = cell.right_half();
    isolate_in(cell.left_half(), local.left_half());
    add_if_root(right);
    isolate_in(right, local.right_half());
  }

  IntegerPolynomial polynomial_;
  std::vector<AlgebraicTime> roots_;
};

}  // namespace

std::vector<AlgebraicTime> roots_in_unit_interval(const IntegerPolynomial& p) { return RootIsolation(p).run(); }

}  // namespace tamis
