#include "files/text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace tamis::io {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Bug: what is too small for a double is infinite, what is too large is 0, or one of them is no number.
TEST(Text, NumbersBeyondDoublesAreZeroOrInfinite) {
  for (const std::string word : {"1e309", "+1e309", "17976931348623159e294", "1e99999999999999999999", "0.1e310"})
    EXPECT_EQ(to_double(word), kInfinity) << word;
  EXPECT_EQ(to_double("-2e308"), -kInfinity);
  EXPECT_EQ(to_double("1" + std::string(400, '0')), kInfinity);
  EXPECT_EQ(to_double("1" + std::string(400, '0') + "e-100"), 1e300);
  for (const std::string word : {"1e-400", "1.5e-400", "100e-402", "1e-99999999999999999999"})
    EXPECT_EQ(to_double(word), 0) << word;
  EXPECT_EQ(to_double("0." + std::string(400, '0') + "1"), 0);
  EXPECT_EQ(to_double("0." + std::string(400, '0') + "1e400"), 0.1);
  EXPECT_TRUE(std::signbit(*to_double("-1e-400")));
}

TEST(Text, SubnormalNumbersAreExact) {
  EXPECT_EQ(to_double("5e-324"), 0x1p-1074);
  EXPECT_EQ(to_double("2.4703282292062328e-324"), 0x1p-1074);
  EXPECT_EQ(to_double("2.2250738585072011e-308"), 0x0.fffffffffffffp-1022);
}

TEST(Text, WordsThatAreNoNumbersAreNone) {
  for (const std::string word : {"", "+", "-", "+-1", "1x", "0x1", "1e", "1,5", " 1", "--1"})
    EXPECT_FALSE(to_double(word)) << word;
  EXPECT_TRUE(std::isnan(*to_double("nan")));
}

}  // namespace
}  // namespace tamis::io
