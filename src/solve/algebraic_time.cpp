#include "solve/algebraic_time.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

namespace tamis {
namespace {

double next_up(double x) { return std::nextafter(x, 2.0); }

/// Halfway between in the order of the doubles, so that 62 halvings separate any two in [0,1].
double middle_double(double a, double b) {
  std::uint64_t bits_a, bits_b;
  std::memcpy(&bits_a, &a, sizeof a);
  std::memcpy(&bits_b, &b, sizeof b);
  const std::uint64_t middle = bits_a + (bits_b - bits_a) / 2;
  double result;
  std::memcpy(&result, &middle, sizeof result);
  return result;
}

/// Newton's correction -p/p' at t, from the exact values; NaN or infinite where p' vanishes.
double newton_step(const Integer& scaled_value, const IntegerPolynomial& derivative, const DyadicCell& t) {
  long exponent, derivative_exponent;
  const double value = mpz_get_d_2exp(&exponent, scaled_value.get());
  const double slope = mpz_get_d_2exp(&derivative_exponent, derivative.scaled_value(t).get());
  return std::ldexp(-value / slope, static_cast<int>(exponent - derivative_exponent - static_cast<long>(t.k)));
}

}  // namespace

AlgebraicTime AlgebraicTime::exactly(DyadicCell time) { return AlgebraicTime(std::move(time)); }

AlgebraicTime::AlgebraicTime(IntegerPolynomial p, DyadicCell cell) : cell_(std::move(cell)) {
  take_polynomial(std::move(p));
}

void AlgebraicTime::take_polynomial(IntegerPolynomial p) {
  polynomial_ = std::move(p);
  sign_before_ = polynomial_.on(cell_).sign_after_zero();
}

void AlgebraicTime::halve() {
  DyadicCell right = cell_.right_half();
  const int side = compare_to(right);
  is_exact_ = side == 0;
  cell_ = side < 0 ? cell_.left_half() : std::move(right);
}

bool AlgebraicTime::is_root_of(const IntegerPolynomial& q) {
  IntegerPolynomial common = greatest_common_divisor(polynomial_, q);
  // It has at most one root in the cell, a simple one: the parity of the sign variations decides.
  if (common.degree() <= 0 || common.on(cell_).sign_variations() % 2 == 0) return false;
  if (common.degree() < polynomial_.degree()) take_polynomial(std::move(common));
  return true;
}

int AlgebraicTime::sign_of(const IntegerPolynomial& q) {
  if (q.degree() <= 0) return q.sign_after_zero();
  narrow_to_doubles();
  for (bool is_first = true; !is_exact_; is_first = false) {
    const IntegerPolynomial local = q.on(cell_);
    if (local.sign_variations() == 0) return local.sign_after_zero();
    if (is_first && is_root_of(q)) return 0;
    halve();
  }
  return q.sign_at(cell_);
}

void AlgebraicTime::narrow_to_doubles() {
  if (is_exact_ || std::exchange(is_between_neighbours_, true)) return;
  // Either the cell lies between two neighbouring doubles, or both its ends are doubles.
  const double lower = lower_end(cell_);
  if (cell_above(lower).k < cell_.k) return;
  narrow_to_doubles(lower, lower + std::ldexp(1.0, -static_cast<int>(cell_.k)));
}

void AlgebraicTime::narrow_to_doubles(double lower, double upper) {
  constexpr int kNewtonSteps = 12;
  const IntegerPolynomial derivative = polynomial_.derivative();
  double guess = lower + 0.5 * (upper - lower);
  for (int step = 0; next_up(lower) < upper; ++step) {
    if (!(guess > lower && guess < upper) || step > kNewtonSteps) guess = middle_double(lower, upper);
    DyadicCell t = cell_above(guess);
    const Integer value = polynomial_.scaled_value(t);
    const int side = value.sign() * sign_before_;
    if (side == 0) {
      is_exact_ = true;
      cell_ = std::move(t);
      return;
    }
    (side > 0 ? lower : upper) = guess;
    const double next = guess + newton_step(value, derivative, t);
    guess = next != guess ? next : std::nextafter(guess, side > 0 ? 2.0 : -1.0);
  }
  cell_ = cell_above(lower);
}

AlgebraicTime::Bracket AlgebraicTime::bracket() {
  narrow_to_doubles();
  const double lower = lower_end(cell_);
  return {lower, is_exact_ && lower_end_is_double(cell_) ? lower : next_up(lower)};
}

}  // namespace tamis
