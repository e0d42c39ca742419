// An integer polynomial in doubles with exponents of their own: its sign where rounding leaves that certain, and a
// value for Newton's method. Most signs of an exact decision are certain so; only the others need integers.
#pragma once
#include "numbers/integer_polynomial.hpp"
#include "numbers/wide_double.hpp"

namespace tamis {

class ApproximatePolynomial {
 public:
  explicit ApproximatePolynomial(const IntegerPolynomial& p);
  ApproximatePolynomial derivative() const;

  /// value 2^exponent, off by at most error 2^exponent.
  struct Value {
    double value = 0, error = 0;
    int exponent = 0;
    /// 0 if not certain.
    int sign() const { return value > error ? 1 : value < -error ? -1 : 0; }
  };
  /// The value at every time from t to the next double. REQUIRES: 0 <= t <= 1.
  Value near(double t) const;

 private:
  ApproximatePolynomial() = default;

  std::array<WideDouble, IntegerPolynomial::kMaxDegree + 1> powers_;
  int degree_ = -1;
};

}  // namespace tamis
