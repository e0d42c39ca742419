// An integer polynomial in doubles with room for any exponent, in the odds s = t / (1 - t) of its time: its roots in
// (0,1), where their distances from 0 and 1 differ by far, and its sign beside such a root.
//
// p(t) = (1-t)^n times the sum of b_i s^i, b_i being the Bernstein coefficients without their binomials. While one term
// outweighs all those of the other sign, p has no root; while one outweighs those of the other sign in the derivative
// of p / s^i, at most one. Newton's polygon, the convex hull of the exponents, tells which terms these are, and from
// where to where. Proofs: docs/numerics.md.
#pragma once
#include <vector>

#include "exact/integer_polynomial.hpp"
#include "exact/odds.hpp"
#include "numerics/wide_double.hpp"

namespace tamis {

class OddsPolynomial {
 public:
  /// REQUIRES: not zero.
  explicit OddsPolynomial(const IntegerPolynomial& p);

  /// Of the values at all odds from low to high: -1 or 1; 0 if not certain.
  int sign_between(const Odds& low, const Odds& high) const;

  /// Adds all roots in the open interval (0,1), ascending. False if not certain.
  bool find_roots(std::vector<OddsBracket>& roots) const;

 private:
  const WideDouble& at(int i) const { return coefficients_[static_cast<std::size_t>(i)]; }
  /// Where the terms i < j are equally large: the exponent of s, to 1.
  double meeting(int i, int j) const;
  /// Of Newton's polygon, after the corner i. REQUIRES: i < last_.
  int next_corner(int i) const;
  /// At every s from 2^low to 2^high the term i outweighs those of the other sign together.
  bool rules(int i, long low, long high) const;
  /// The derivative of p / s^i, times s^(i+1).
  OddsPolynomial slope_over_power(int i) const;
  OddsBracket narrowed(OddsBracket bracket) const;

  std::array<WideDouble, IntegerPolynomial::kMaxDegree + 1> coefficients_;
  int first_ = 0, last_ = 0;  ///< of the coefficients that are not zero
};

}  // namespace tamis
