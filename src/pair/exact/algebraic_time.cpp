#include "pair/exact/algebraic_time.hpp"

#include <cmath>
#include <utility>

#include "numbers/approximate_polynomial.hpp"
#include "numbers/assert.hpp"

namespace tamis {
namespace {

double next_up(double x) { return std::nextafter(x, 2.0); }

}  // namespace

AlgebraicTime AlgebraicTime::exactly(DyadicCell time) { return AlgebraicTime(std::move(time)); }

AlgebraicTime::AlgebraicTime(IntegerPolynomial p, int sign_before, DyadicCell cell)
    : polynomial_(std::move(p)), sign_before_(sign_before), cell_(std::move(cell)) {
  TAMIS_ASSERT(sign_before_ != 0 && polynomial_.on(cell_).sign_after_zero() == sign_before_);
  const double lower = lower_end(cell_), upper = lower_end({cell_.n + 1, cell_.k});
  if (next_up(lower) < upper) narrow_to_doubles(lower, upper);
}

void AlgebraicTime::halve() {
  DyadicCell right = cell_.right_half();
  const int side = polynomial_.sign_at(right) * sign_before_;  // the sign of this time minus the middle of the cell
  is_exact_ = side == 0;
  cell_ = side < 0 ? cell_.left_half() : std::move(right);
}

void AlgebraicTime::refine() {
  const Integer at_lower = polynomial_.scaled_value(cell_), at_upper = polynomial_.scaled_value({cell_.n + 1, cell_.k});
  // An end of the cell may itself be a root of the polynomial. Then the signs at the ends do not differ.
  if (refinement_ < 2 || at_lower.sign() * at_upper.sign() >= 0) {
    refinement_ = 4;
    return halve();
  }
  const int bits = refinement_;
  const DyadicCell guess{(cell_.n << bits) + quotient(at_lower << bits, at_lower - at_upper), cell_.k + bits};
  const int sign = polynomial_.sign_at(guess);
  is_exact_ = sign == 0;
  const bool is_there =
      is_exact_ || (sign == sign_before_ && polynomial_.sign_at({guess.n + 1, guess.k}) == -sign_before_);
  if (is_there) cell_ = guess;
  refinement_ = is_there ? 2 * bits : bits / 2;
}

bool AlgebraicTime::is_root_of(const IntegerPolynomial& q) {
  IntegerPolynomial common = greatest_common_divisor(polynomial_, q);
  // The divisor has at most one root in the cell, a simple one. So the parity of its sign variations decides.
  if (common.degree() <= 0 || common.on(cell_).sign_variations() % 2 == 0) return false;
  polynomial_ = std::move(common);
  sign_before_ = polynomial_.on(cell_).sign_after_zero();
  return true;
}

int AlgebraicTime::sign_of(const IntegerPolynomial& q) {
  if (q.degree() <= 0) return q.sign_after_zero();
  if (const int sign = ApproximatePolynomial(q).near(lower_end(cell_)).sign()) return sign;
  if (!is_exact_ && is_root_of(q)) return 0;
  for (; !is_exact_; refine()) {
    const IntegerPolynomial local = q.on(cell_);
    if (local.sign_variations() == 0) return local.sign_after_zero();
  }
  return q.sign_at(cell_);
}

bool AlgebraicTime::are_equal(const AlgebraicTime& a, const AlgebraicTime& b) {
  if (a.is_exact_ && b.is_exact_) return compare_lower_ends(a.cell_, b.cell_) == 0;
  if (a.is_exact_) return are_equal(b, a);
  // A cell holds one root of its polynomial. An exact `b` in the cell of `a` is that root iff it is a root.
  if (b.is_exact_)
    return compare_lower_ends(a.cell_, b.cell_) < 0 && compare_lower_ends(b.cell_, a.upper_end()) < 0 &&
           a.polynomial_.sign_at(b.cell_) == 0;
  const bool is_a_inner = a.cell_.k >= b.cell_.k;
  const DyadicCell &inner = is_a_inner ? a.cell_ : b.cell_, &outer = is_a_inner ? b.cell_ : a.cell_;
  if (compare_lower_ends(outer, {inner.n >> (inner.k - outer.k), outer.k}) != 0) return false;
  const IntegerPolynomial common = greatest_common_divisor(a.polynomial_, b.polynomial_);
  return common.degree() > 0 && common.on(inner).sign_variations() % 2 == 1;  // as in is_root_of
}

void AlgebraicTime::narrow(AlgebraicTime& a, AlgebraicTime& b) {
  TAMIS_ASSERT(!a.is_exact_ || !b.is_exact_);
  const bool is_a_wider = !a.is_exact_ && (b.is_exact_ || a.cell_.k <= b.cell_.k);
  (is_a_wider ? a : b).refine();
}

int compare(AlgebraicTime& a, AlgebraicTime& b) {
  for (bool may_be_equal = true;; AlgebraicTime::narrow(a, b)) {
    if (compare_lower_ends(a.upper_end(), b.cell_) < 0) return -1;
    if (compare_lower_ends(b.upper_end(), a.cell_) < 0) return 1;
    if (may_be_equal && AlgebraicTime::are_equal(a, b)) return 0;
    may_be_equal = false;
  }
}

DyadicCell time_between(AlgebraicTime& a, AlgebraicTime& b) {
  while (compare_lower_ends(a.upper_end(), b.cell_) >= 0) AlgebraicTime::narrow(a, b);
  return between(a.upper_end(), b.cell_);
}

void AlgebraicTime::narrow_to_doubles(double lower, double upper) {
  TAMIS_ASSERT(0 <= lower && lower < upper && upper <= 1);
  constexpr int kNewtonSteps = 12;
  refinement_ = 32;  // between neighbouring doubles the polynomial is nearly a straight line
  const ApproximatePolynomial rough(polynomial_), slope = rough.derivative();
  double guess = lower + 0.5 * (upper - lower);
  for (int step = 0; next_up(lower) < upper; ++step) {
    if (!(guess > lower && guess < upper) || step > kNewtonSteps) guess = middle_double(lower, upper);
    auto value = rough.near(guess);
    if (value.sign() == 0) {
      DyadicCell t = cell_above(guess);
      const Integer exact = polynomial_.scaled_value(t);
      if (exact.sign() == 0) {
        is_exact_ = true;
        cell_ = std::move(t);
        return;
      }
      const WideDouble there = WideDouble::of(exact);
      value = {there.mantissa, 0, there.exponent - t.k * polynomial_.degree()};
    }
    const int side = value.sign() * sign_before_;
    (side > 0 ? lower : upper) = guess;
    const auto fall = slope.near(guess);
    const double next = guess - times_power_of_two(value.value / fall.value, value.exponent - fall.exponent);
    guess = next != guess ? next : std::nextafter(guess, side > 0 ? 2.0 : -1.0);
  }
  cell_ = cell_above(lower);
}

TimeInterval<double> AlgebraicTime::bracket() const {
  const double lower = lower_end(cell_);
  return {lower, is_exact_ && lower_end_is_double(cell_) ? lower : next_up(lower)};
}

}  // namespace tamis
