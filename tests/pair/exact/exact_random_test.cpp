// The exact decision against the published answers, against the oracle, and against itself under all that must not
// change it. TAMIS_EXACT_CASES sets the number of random cases of each family (long runs: millions in all).
#include <gtest/gtest.h>

#include <cmath>

#include "pair/exact/exact.hpp"
#include "support/ask_pair.hpp"
#include "support/pair_cases.hpp"
#include "support/test_data.hpp"

namespace tamis::test {
namespace {

using oracle::Motion, oracle::touches;

Decision decide(PairKind kind, const Motion& m) { return decide_exactly(kind, to_points(m)); }

void expect_same(const Decision& a, const Decision& b) {
  EXPECT_EQ(a.touches(), b.touches());
  EXPECT_EQ(a.lower, b.lower);
  EXPECT_EQ(a.upper, b.upper);
}

/// Calls `check(kind, motion, random)` on random cases of every family and kind; stops at a failure and names it.
template <class Check>
void for_random_cases(Check check, long in_ci = 100) {
  Random random(20240611);
  const long count = repetitions("TAMIS_EXACT_CASES", in_ci);
  for (const PairKind kind : kAllKinds)
    for (const Family& family : kFamilies)
      for (long i = 0; i < count; ++i) {
        const Motion m = family.make(kind, random);
        check(kind, m, random);
        if (testing::Test::HasFailure()) FAIL() << family.name << "\n" << describe(kind, m);
      }
}

/// The oracle finds no touching before the bracket, and some within it; an open bracket does not touch at its ends.
void expect_first_time(PairKind kind, const Motion& m, const Decision& decision) {
  const double lower = decision.lower, upper = decision.upper;
  EXPECT_TRUE(lower == upper || std::nextafter(lower, 2.0) == upper);
  EXPECT_TRUE(touches(kind, m, {lower, upper}));
  EXPECT_TRUE(lower == 0 || !touches(kind, m, {0, lower, true}));
  if (lower == upper) return;
  EXPECT_FALSE(touches(kind, m, {lower, lower}));
  EXPECT_TRUE(touches(kind, m, {lower, upper, true}));
}

// Catches a false positive or a missed contact on the hand-made and simulated queries that other solvers fail.
TEST(ExactRandom, equals_every_published_answer) {
  if (data_folder().empty()) GTEST_SKIP() << kNoData;
  const auto queries = read_queries(data_folder() / "queries");
  EXPECT_FALSE(queries.empty());
  for (const Query& query : queries)
    EXPECT_EQ(decide(query.kind, query.motion).touches(), query.touches) << query.origin;
}

// Catches any wrong decision, and a bracket around a later root or beside the root.
TEST(ExactRandom, agrees_with_the_oracle_on_the_first_time) {
  for_random_cases([](PairKind kind, const Motion& made, Random& random) {
    const Motion m = placed(made, kPlacements[static_cast<std::size_t>(random.below(Index{kPlacements.size()}))]);
    const Decision decision = decide(kind, m);
    EXPECT_EQ(decision.touches(), touches(kind, m));
    if (decision.touches()) expect_first_time(kind, m, decision);
  });
}

// Catches numbers that outgrow what was reserved for them, and shifts by the wrong sign.
TEST(ExactRandom, agrees_with_the_oracle_when_every_coordinate_has_its_own_exponent) {
  for_random_cases(
      [](PairKind kind, Motion m, Random& random) {
        for (auto* points : {&m.start, &m.end})
          for (Point& point : *points)
            for (double& x : point) x = std::ldexp(x, static_cast<int>(random.below(400)) - 200);
        const Decision decision = decide(kind, m);
        EXPECT_EQ(decision.touches(), touches(kind, m));
        if (decision.touches()) expect_first_time(kind, m, decision);
      },
      10);
}

// Catches a corner, an orientation or a side that is treated unlike the others.
TEST(ExactRandom, does_not_depend_on_the_order_of_vertices) {
  for_random_cases([](PairKind kind, const Motion& m, Random& random) {
    expect_same(decide(kind, m), decide(kind, permuted(kind, m, random)));
  });
}

// Catches roots that are lost at one end of the step only.
TEST(ExactRandom, does_not_depend_on_the_direction_of_time) {
  for_random_cases([](PairKind kind, const Motion& m, Random&) {
    EXPECT_EQ(decide(kind, m).touches(), decide(kind, {m.end, m.start}).touches());
  });
}

// Catches a tolerance, absolute or relative.
TEST(ExactRandom, does_not_depend_on_scale_or_on_an_exact_offset) {
  for_random_cases([](PairKind kind, const Motion& m, Random& random) {
    const Decision decision = decide(kind, m);
    const int exponent = static_cast<int>(random.below(401));  // upward: exact for the smallest doubles too
    expect_same(decision, decide(kind, placed(m, {"scaled", std::ldexp(1.0, exponent), 0})));
  });
  Random random(1);
  for (const PairKind kind : kAllKinds)
    for (int i = 0; i < 500; ++i) {
      Motion m;  // 1e15 plus a multiple of 1/4 below 100 is a double
      for (auto* points : {&m.start, &m.end})
        for (Point& p : *points) p = random.point_on_lattice(1 + random.below(3), 0.25);
      expect_same(decide(kind, m), decide(kind, placed(m, {"far", 1, 1e15})));
    }
}

}  // namespace
}  // namespace tamis::test
