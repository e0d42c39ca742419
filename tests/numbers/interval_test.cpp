// Interval arithmetic against exact rationals, and what becomes of zeros.
#include "numbers/interval.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "oracle/exact_numbers.hpp"

namespace tamis {
namespace {

using oracle::Rational;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Ends of any size, often zero, denormal, or equal.
class Ends {
 public:
  Interval next() {
    const double a = number(), b = below(4) == 0 ? a : number();
    return {std::min(a, b), std::max(a, b)};
  }
  /// Some number in it.
  double within(const Interval& x) {
    return below(2) == 0 ? x.lower : below(2) == 0 ? x.upper : std::clamp(x.middle(), x.lower, x.upper);
  }

 private:
  int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }
  double number() {
    if (below(4) == 0) return 0;
    const int exponent = below(3) == 0 ? below(400) - 1074 : below(60) - 30;
    return std::ldexp(uniform_(engine_), exponent);
  }

  std::mt19937 engine_{5};
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

/// An end that is not a number proves nothing: that is what overflow leaves.
void expect_encloses(const Interval& x, const Rational& value, const char* operation) {
  EXPECT_TRUE(!std::isfinite(x.lower) || Rational(x.lower) <= value) << operation << ' ' << x.lower << ' ' << value;
  EXPECT_TRUE(!std::isfinite(x.upper) || Rational(x.upper) >= value) << operation << ' ' << x.upper << ' ' << value;
}

// Bug: an end rounded inward; a zero taken for exact that is an underflow.
TEST(Interval, EnclosesEveryResult) {
  Ends ends;
  for (int i = 0; i < 200000; ++i) {
    const Interval a = ends.next(), b = ends.next();
    const double x = ends.within(a), y = ends.within(b);
    expect_encloses(a + b, Rational(x) + Rational(y), "sum");
    expect_encloses(a - b, Rational(x) - Rational(y), "difference");
    expect_encloses(a * b, Rational(x) * Rational(y), "product");
    if (!b.may_be_zero()) expect_encloses(a / b, Rational(x) / Rational(y), "quotient");
  }
}

Rational value_of(const DoubleDouble& x) { return Rational(x.high) + Rational(x.low); }

// Bug: a sum of double-doubles that cancels to zero, and is not zero.
TEST(Interval, SumsOfDoubleDoublesThatCancelAreEnclosed) {
  std::mt19937 engine(6);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int zeros = 0;
  for (int i = 0; i < 200000; ++i) {
    const auto scaled = [&](int least) {
      return std::ldexp(uniform(engine), -static_cast<int>(engine() % 120) + least);
    };
    const DoubleDouble a = DoubleDouble::sum_of(scaled(20), scaled(-40));
    const DoubleDouble b = i % 3 == 0 ? -a : -a + DoubleDouble(scaled(-100));
    const FineInterval sum = FineInterval(a) + FineInterval(b);
    EXPECT_LE(value_of(sum.lower), value_of(a) + value_of(b));
    EXPECT_GE(value_of(sum.upper), value_of(a) + value_of(b));
    zeros += sum.is_zero();
  }
  EXPECT_GT(zeros, 60000);
}

// Bug: denormal numbers about each zero of what turns about an axis of coordinates, a hundred times as slow.
TEST(Interval, ZerosStayExact) {
  const Interval zero, a(-1, 2), b(3, 4);
  for (const Interval& x : {zero + zero, zero * a, a * zero, zero * b, b * zero, -zero * zero, zero / b})
    EXPECT_TRUE(x.is_zero()) << x.lower << ' ' << x.upper;
  const Interval dot_of_axes = Interval(3) * zero + zero * Interval(-4) + zero * zero;
  EXPECT_TRUE(dot_of_axes.is_zero());
  EXPECT_FALSE((Interval(1) - Interval(1) * Interval(1)).is_zero());
}

// Bug: zero times what overflowed is zero.
TEST(Interval, ZeroTimesTheUnknownIsUnknown) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Interval& x : {Interval(0, kInfinity), Interval(-kInfinity, 0), Interval(nan, nan), Interval(nan, 1)})
    for (const Interval& product : {Interval(0) * x, x * Interval(0)}) {
      EXPECT_FALSE(product.lower > -kInfinity) << x.lower << ' ' << x.upper;
      EXPECT_FALSE(product.upper < kInfinity) << x.lower << ' ' << x.upper;
    }
}

}  // namespace
}  // namespace tamis
