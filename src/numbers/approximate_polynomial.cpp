#include "numbers/approximate_polynomial.hpp"

#include <algorithm>
#include <climits>
#include <cmath>
#include <limits>

#include "numbers/assert.hpp"

namespace tamis {

ApproximatePolynomial::ApproximatePolynomial(const IntegerPolynomial& p) : degree_(p.degree()) {
  for (int i = 0; i <= degree_; ++i) powers_[static_cast<std::size_t>(i)] = WideDouble::of(p[i]);
}

ApproximatePolynomial ApproximatePolynomial::derivative() const {
  ApproximatePolynomial result;
  result.degree_ = std::max(degree_ - 1, -1);
  for (int i = 1; i <= degree_; ++i) {
    const WideDouble& c = powers_[static_cast<std::size_t>(i)];
    result.powers_[static_cast<std::size_t>(i) - 1] = {i * c.mantissa, c.exponent};
  }
  return result;
}

ApproximatePolynomial::Value ApproximatePolynomial::near(double t) const {
  TAMIS_ASSERT(0 <= t && t <= 1);
  if (t < std::numeric_limits<double>::min()) return {};  // not certain: the next double is many times as large
  int time_exponent = 0;
  const double time = std::frexp(t, &time_exponent);
  double terms[IntegerPolynomial::kMaxDegree + 1], power = 1;
  int exponents[IntegerPolynomial::kMaxDegree + 1], highest = INT_MIN;
  for (int i = 0; i <= degree_; ++i, power *= time) {
    const WideDouble& c = powers_[static_cast<std::size_t>(i)];
    terms[i] = c.mantissa * power;
    exponents[i] = c.exponent + time_exponent * i;
    if (c.mantissa != 0) highest = std::max(highest, exponents[i]);
  }
  double sum = 0, size = 0;
  for (int i = 0; i <= degree_; ++i) {
    if (terms[i] == 0) continue;
    const double value = times_power_of_two(terms[i], exponents[i] - highest);
    sum += value;
    size += std::fabs(value);
  }
  // A term is off by 2 u for its coefficient, 5 u for the power, 1 u for the product, 6 * 2 u for its change up to the
  // next double. Six sums add 6 u. In all below 32 u; 64 u are given, which covers the loss of terms 2^-900 below the
  // largest.
  return {sum, 0x1p-47 * size, highest};
}

}  // namespace tamis
