// Double-double arithmetic against exact rationals: every operation within the bound that its header claims, also
// where the result cancels, and near underflow within what error_bounds::underflow gives.
#include "numbers/double_double.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "oracle/exact_numbers.hpp"

namespace tamis {
namespace {

using oracle::Rational;

Rational exact(const DoubleDouble& a) { return Rational(a.high) + Rational(a.low); }

/// Numbers of any size within 2^+-`exponents`; often nearly equal ones, and low parts that are zero or at their limit.
class Operands {
 public:
  explicit Operands(int exponents) : exponents_(exponents) {}
  DoubleDouble next() {
    const double high = std::ldexp(uniform_(engine_), below(2 * exponents_ + 1) - exponents_);
    const double half_ulp = 0.5 * (std::nextafter(std::fabs(high), HUGE_VAL) - std::fabs(high));
    const double low = below(4) == 0 ? 0 : half_ulp * (below(4) == 0 ? 0.999 : uniform_(engine_));
    return DoubleDouble::sum_of(high, std::ldexp(low, -(below(3) == 0 ? below(60) : 0)));
  }
  /// Cancels against `a` in a sum.
  DoubleDouble nearly_minus(const DoubleDouble& a) {
    return -a + DoubleDouble(std::ldexp(a.high * uniform_(engine_), -below(120)));
  }
  int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }

 private:
  std::mt19937 engine_{5};
  std::uniform_real_distribution<double> uniform_{-1, 1};
  int exponents_;
};

void expect_close(const DoubleDouble& computed, const Rational& truth, double relative, const char* operation) {
  const Rational error = abs(exact(computed) - truth);
  EXPECT_LE(error, abs(truth) * Rational(relative)) << operation << " " << computed.high << " " << computed.low;
  EXPECT_EQ(computed.high, computed.high + computed.low) << operation << ": the parts overlap";
}

/// What is left of the high parts is less than the sum of the low ones.
TEST(DoubleDouble, AddsWhatCancelsBelowItsLowParts) {
  const DoubleDouble a(1, 0x1p-53), b(-1 + 0x1p-53, 0x1.fp-55);
  EXPECT_EQ(exact(a + b), exact(a) + exact(b));
}

TEST(DoubleDouble, SumsOfTwoDoublesAndProductsOfTwoAreExact) {
  Operands operands(300);
  for (int i = 0; i < 20000; ++i) {
    const double a = operands.next().high, b = operands.next().high;
    EXPECT_EQ(exact(DoubleDouble::sum_of(a, b)), Rational(a) + Rational(b)) << a << " " << b;
    EXPECT_EQ(exact(DoubleDouble::product_of(a, b)), Rational(a) * Rational(b)) << a << " " << b;
  }
}

TEST(DoubleDouble, OperationsAreWithinTheUnitRoundoff) {
  constexpr double kRoundoff = error_bounds::unit_roundoff<DoubleDouble>;
  Operands operands(100);
  for (int i = 0; i < 40000; ++i) {
    const DoubleDouble a = operands.next(), b = operands.below(2) ? operands.next() : operands.nearly_minus(a);
    expect_close(a + b, exact(a) + exact(b), kRoundoff, "sum");
    expect_close(a - b, exact(a) - exact(b), kRoundoff, "difference");
    expect_close(a * b, exact(a) * exact(b), kRoundoff, "product");
    if (b.high != 0) expect_close(a / b, exact(a) / exact(b), Ratio<DoubleDouble>::kError, "quotient");
  }
}

// Low parts underflow first: a product may then be off by more than its relative bound, never by more than this.
TEST(DoubleDouble, UnderflowCostsLessThanItsBound) {
  Operands operands(0);
  for (int i = 0; i < 20000; ++i) {
    const int size = operands.below(600);
    DoubleDouble a = operands.next(), b = operands.next();
    a = {std::ldexp(a.high, -size), std::ldexp(a.low, -size)};
    b = {std::ldexp(b.high, -(1070 - size)), std::ldexp(b.low, -(1070 - size))};
    const Rational error = abs(exact(a * b) - exact(a) * exact(b));
    EXPECT_LE(error,
              abs(exact(a) * exact(b)) * Rational(error_bounds::unit_roundoff<DoubleDouble>) + Rational(0x1p-1068))
        << a.high << " " << b.high;
  }
}

TEST(DoubleDouble, ComparesBothParts) {
  Operands operands(3);
  for (int i = 0; i < 20000; ++i) {
    const DoubleDouble a = operands.next();
    const DoubleDouble b = operands.below(2) ? operands.next() : DoubleDouble(a.high, 0.5 * operands.below(3) * a.low);
    EXPECT_EQ(a < b, exact(a) < exact(b));
    EXPECT_EQ(a <= b, exact(a) <= exact(b));
    EXPECT_EQ(a > b, exact(a) > exact(b));
    EXPECT_EQ(a >= b, exact(a) >= exact(b));
    EXPECT_EQ(exact(min(a, b)), std::min(exact(a), exact(b)));
    EXPECT_EQ(exact(max(a, b)), std::max(exact(a), exact(b)));
    EXPECT_EQ(exact(abs(a)), abs(exact(a)));
    EXPECT_GE(Rational(upper_double(a)), exact(a));
  }
}

// A comparison that is true of NaN or after overflow would prove something of nothing.
TEST(DoubleDouble, NanComparesFalse) {
  const DoubleDouble infinite(std::numeric_limits<double>::infinity()), one(1);
  for (const DoubleDouble& nothing : {infinite - infinite, infinite * DoubleDouble(0), infinite + one}) {
    EXPECT_FALSE(nothing < one || nothing <= one || one > nothing || one >= nothing);
    EXPECT_FALSE(nothing > DoubleDouble(2) && nothing < DoubleDouble(3));
  }
}

}  // namespace
}  // namespace tamis
