// Polynomials in one variable with integer coefficients of any size: the oracle's only arithmetic.
#pragma once
#include <gmpxx.h>

#include <vector>

namespace tamis::oracle {

using Integer = mpz_class;
using Rational = mpq_class;

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
  Polynomial derivative() const;
  /// Divides by t and by t - 1 until neither end of [0,1] is a root. REQUIRES: not zero.
  Polynomial without_roots_at_ends() const;
  /// Divides by the greatest common divisor of the coefficients: same roots, same signs, smaller numbers.
  Polynomial primitive() const;

 private:
  std::vector<Integer> coefficients_;
};

Polynomial operator+(const Polynomial& a, const Polynomial& b);
Polynomial operator-(const Polynomial& a);
Polynomial operator-(const Polynomial& a, const Polynomial& b);
Polynomial operator*(const Polynomial& a, const Polynomial& b);

/// A positive multiple of the remainder of `a` divided by `b`. REQUIRES: `b` is not zero.
Polynomial remainder(const Polynomial& a, const Polynomial& b);

}  // namespace tamis::oracle
