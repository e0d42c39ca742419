// Polynomials in one variable with integer coefficients of any size: the oracle's only arithmetic.
#pragma once
#include <vector>

#include "oracle/exact_numbers.hpp"

namespace tamis::oracle {

/// Which signs occur among some numbers.
struct Signs {
  bool negative = false, zero = false, positive = false;
};

/// Coefficient i belongs to t^i. The zero polynomial has none; otherwise the last one is not zero.
class Polynomial {
 public:
  Polynomial() = default;
  explicit Polynomial(std::vector<Integer> coefficients);

  bool is_zero() const { return coefficients_.empty(); }
  std::size_t degree() const { return coefficients_.size() - 1; }
  const Integer& operator[](std::size_t i) const { return coefficients_[i]; }
  const Integer& leading() const { return coefficients_.back(); }

  int sign_at(const Rational& t) const;
  /// Signs of the Bernstein coefficients. The values on [0,1] are averages of these: other signs do not occur.
  Signs signs_on_unit_interval() const;
  /// True only if the signs of the Bernstein coefficients prove it.
  bool never_vanishes_on_unit_interval() const;
  /// Do the Bernstein coefficients change sign once? Then [0,1] holds exactly one root, a simple one in its interior
  /// (Descartes).
  bool changes_sign_once() const;
  /// The polynomial with the part [n, n+1] / 2^k of [0,1] mapped to [0,1], times a power of two.
  Polynomial on_part(const Integer& n, unsigned k) const;
  /// A time near a root in (0,1), by bisection in doubles; not certain. REQUIRES: the values at 0 and 1 differ in sign.
  double approximate_root() const;
  Polynomial derivative() const;
  /// Divides by t and by t - 1 until neither end of [0,1] is a root. REQUIRES: not zero.
  Polynomial without_roots_at_ends() const;
  /// Divides by the greatest common divisor of the coefficients: same roots, same signs, smaller numbers.
  Polynomial primitive() const;

 private:
  std::vector<Integer> bernstein_coefficients() const;

  std::vector<Integer> coefficients_;
};

Polynomial operator+(const Polynomial& a, const Polynomial& b);
Polynomial operator-(const Polynomial& a);
Polynomial operator-(const Polynomial& a, const Polynomial& b);
Polynomial operator*(const Polynomial& a, const Polynomial& b);

/// A positive multiple of the remainder of `a` divided by `b`. REQUIRES: `b` is not zero.
Polynomial remainder(const Polynomial& a, const Polynomial& b);

}  // namespace tamis::oracle
