// The side of a line on which a point of the plane lies, decided exactly.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace tamis::io {

using PlanePoint = std::array<double, 2>;

/// The sign of a sum of doubles, without rounding: an expansion of doubles that do not overlap (Shewchuk 1997).
/// REQUIRES (not checked: hot): no overflow.
class ExactSum {
 public:
  void add(double x) {
    std::size_t kept = 0;
    for (const double term : terms_) {
      const double sum = x + term, part = sum - x;
      const double error = (x - (sum - part)) + (term - part);
      if (error != 0) terms_[kept++] = error;
      x = sum;
    }
    terms_.resize(kept);
    if (x != 0) terms_.push_back(x);
  }
  /// Adds a b. Exact unless the product's last bit is below the least double.
  void add_product(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }
  int sign() const { return terms_.empty() ? 0 : terms_.back() > 0 ? 1 : -1; }

 private:
  std::vector<double> terms_;  ///< the largest last
};

/// 1 if c lies to the left of the line from a to b, -1 to the right, 0 on it. Doubles decide the clear cases: their
/// error is below 3.5 ulp of the two products' sum (Shewchuk 1997, ccwerrboundA). REQUIRES (not checked: hot): no
/// coordinate beyond 2^500.
inline int side_of(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  const double left = (a[0] - c[0]) * (b[1] - c[1]), right = (a[1] - c[1]) * (b[0] - c[0]);
  const double difference = left - right;
  constexpr double kError = 4 * std::numeric_limits<double>::epsilon(), kUnderflow = 1e-290;
  if (std::abs(difference) > kError * (std::abs(left) + std::abs(right)) + kUnderflow) return difference > 0 ? 1 : -1;
  ExactSum sum;
  sum.add_product(a[0], b[1]);
  sum.add_product(-a[1], b[0]);
  sum.add_product(b[0], c[1]);
  sum.add_product(-b[1], c[0]);
  sum.add_product(c[0], a[1]);
  sum.add_product(-c[1], a[0]);
  return sum.sign();
}

}  // namespace tamis::io
