// A time in [0,1] that is a root of an integer polynomial, and the signs of other polynomials at it.
#pragma once
#include "numbers/integer_polynomial.hpp"
#include "pair/motion/time_clip.hpp"

namespace tamis {

class AlgebraicTime {
 public:
  /// The time at the lower end of the cell `time`.
  static AlgebraicTime exactly(DyadicCell time);
  /// The root of `p` inside of the cell. REQUIRES: `sign_before`, not 0, is the sign of `p` just after the lower end of
  /// the cell. REQUIRES (not checked: exact): exactly one root of `p` lies inside of the cell, a simple one.
  AlgebraicTime(IntegerPolynomial p, int sign_before, DyadicCell cell);

  /// The sign of `q` at this time: -1, 0 or 1, decided exactly. Narrows the cell as far as that needs.
  int sign_of(const IntegerPolynomial& q);

  /// -1, 0 or 1 as `a` comes before `b`, is the same time or comes after it. Decided exactly. Narrows both cells as far
  /// as that needs.
  friend int compare(AlgebraicTime& a, AlgebraicTime& b);
  /// A time strictly between the two, as the lower end of the cell. REQUIRES (not checked: exact): `a` before `b`.
  friend DyadicCell time_between(AlgebraicTime& a, AlgebraicTime& b);

  /// Largest double <= this time, smallest double >= it.
  TimeInterval<double> bracket() const;

 private:
  explicit AlgebraicTime(DyadicCell time) : cell_(std::move(time)), is_exact_(true) {}

  /// The upper end of the cell, as the lower end of another: after the time, or the time itself if it is exact.
  DyadicCell upper_end() const { return is_exact_ ? cell_ : DyadicCell{cell_.n + 1, cell_.k}; }
  static bool are_equal(const AlgebraicTime& a, const AlgebraicTime& b);
  /// Refines the time in the wider cell. If both were refined, the bits of one would double in each of the many steps
  /// that the other may take. REQUIRES: not both are exact.
  static void narrow(AlgebraicTime& a, AlgebraicTime& b);
  /// If so, the greatest common divisor becomes the polynomial.
  bool is_root_of(const IntegerPolynomial& q);
  void halve();
  /// Makes the cell smaller, quadratically (Abbott 2006). A straight line through the values at its ends tells which of
  /// 2^refinement_ smaller cells may hold the root. If signs confirm it, refinement_ doubles; else it is halved.
  void refine();
  /// Makes the cell one between neighbouring doubles, or exact. REQUIRES: 0 <= lower < upper <= 1.
  void narrow_to_doubles(double lower, double upper);

  IntegerPolynomial polynomial_;
  int sign_before_ = 0;  ///< the polynomial's sign between the lower end of the cell and the root
  DyadicCell cell_;
  bool is_exact_ = false;
  int refinement_ = 8;
};

}  // namespace tamis
