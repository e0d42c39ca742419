// One pair with a minimum separation, against the oracle, which decides it by exact algebra on polynomials of degree
// six. TAMIS_SEPARATION_CASES sets the number of cases a family and placement.
#include <gtest/gtest.h>

#include <cmath>

#include "support/ask_pair.hpp"
#include "support/case_name.hpp"
#include "support/test_data.hpp"

namespace tamis::test {
namespace {

using oracle::comes_within, oracle::Motion;

void check(PairKind kind, const Motion& m, double separation, const PairResult& r) {
  const bool truth = comes_within(kind, m, separation);
  EXPECT_EQ(truth, r.touches);
  EXPECT_EQ(r.certainty, Certainty::certified);
  if (!r.touches) return;
  ASSERT_LE(0, r.toi_lower);
  ASSERT_LE(r.toi_lower, r.toi_upper);
  ASSERT_LE(r.toi_upper, 1);
  EXPECT_FALSE(r.toi_lower > 0 && comes_within(kind, m, separation, {0, r.toi_lower, true})) << "before toi_lower";
  EXPECT_TRUE(comes_within(kind, m, separation, {r.toi_lower, r.toi_upper}))
      << "not within the bracket [" << r.toi_lower << ", " << r.toi_upper << "]";
  EXPECT_FALSE(r.toi_lower == 0 && !comes_within(kind, m, separation, {0, 0})) << "apart at t=0, but toi_lower is 0";
}

class Separation : public testing::TestWithParam<std::tuple<std::size_t, std::size_t>> {};

// Bugs: a bound on the error that is too small; a time that is skipped; a separation that is scaled twice, or not.
TEST_P(Separation, DecisionsAndBracketsAreProven) {
  const Family& family = kFamilies[std::get<0>(GetParam())];
  const Placement& placement = kPlacements[std::get<1>(GetParam())];
  const long cases = repetitions("TAMIS_SEPARATION_CASES", 12);
  Random random(23);
  long contacts = 0;
  for (long i = 0; i < cases && !HasFailure(); ++i)
    for (const PairKind kind : kAllKinds) {
      const Motion m = permuted(kind, placed(family.make(kind, random), placement), random);
      const double separation = separation_of_any_size(random) * placement.scale;
      SCOPED_TRACE(describe(kind, m) + "\n  separation " + std::to_string(separation / placement.scale));
      const PairResult r = ask_pair(kind, m, {separation});
      check(kind, m, separation, r);
      EXPECT_LE(r.toi_upper - r.toi_lower, 1e-11);
      contacts += r.touches;
    }
  RecordProperty("contacts", static_cast<int>(contacts));
}

INSTANTIATE_TEST_SUITE_P(Cases, Separation,
                         testing::Combine(testing::Range(std::size_t{0}, kFamilies.size()),
                                          testing::Range(std::size_t{0}, kPlacements.size())),
                         case_name);

}  // namespace
}  // namespace tamis::test
