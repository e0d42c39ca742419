#include "oracle/polynomial.hpp"

#include <algorithm>
#include <cmath>

namespace tamis::oracle {

Polynomial::Polynomial(std::vector<Integer> coefficients) : coefficients_(std::move(coefficients)) {
  while (!coefficients_.empty() && coefficients_.back().sign() == 0) coefficients_.pop_back();
}

int Polynomial::sign_at(const Rational& t) const {
  // Horner's scheme on the numerator of the value over denominator^degree.
  Integer value = 0, power = 1;
  for (std::size_t i = coefficients_.size(); i-- > 0;) {
    value = value * numerator(t) + coefficients_[i] * power;
    power *= denominator(t);
  }
  return value.sign();
}

std::vector<Integer> Polynomial::bernstein_coefficients() const {
  // Multiplies each power t^i by ((1-t) + t)^(n-i): c_i becomes the coefficient of t^i (1-t)^(n-i).
  std::vector<Integer> c = coefficients_;
  for (std::size_t k = 1; k < c.size(); ++k)
    for (std::size_t j = k; j > 0; --j) c[j] += c[j - 1];
  return c;
}

Signs Polynomial::signs_on_unit_interval() const {
  if (is_zero()) return {false, true, false};
  Signs signs;
  for (const Integer& c : bernstein_coefficients())
    (c.sign() < 0 ? signs.negative : c.sign() > 0 ? signs.positive : signs.zero) = true;
  return signs;
}

bool Polynomial::changes_sign_once() const {
  const auto c = bernstein_coefficients();
  if (c.front().sign() == 0 || c.back().sign() == 0) return false;
  int last = c.front().sign(), changes = 0;
  for (const Integer& x : c) {
    if (x.sign() == -last) ++changes;
    if (x.sign() != 0) last = x.sign();
  }
  return changes == 1;
}

bool Polynomial::never_vanishes_on_unit_interval() const {
  const Signs signs = signs_on_unit_interval();
  return !signs.zero && signs.negative != signs.positive;
}

Polynomial Polynomial::on_part(const Integer& n, unsigned k) const {
  std::vector<Integer> c = coefficients_;
  for (std::size_t i = 0; i + 1 < c.size(); ++i) c[i] <<= k * (c.size() - 1 - i);
  for (std::size_t i = 0; i < c.size(); ++i)
    for (std::size_t j = c.size() - 1; j > i; --j) c[j - 1] += n * c[j];
  return Polynomial(std::move(c));
}

double Polynomial::approximate_root() const {
  // Converts the coefficients to doubles, divided by one power of two that keeps them in range.
  constexpr unsigned kMostBits = 1000;
  unsigned bits = 0;
  for (const Integer& c : coefficients_)
    if (c != 0) bits = std::max(bits, static_cast<unsigned>(msb(abs(c))));
  const unsigned excess = bits > kMostBits ? bits - kMostBits : 0;
  std::vector<double> c;
  for (const Integer& x : coefficients_) c.push_back(static_cast<double>(Integer(x >> excess)));
  const auto value = [&](double t) {
    double sum = 0;
    for (std::size_t i = c.size(); i-- > 0;) sum = sum * t + c[i];
    return sum;
  };
  double low = 0, high = 1;
  for (int step = 0; step < 52; ++step) {
    const double middle = 0.5 * (low + high);
    ((value(middle) > 0) == (c[0] > 0) ? low : high) = middle;
  }
  return low;
}

Polynomial Polynomial::derivative() const {
  std::vector<Integer> result;
  for (std::size_t i = 1; i < coefficients_.size(); ++i) result.push_back(coefficients_[i] * i);
  return Polynomial(std::move(result));
}

Polynomial Polynomial::without_roots_at_ends() const {
  std::vector<Integer> c = coefficients_;
  while (c.front().sign() == 0) c.erase(c.begin());
  while (Polynomial(c).sign_at(1) == 0) {
    // Horner's scheme at 1: the partial sums from the top are the quotient, the last one is the remainder 0.
    for (std::size_t i = c.size() - 1; i-- > 0;) c[i] += c[i + 1];
    c.erase(c.begin());
  }
  return Polynomial(std::move(c));
}

Polynomial Polynomial::primitive() const {
  Integer divisor = 0;
  for (const Integer& c : coefficients_) divisor = gcd(divisor, c);
  if (divisor <= 1) return *this;
  std::vector<Integer> result = coefficients_;
  for (Integer& c : result) c /= divisor;
  return Polynomial(std::move(result));
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  std::vector<Integer> result(std::max(a.degree(), b.degree()) + 1);
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (i <= a.degree()) result[i] += a[i];
    if (i <= b.degree()) result[i] += b[i];
  }
  return Polynomial(std::move(result));
}

Polynomial operator-(const Polynomial& a) {
  if (a.is_zero()) return a;
  std::vector<Integer> result(a.degree() + 1);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = -a[i];
  return Polynomial(std::move(result));
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) { return a + -b; }

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  if (a.is_zero() || b.is_zero()) return {};
  std::vector<Integer> result(a.degree() + b.degree() + 1);
  for (std::size_t i = 0; i <= a.degree(); ++i)
    for (std::size_t j = 0; j <= b.degree(); ++j) result[i + j] += a[i] * b[j];
  return Polynomial(std::move(result));
}

Polynomial remainder(const Polynomial& a, const Polynomial& b) {
  Polynomial rest = a;
  const Integer scale = abs(b.leading());
  while (!rest.is_zero() && rest.degree() >= b.degree()) {
    const std::size_t shift = rest.degree() - b.degree();
    const Integer factor = b.leading().sign() > 0 ? rest.leading() : Integer(-rest.leading());
    std::vector<Integer> next(rest.degree());  // the leading coefficient cancels
    for (std::size_t i = 0; i < next.size(); ++i) {
      next[i] = scale * rest[i];
      if (i >= shift) next[i] -= factor * b[i - shift];
    }
    rest = Polynomial(std::move(next));
  }
  return rest;
}

}  // namespace tamis::oracle
