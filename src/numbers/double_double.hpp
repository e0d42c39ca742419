// Double-double numbers: the unevaluated sum of two doubles, about 106 bits. Used where doubles are too coarse, on
// curves and in straight motion, by the same templates. No FMA. A product is split as Dekker does, so every machine
// gives the same bits.
//
// Error bounds after Joldes, Muller, Popescu, Tight and rigorous error bounds for basic building blocks of double-word
// arithmetic (ACM TOMS 44, 2017). With u = 2^-53 they are: sum 3 u^2 / (1 - 4 u) (theorem 3.1), with a double 2 u^2
// (algorithm 4), product 7 u^2 (theorem 5.1), all relative. The quotient is derived below. unit_roundoff is 2^-103 = 8
// u^2. They hold where nothing overflows or underflows. The solver's numbers are below 2^7. An underflow costs each of
// the 17 operations of a split product at most 2^-1075. The term `underflow` covers it.
#pragma once
#include "numbers/assert.hpp"
#include "numbers/error_bounds.hpp"
#include "numbers/platform.hpp"
#include "numbers/select.hpp"
#include "numbers/vec.hpp"

namespace tamis {

/// `high` is the sum of both, rounded: |low| <= ulp(high) / 2; unless something overflowed, or underflows. NaN and
/// infinity compare false, as in double.
struct DoubleDouble {
  double high = 0, low = 0;

  DoubleDouble() = default;
  constexpr DoubleDouble(double value) : high(value) {}
  /// REQUIRES: `high_part` is the sum of both, rounded. Not checked below 2^-968. There the 106 bits of a product reach
  /// below the smallest double. Rounding may make a low part too large by half a smallest double.
  constexpr DoubleDouble(double high_part, double low_part) : high(high_part), low(low_part) {
    TAMIS_ASSERT(high + low == high || abs_of(high) < 0x1p-968 || !(high - high == 0 && low - low == 0));
  }

  /// a + b, exactly (Knuth).
  static DoubleDouble sum_of(double a, double b) {
    const double sum = a + b, b_part = sum - a, a_part = sum - b_part;
    return {sum, (a - a_part) + (b - b_part)};
  }
  /// a b, exactly (Dekker, Veltkamp), where |a|, |b| < 2^995. Of larger ones the low part is NaN, which proves nothing.
  static DoubleDouble product_of(double a, double b) {
    const double product = a * b;
    const Halves x = halves(a), y = halves(b);
    return {product, ((x.high * y.high - product) + x.high * y.low + x.low * y.high) + x.low * y.low};
  }

 private:
  static constexpr double abs_of(double a) { return a < 0 ? -a : a; }
  struct Halves {
    double high, low;
  };
  /// Two numbers of 26 bits, whose products are exact.
  static Halves halves(double a) {
    const double shifted = a * 134217729.0;  // 2^27 + 1
    const double high = shifted - (shifted - a);
    return {high, a - high};
  }
};

namespace double_double {

/// a + b, exactly. REQUIRES: |a| >= |b|, or a = 0, or a is a multiple of the last digit of b. The last holds where two
/// numbers cancel that differ by no more than their low parts.
inline DoubleDouble ordered_sum(double a, double b) {
  const double sum = a + b, low = b - (sum - a);
  TAMIS_ASSERT(a == 0 || !(std::fabs(a) < std::fabs(b)) || low == DoubleDouble::sum_of(a, b).low);
  return {sum, low};
}

}  // namespace double_double

inline DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low}; }

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const auto s = DoubleDouble::sum_of(a.high, b.high), t = DoubleDouble::sum_of(a.low, b.low);
  const auto v = double_double::ordered_sum(s.high, s.low + t.high);
  return double_double::ordered_sum(v.high, t.low + v.low);
}
inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
inline DoubleDouble operator-(const DoubleDouble& a, double b) {
  const auto s = DoubleDouble::sum_of(a.high, -b);
  return double_double::ordered_sum(s.high, a.low + s.low);
}

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const auto c = DoubleDouble::product_of(a.high, b.high);
  return double_double::ordered_sum(c.high, c.low + (a.high * b.low + a.low * b.high));
}

/// Off by at most 32 u^2 = 2^-100 of itself. The remainder after the first quotient is below 4 u of a and off by 11 u^2
/// of a (a product, a difference). The second quotient is off by 3 u of the remainder. The sum is exact.
inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double first = a.high / b.high;
  const DoubleDouble rest = a - b * DoubleDouble(first);
  return double_double::ordered_sum(first, rest.high / b.high);
}

inline bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}
inline bool operator>(const DoubleDouble& a, const DoubleDouble& b) { return b < a; }
inline bool operator<=(const DoubleDouble& a, const DoubleDouble& b) {
  return a.high < b.high || (a.high == b.high && a.low <= b.low);
}
inline bool operator>=(const DoubleDouble& a, const DoubleDouble& b) { return b <= a; }
inline bool operator==(const DoubleDouble& a, const DoubleDouble& b) { return a.high == b.high && a.low == b.low; }

inline DoubleDouble select(bool mask, const DoubleDouble& yes, const DoubleDouble& no) { return mask ? yes : no; }
inline DoubleDouble min(const DoubleDouble& a, const DoubleDouble& b) { return b < a ? b : a; }
inline DoubleDouble max(const DoubleDouble& a, const DoubleDouble& b) { return a < b ? b : a; }
inline DoubleDouble abs(const DoubleDouble& a) { return a.high < 0 ? -a : a; }

template <>
struct Ratio<DoubleDouble> {
  static constexpr double kError = 0x1p-100;
  static DoubleDouble of(const DoubleDouble& a, const DoubleDouble& b) { return a / b; }
};

namespace error_bounds {
template <>
inline constexpr double unit_roundoff<DoubleDouble> = 0x1p-103;
}  // namespace error_bounds

/// Times a power of two: exact, where nothing underflows.
inline Vec3<DoubleDouble> scaled(double power, const Vec3<DoubleDouble>& v) {
  const auto times = [&](const DoubleDouble& x) { return DoubleDouble{power * x.high, power * x.low}; };
  return {times(v.x), times(v.y), times(v.z)};
}
inline Vec3<double> scaled(double power, const Vec3<double>& v) { return power * v; }

inline Vec3<double> rounded(const Vec3<DoubleDouble>& v) { return {v.x.high, v.y.high, v.z.high}; }

/// The nearest double at or above.
inline double upper_double(double x) { return x; }
inline double upper_double(const DoubleDouble& x) { return x.low > 0 ? std::nextafter(x.high, HUGE_VAL) : x.high; }

}  // namespace tamis
