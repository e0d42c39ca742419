// Interval arithmetic with outward rounding, without changing the rounding mode. On double and double-double. Other
// number types that wrap double, such as one that counts operations, run the same lines.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers/assert.hpp"
#include "numbers/double_double.hpp"
#include "numbers/platform.hpp"
#include "numbers/scale.hpp"
#include "numbers/select.hpp"
#include "numbers/vec.hpp"

namespace tamis {

namespace rounding {

/// x moved down: at most the predecessor and at least the second predecessor of x, for finite x (Rump, Zimmermann,
/// Boldo, Melquiond 2009). So the result is at or below the number that was rounded to x. Takes one multiplication and
/// two additions instead of a library call. -inf stays; NaN stays.
template <class T>
inline T below(const T& x) {
  constexpr double kUlp = 0x1p-53 * (1 + 0x1p-52), kTiny = std::numeric_limits<double>::denorm_min();
  return x - (T(kUlp) * abs(x) + T(kTiny));
}
/// Operations are off by at most 2^-100 of themselves, the subtraction here by 2^-104 of x. In doubles kUlp of the high
/// part is more than both together. kTiny is far above what underflows.
inline DoubleDouble below(const DoubleDouble& x) {
  constexpr double kUlp = 0x1p-99, kTiny = error_bounds::underflow<DoubleDouble>;
  return x - (kUlp * std::fabs(x.high) + kTiny);
}
template <class T>
inline T above(const T& x) {
  return -below(-x);
}
/// below() for a sum, except that zero stays zero. A sum that is zero is exact in double and in double-double, because
/// sums are off by a part of themselves. (So is a product with an exact zero.) Moved down, zero would become a denormal
/// number, and so would products with it. Processors take a hundred times as long for these.
template <class T>
inline T sum_below(const T& x) {
  return select(x == T(0), x, below(x));
}
template <class T>
inline T sum_above(const T& x) {
  return -sum_below(-x);
}

}  // namespace rounding

/// A closed interval that contains the true value. After overflow a bound may be NaN. Then every certain comparison is
/// false, so nothing is proven.
template <class T>
struct BasicInterval {
  T lower = T(0), upper = T(0);

  BasicInterval() = default;
  BasicInterval(const T& value) : lower(value), upper(value) {}
  /// REQUIRES: the ends in order, or NaN.
  BasicInterval(const T& low, const T& high) : lower(low), upper(high) { TAMIS_ASSERT(!(low > high)); }

  T width() const { return upper - lower; }
  T middle() const { return T(0.5) * lower + T(0.5) * upper; }
  bool is_zero() const { return lower == T(0) && upper == T(0); }
  /// False only if the value is proven not to be zero.
  bool may_be_zero() const { return !(lower > T(0) || upper < T(0)); }
};

using Interval = BasicInterval<double>;
using FineInterval = BasicInterval<DoubleDouble>;

template <class T>
inline BasicInterval<T> operator-(const BasicInterval<T>& a) {
  return {-a.upper, -a.lower};
}
template <class T>
inline BasicInterval<T> operator+(const BasicInterval<T>& a, const BasicInterval<T>& b) {
  return {rounding::sum_below(a.lower + b.lower), rounding::sum_above(a.upper + b.upper)};
}
template <class T>
inline BasicInterval<T> operator-(const BasicInterval<T>& a, const BasicInterval<T>& b) {
  return a + -b;
}

/// Forced inline: paths take hundreds of these, and compilers would call it.
template <class T>
TAMIS_ALWAYS_INLINE BasicInterval<T> operator*(const BasicInterval<T>& a, const BasicInterval<T>& b) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const T p = a.lower * b.lower, s = a.upper * b.upper;
  if ((a.is_zero() || b.is_zero()) && p == T(0) && s == T(0)) return {};
  if (a.lower >= T(0) && b.lower >= T(0) && s < T(kInfinity)) return {rounding::below(p), rounding::above(s)};
  const T q = a.lower * b.upper, r = a.upper * b.lower;
  // Infinity times zero: min and max could drop the NaN.
  const bool has_nan = p != p || q != q || r != r || s != s;  // NOLINT(misc-redundant-expression)
  if (has_nan) return {T(-kInfinity), T(kInfinity)};
  return {rounding::below(min(min(p, q), min(r, s))), rounding::above(max(max(p, q), max(r, s)))};
}

/// REQUIRES: !b.may_be_zero().
template <class T>
inline BasicInterval<T> operator/(const BasicInterval<T>& a, const BasicInterval<T>& b) {
  TAMIS_ASSERT(!b.may_be_zero());
  if (a.is_zero()) return {};
  if (b.upper < T(0)) return -a / -b;
  return {rounding::below(a.lower / (a.lower < T(0) ? b.lower : b.upper)),
          rounding::above(a.upper / (a.upper < T(0) ? b.upper : b.lower))};
}

/// True only if proven.
template <class T>
inline bool operator>(const BasicInterval<T>& a, const BasicInterval<T>& b) {
  return a.lower > b.upper;
}
template <class T>
inline bool operator<(const BasicInterval<T>& a, const BasicInterval<T>& b) {
  return a.upper < b.lower;
}

/// True if the vector is exactly zero.
template <class T>
inline bool is_zero(const Vec3<BasicInterval<T>>& v) {
  return v.x.is_zero() && v.y.is_zero() && v.z.is_zero();
}

/// |v|, rounded up; infinite only where it may be beyond the largest double.
inline double length_above(const Vec3<BasicInterval<double>>& v) {
  if (is_zero(v)) return 0;
  double size = 0;
  for (const Interval& x : {v.x, v.y, v.z}) size = std::max({size, std::fabs(x.lower), std::fabs(x.upper)});
  const double scale = scale_below_one(size);
  const auto scaled = [&](const Interval& x) { return Interval{x.lower * scale, x.upper * scale}; };
  const Vec3<Interval> w{scaled(v.x), scaled(v.y), scaled(v.z)};
  return rounding::above(rounding::above(std::sqrt(dot(w, w).upper)) / scale);
}

namespace error_bounds {
/// Intervals hold their own rounding, so certificates add nothing for it.
template <class T>
inline constexpr double unit_roundoff<BasicInterval<T>> = 0;
template <class T>
inline constexpr double underflow<BasicInterval<T>> = 0;
}  // namespace error_bounds

}  // namespace tamis
