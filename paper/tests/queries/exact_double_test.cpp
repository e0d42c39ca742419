#include "paper/queries/exact_double.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "oracle/exact_numbers.hpp"

namespace tamis::lab {
namespace {

using oracle::Rational;

std::optional<double> fraction(const Rational& q) { return exact_double(numerator(q).str(), denominator(q).str()); }

// Bug: the conversion cuts digits, or fails for numbers beyond machine words.
TEST(ExactDouble, GivesBackEveryDouble) {
  std::mt19937_64 random(1);
  using Limits = std::numeric_limits<double>;
  std::vector<double> values{
      0, 1, -1, 0.1, Limits::max(), -Limits::max(), Limits::min(), Limits::denorm_min(), 0x1p53, 0x1p63, 0x1p64};
  for (int i = 0; i < 2000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (std::isfinite(value)) values.push_back(value);
  }
  for (const double value : values) EXPECT_EQ(fraction(Rational(value)), value);
}

TEST(ExactDouble, TakesFractionsThatAreNotInLowestTerms) {
  EXPECT_EQ(exact_double("6", "4"), 1.5);
  EXPECT_EQ(exact_double("-9", "3"), -3.0);
  EXPECT_EQ(exact_double("1", "-2"), -0.5);
  EXPECT_EQ(exact_double("-0", "5"), 0.0);
}

// Bug: the library underneath takes a leading zero for octal.
TEST(ExactDouble, LeadingZerosMeanNothing) {
  EXPECT_EQ(exact_double("-010", "02"), -5.0);
  EXPECT_EQ(exact_double("036893488147419103232", "09"), std::nullopt);
  EXPECT_EQ(exact_double("036893488147419103232", "01"), 0x1p65);
}

// Bug: a nearby double is taken, and the exact answer belongs to another query.
TEST(ExactDouble, RefusesWhatIsNoDouble) {
  const Rational half_the_smallest = Rational(std::numeric_limits<double>::denorm_min()) / 2;
  const Rational above_the_largest = Rational(std::numeric_limits<double>::max()) * 2;
  const Rational between = Rational(1) + Rational(0x1p-53);
  for (const Rational& q :
       {half_the_smallest, above_the_largest, between, Rational(1, 3), Rational("9007199254740993")})
    EXPECT_EQ(fraction(q), std::nullopt) << q;
}

TEST(ExactDouble, RefusesWhatIsNoFractionOfIntegers) {
  const std::pair<const char*, const char*> cases[] = {{"1", "0"},   {"", "1"},  {"1", ""},  {"0x10", "1"},
                                                       {"1.5", "1"}, {"-", "1"}, {"1", "-"}, {"1e3", "1"},
                                                       {"nan", "1"}, {" 1", "1"}};
  for (const auto& [numerator, denominator] : cases)
    EXPECT_EQ(exact_double(numerator, denominator), std::nullopt) << numerator << "/" << denominator;
}

}  // namespace
}  // namespace tamis::lab
