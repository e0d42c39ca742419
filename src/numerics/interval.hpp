// Interval arithmetic with outward rounding, without changing the rounding mode.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

namespace tamis {

namespace rounding {

/// At most the predecessor, at least the second predecessor of x, for finite x (Rump, Zimmermann, Boldo, Melquiond
/// 2009): one multiplication and two additions instead of a library call. -inf stays; NaN stays.
inline double below(double x) {
  constexpr double kUlp = 0x1p-53 * (1 + 0x1p-52), kTiny = std::numeric_limits<double>::denorm_min();
  return x - (kUlp * std::fabs(x) + kTiny);
}
inline double above(double x) { return -below(-x); }

}  // namespace rounding

/// A closed interval that contains the true value. After overflow a bound may be NaN: then every certain comparison is
/// false, so nothing is proven.
struct Interval {
  double lower = 0, upper = 0;

  Interval() = default;
  Interval(double value) : lower(value), upper(value) {}
  Interval(double low, double high) : lower(low), upper(high) {}

  double width() const { return upper - lower; }
  double middle() const { return 0.5 * lower + 0.5 * upper; }
  /// False only if proven.
  bool may_be_zero() const { return !(lower > 0 || upper < 0); }
};

inline Interval operator-(const Interval& a) { return {-a.upper, -a.lower}; }
inline Interval operator+(const Interval& a, const Interval& b) {
  return {rounding::below(a.lower + b.lower), rounding::above(a.upper + b.upper)};
}
inline Interval operator-(const Interval& a, const Interval& b) { return a + -b; }

inline Interval operator*(const Interval& a, const Interval& b) {
  const double p = a.lower * b.lower, q = a.lower * b.upper, r = a.upper * b.lower, s = a.upper * b.upper;
  // A sum of all four is NaN if one of them is: min and max alone could drop it.
  if (std::isnan(p + q + r + s))
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  return {rounding::below(std::min(std::min(p, q), std::min(r, s))),
          rounding::above(std::max(std::max(p, q), std::max(r, s)))};
}

/// REQUIRES: !b.may_be_zero().
inline Interval operator/(const Interval& a, const Interval& b) {
  if (b.upper < 0) return -a / -b;
  return {rounding::below(a.lower / (a.lower < 0 ? b.lower : b.upper)),
          rounding::above(a.upper / (a.upper < 0 ? b.upper : b.lower))};
}

/// True only if proven.
inline bool operator>(const Interval& a, const Interval& b) { return a.lower > b.upper; }
inline bool operator<(const Interval& a, const Interval& b) { return a.upper < b.lower; }

/// Empty (lower > upper) if they have nothing in common.
inline Interval intersection(const Interval& a, const Interval& b) {
  return {std::max(a.lower, b.lower), std::min(a.upper, b.upper)};
}

}  // namespace tamis
