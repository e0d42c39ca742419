#include "numbers/integer_polynomial.hpp"

#include <algorithm>
#include <utility>

#include "numbers/assert.hpp"

namespace tamis {

void IntegerPolynomial::find_degree(int at_most) {
  degree_ = at_most;
  while (degree_ >= 0 && at(degree_).sign() == 0) --degree_;
}

Integer IntegerPolynomial::scaled_value(const DyadicCell& t) const {
  if (is_zero()) return 0;
  if (t.n.sign() == 0) return (*this)[0] << (t.k * degree_);
  Integer value = (*this)[degree_];
  for (int i = degree_ - 1; i >= 0; --i) {
    value *= t.n;
    value += (*this)[i] << (t.k * (degree_ - i));
  }
  return value;
}

int IntegerPolynomial::sign_after_zero() const {
  for (int i = 0; i <= degree_; ++i)
    if (const int sign = (*this)[i].sign()) return sign;
  return 0;
}

int IntegerPolynomial::sign_variations() const {
  // The Taylor shift by 1 of the powers' coefficients in reverse order.
  auto coefficients = powers_;
  for (std::size_t last = static_cast<std::size_t>(std::max(degree_, 0)); last > 0; --last)
    for (std::size_t i = 1; i <= last; ++i) coefficients[i] += coefficients[i - 1];
  int variations = 0, previous = 0;
  for (int i = 0; i <= degree_; ++i) {
    const int sign = coefficients[static_cast<std::size_t>(i)].sign();
    if (sign == 0) continue;
    if (sign == -previous) ++variations;
    previous = sign;
  }
  return variations;
}

void IntegerPolynomial::shift_by(const Integer& n) {
  for (int first = 0; first < degree_; ++first)
    for (int i = degree_ - 1; i >= first; --i) at(i) += n * at(i + 1);
}

IntegerPolynomial IntegerPolynomial::on(const DyadicCell& cell) const {
  IntegerPolynomial p = *this;
  if (cell.k > 0)
    for (int i = 0; i < degree_; ++i) p.at(i) <<= cell.k * (degree_ - i);
  if (cell.n.sign() != 0) p.shift_by(cell.n);
  return p;
}

IntegerPolynomial operator+(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  IntegerPolynomial sum = a.degree_ < b.degree_ ? b : a;
  const IntegerPolynomial& other = a.degree_ < b.degree_ ? a : b;
  for (int i = 0; i <= other.degree_; ++i) sum.at(i) += other[i];
  sum.find_degree(sum.degree_);
  return sum;
}

IntegerPolynomial operator-(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  IntegerPolynomial difference = a;
  for (int i = 0; i <= b.degree_; ++i) difference.at(i) -= b[i];
  difference.find_degree(std::max(a.degree_, b.degree_));
  return difference;
}

IntegerPolynomial operator*(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  TAMIS_ASSERT(a.degree_ + b.degree_ <= IntegerPolynomial::kMaxDegree);
  IntegerPolynomial product;
  for (int i = 0; i <= a.degree_; ++i)
    for (int j = 0; j <= b.degree_; ++j) product.at(i + j) += a[i] * b[j];
  product.degree_ = a.is_zero() || b.is_zero() ? -1 : a.degree_ + b.degree_;
  return product;
}

IntegerPolynomial operator*(const Integer& a, const IntegerPolynomial& b) { return IntegerPolynomial(a) * b; }

IntegerPolynomial IntegerPolynomial::derivative() const {
  IntegerPolynomial p;
  for (int i = 1; i <= degree_; ++i) p.at(i - 1) = (*this)[i] * i;
  p.degree_ = std::max(degree_ - 1, -1);
  return p;
}

void IntegerPolynomial::divide_by_content() {
  Integer content;
  for (int i = 0; i <= degree_; ++i) content = greatest_common_divisor(content, at(i));
  for (int i = 0; i <= degree_; ++i) at(i) = quotient(at(i), content);
}

void IntegerPolynomial::reduce_modulo(const IntegerPolynomial& b) {
  while (degree_ >= b.degree_) {
    const Integer leading = at(degree_);
    const int shift = degree_ - b.degree_;
    for (int i = 0; i < degree_; ++i) {
      at(i) *= b[b.degree_];
      if (i >= shift) at(i) -= leading * b[i - shift];
    }
    at(degree_) = 0;
    find_degree(degree_ - 1);
  }
  if (!is_zero()) divide_by_content();
}

IntegerPolynomial greatest_common_divisor(IntegerPolynomial a, IntegerPolynomial b) {
  TAMIS_ASSERT(!a.is_zero() && !b.is_zero());
  if (are_surely_coprime(a, b)) return IntegerPolynomial(1);
  if (a.degree_ < b.degree_) std::swap(a, b);
  while (!b.is_zero() && b.degree_ > 0) {
    a.reduce_modulo(b);
    std::swap(a, b);
  }
  // b is zero, or a constant other than zero.
  IntegerPolynomial& divisor = b.is_zero() ? a : b;
  divisor.divide_by_content();
  return std::move(divisor);
}

IntegerPolynomial IntegerPolynomial::divided_exactly_by(const IntegerPolynomial& b) const {
  IntegerPolynomial rest = *this, result;
  for (int shift = degree_ - b.degree_; shift >= 0; --shift) {
    result.at(shift) = quotient(rest[shift + b.degree_], b[b.degree_]);
    for (int i = 0; i <= b.degree_; ++i) rest.at(shift + i) -= result[shift] * b[i];
  }
  result.degree_ = degree_ - b.degree_;
  return result;
}

IntegerPolynomial IntegerPolynomial::squarefree_part() const {
  TAMIS_ASSERT(!is_zero());
  if (degree_ < 2) return *this;
  const IntegerPolynomial repeated = greatest_common_divisor(*this, derivative());
  return repeated.degree() == 0 ? *this : divided_exactly_by(repeated);
}

}  // namespace tamis
