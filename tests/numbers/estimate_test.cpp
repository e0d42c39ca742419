// Estimates against integers: what an estimate says of a sign, or of how sharp it is, must be true.
#include "numbers/estimate.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "numbers/integer.hpp"
#include "scenes/random.hpp"

namespace tamis {
namespace {

struct EstimatedInteger {
  Estimate estimate;
  Integer exact;
};

EstimatedInteger scaled(std::int64_t mantissa, int shift) {
  return {Estimate::scaled(mantissa, shift), Integer::scaled(mantissa, shift)};
}

/// Sums, differences and products of each other, so that many cancel.
std::vector<EstimatedInteger> numbers(scenes::Random& random, int largest_shift) {
  std::vector<EstimatedInteger> all;
  for (int i = 0; i < 4; ++i) {
    const auto mantissa = static_cast<std::int64_t>(random.bits() >> (11 + random.below(50)));
    all.push_back(scaled(random.coin() ? mantissa : -mantissa, random.below(largest_shift + 1)));
  }
  const auto any = [&] { return all[static_cast<std::size_t>(random.below(static_cast<Index>(all.size())))]; };
  for (int i = 0; i < 12; ++i) {
    const EstimatedInteger a = any(), b = any(), c = any();
    switch (random.below(4)) {
      case 0:
        all.push_back({a.estimate + b.estimate, a.exact + b.exact});
        break;
      case 1:
        all.push_back({a.estimate - b.estimate, a.exact - b.exact});
        break;
      case 2:
        all.push_back({a.estimate * b.estimate, a.exact * b.exact});
        break;
      default:  // distributes: often zero, or what is left of long numbers
        all.push_back(
            {(a.estimate + b.estimate) * c.estimate - a.estimate * c.estimate - b.estimate * c.estimate + b.estimate,
             (a.exact + b.exact) * c.exact - a.exact * c.exact - b.exact * c.exact + b.exact});
    }
  }
  return all;
}

/// |value - exact| <= 2^-48 |exact|, but for the rounding of what is asked here.
bool is_near(double value, const Integer& exact) {
  const double reference = exact.to_double();  // cut: off by 2^-52 of itself
  return std::fabs(value - reference) <= 0x1.2p-48 * std::fabs(reference) || !(std::fabs(reference) < 0x1p1000);
}

// Bugs: a bound that leaves out a rounding; an integer taken from its rest that is longer than the rest.
TEST(Estimate, SaysOnlyWhatIsTrue) {
  scenes::Random random(20261125);
  long known = 0, sharp = 0, count = 0;
  for (int i = 0; i < 20000; ++i)
    for (const EstimatedInteger& x : numbers(random, i % 4 == 0 ? 140 : 12)) {
      ++count;
      if (x.estimate.has_sign()) {
        ++known;
        ASSERT_EQ(x.estimate.sign(), x.exact.sign());
      }
      if (x.estimate.is_sharp()) {
        ++sharp;
        ASSERT_TRUE(is_near(x.estimate.value(), x.exact)) << x.estimate.value() << " for " << x.exact.to_double();
      }
    }
  EXPECT_GT(known, count * 9 / 10);
  EXPECT_GT(sharp, count * 9 / 10);
}

// Bug: a sign of what is left of two long products is taken from their rounding.
TEST(Estimate, KnowsWhatIsLeftBelow127Bits) {
  const Estimate a = Estimate::scaled((std::int64_t{1} << 53) - 1, 0),
                 b = Estimate::scaled((std::int64_t{1} << 53) - 3, 0);
  EXPECT_TRUE((a * b - b * a).has_sign());
  EXPECT_EQ((a * b - b * a).sign(), 0);
  EXPECT_EQ((a * b - b * a - 1).sign(), -1);
  EXPECT_EQ((a * b - b * a - 1).value(), -1);
  const Estimate longer = a * b * a * b;
  EXPECT_FALSE((longer - longer).has_sign()) << "rounding there is above 2^127: nothing is known";
}

// Bug: what overflows counts as known.
TEST(Estimate, KnowsNothingBeyondTheLargestDouble) {
  const Estimate large = Estimate::scaled(1, 800), larger = Estimate::scaled(3, 1000);
  EXPECT_FALSE((large * large).has_sign());
  EXPECT_FALSE((large * large - large * large).has_sign());
  EXPECT_FALSE((large * large).is_sharp());
  EXPECT_FALSE(larger.has_sign());
  EXPECT_FALSE((larger * large).is_sharp());
}

}  // namespace
}  // namespace tamis
