// Polynomials in t of degree <= 6 with integer coefficients. The exact decision computes with nothing else.
#pragma once
#include <array>
#include <cstddef>

#include "numbers/assert.hpp"
#include "numbers/dyadic_cell.hpp"

namespace tamis {

class IntegerPolynomial {
 public:
  static constexpr int kMaxDegree = 6;

  /// The zero polynomial.
  IntegerPolynomial() = default;
  explicit IntegerPolynomial(const Integer& constant) {
    powers_[0] = constant;
    find_degree(0);
  }
  /// From Bernstein coefficients without their binomials, as pair/motion/polynomials.hpp gives them.
  template <std::size_t N>
  static IntegerPolynomial from_bernstein(std::array<Integer, N> coefficients);

  /// -1 for the zero polynomial.
  int degree() const { return degree_; }
  bool is_zero() const { return degree_ < 0; }
  /// The coefficient of t^i. REQUIRES: 0 <= i <= kMaxDegree.
  const Integer& operator[](int i) const {
    TAMIS_ASSERT(0 <= i && i <= kMaxDegree);
    return powers_[static_cast<std::size_t>(i)];
  }

  /// 2^(k degree) times the value at the lower end of the cell.
  Integer scaled_value(const DyadicCell& at) const;
  /// The sign of the value at the lower end of the cell: -1, 0 or 1.
  int sign_at(const DyadicCell& at) const { return scaled_value(at).sign(); }
  /// The sign of the values just after t = 0.
  int sign_after_zero() const;

  /// The number of sign variations of the Bernstein coefficients on [0,1]. By Descartes' rule at least the number of
  /// roots in the open interval, counted with multiplicity, and of the same parity.
  int sign_variations() const;

  /// The polynomial with the cell mapped to [0,1], times a positive constant.
  IntegerPolynomial on(const DyadicCell& cell) const;

  /// REQUIRES: the degree of the result is at most kMaxDegree.
  friend IntegerPolynomial operator+(const IntegerPolynomial& a, const IntegerPolynomial& b);
  friend IntegerPolynomial operator-(const IntegerPolynomial& a, const IntegerPolynomial& b);
  friend IntegerPolynomial operator*(const IntegerPolynomial& a, const IntegerPolynomial& b);
  friend IntegerPolynomial operator*(const Integer& a, const IntegerPolynomial& b);

  IntegerPolynomial derivative() const;
  /// A polynomial with the same roots, all of them simple. REQUIRES: not zero.
  IntegerPolynomial squarefree_part() const;

  /// A greatest common divisor, primitive. REQUIRES: neither is zero.
  friend IntegerPolynomial greatest_common_divisor(IntegerPolynomial a, IntegerPolynomial b);

 private:
  Integer& at(int i) { return powers_[static_cast<std::size_t>(i)]; }
  /// Finds the degree after coefficients have changed. REQUIRES: it is no more than `at_most`.
  void find_degree(int at_most);
  void shift_by(const Integer& n);
  void divide_by_content();
  /// Becomes the remainder, modulo b, of this polynomial times a power of b's leading coefficient, less powers of two.
  void reduce_modulo(const IntegerPolynomial& b);
  IntegerPolynomial divided_exactly_by(const IntegerPolynomial& primitive_divisor) const;

  std::array<Integer, kMaxDegree + 1> powers_;
  int degree_ = -1;
};

/// A quick proof that two polynomials have no common factor. True only if they have none modulo a prime that divides
/// neither leading coefficient. Such a prime does not divide the leading coefficient of a common factor either, so the
/// factor keeps its degree. REQUIRES: neither is zero.
bool are_surely_coprime(const IntegerPolynomial& a, const IntegerPolynomial& b);

template <std::size_t N>
IntegerPolynomial IntegerPolynomial::from_bernstein(std::array<Integer, N> b) {
  static_assert(N <= kMaxDegree + 1);
  // sum b_i t^i (1-t)^(n-i) in powers: the Taylor shift by -1 of the coefficients in reverse order.
  for (std::size_t last = N - 1; last > 0; --last)
    for (std::size_t i = 1; i <= last; ++i) b[i] -= b[i - 1];
  IntegerPolynomial p;
  for (std::size_t i = 0; i < N; ++i) p.powers_[i] = std::move(b[i]);
  p.find_degree(static_cast<int>(N) - 1);
  return p;
}

}  // namespace tamis
