// Would catch: an axis that proves a pair apart which comes within its separation, because a corner, a Bernstein
// coefficient or a part of the time is left out, or because the bound on the error is too small: separations lie beside
// the distance at the ends of the time, one double off. Against the oracle.
#include "pair/distance/turning_gap.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "pair/motion/pair_kinds.hpp"
#include "support/ask_pair.hpp"
#include "support/case_name.hpp"
#include "support/test_data.hpp"

namespace tamis::test {
namespace {

using oracle::comes_within, oracle::Motion;

/// The smallest double that the distance at `time` is within; the largest double where there is none.
double distance_above(PairKind kind, const Motion& m, double time) {
  auto low = std::bit_cast<std::uint64_t>(0.0), high = std::bit_cast<std::uint64_t>(std::numeric_limits<double>::max());
  while (high - low > 1) {
    const std::uint64_t middle = low + (high - low) / 2;
    (comes_within(kind, m, std::bit_cast<double>(middle), {time, time}) ? high : low) = middle;
  }
  return std::bit_cast<double>(high);
}

bool stays_apart(PairKind kind, const Motion& m, double separation, const TimeInterval<double>& time, int parts) {
  const PairMotion<double> motion = make_motion(kind, to_points(m), separation);
  return with_kind(kind, [&](auto k) { return TurningGap<k(), double>(motion).stays_apart(time, parts); });
}

TimeInterval<double> random_time(Random& random) {
  const double a = random.coin() ? 0 : random.unit(), b = random.coin() ? 1 : random.unit();
  return {std::min(a, b), std::max(a, b)};
}

class TurningGapTest : public testing::TestWithParam<std::tuple<std::size_t, std::size_t>> {};

TEST_P(TurningGapTest, NoPairThatComesWithinItsSeparationIsProvenApart) {
  const Family& family = kFamilies[std::get<0>(GetParam())];
  const Placement& placement = kPlacements[std::get<1>(GetParam())];
  const long cases = repetitions("TAMIS_SEPARATION_CASES", 12);
  Random random(71);
  for (long i = 0; i < cases && !HasFailure(); ++i)
    for (const PairKind kind : kAllKinds) {
      const Motion m = permuted(kind, placed(family.make(kind, random), placement), random);
      const TimeInterval<double> time = random_time(random);
      SCOPED_TRACE(describe(kind, m) + "\n  from " + std::to_string(time.t_in) + " to " + std::to_string(time.t_out));
      for (const double end : {time.t_in, time.t_out}) {
        const double least = distance_above(kind, m, end);
        if (!comes_within(kind, m, least, {end, end})) continue;
        for (const int parts : {1, kTurningGapParts}) EXPECT_FALSE(stays_apart(kind, m, least, time, parts)) << least;
      }
      const double separation = placement.scale * std::ldexp(random.unit(), -random.below(20));
      for (const int parts : {1, kTurningGapParts}) {
        if (!stays_apart(kind, m, separation, time, parts)) continue;
        EXPECT_FALSE(comes_within(kind, m, separation, {time.t_in, time.t_out})) << separation << ", " << parts;
      }
    }
}

INSTANTIATE_TEST_SUITE_P(Cases, TurningGapTest,
                         testing::Combine(testing::Range(std::size_t{0}, kFamilies.size()),
                                          testing::Range(std::size_t{0}, kPlacements.size())),
                         case_name);

/// An edge that turns about a point by a quarter, at a distance from it.
Motion turning_edge() {
  return {{{{0, 0, 0}, {1, -0.25, 0}, {1, 0.25, 0}, {0, 0, 0}}}, {{{0, 0, 0}, {0.25, 1, 0}, {-0.25, 1, 0}, {0, 0, 0}}}};
}

// The other side: an axis that turns with the pair sees what a fixed one does not.
TEST(TurningGap, SeesThatWhatTurnsStaysApart) {
  const Motion m = turning_edge();
  EXPECT_TRUE(stays_apart(PairKind::vertex_edge, m, 0.6, {0, 1}, kTurningGapParts));
  EXPECT_FALSE(stays_apart(PairKind::vertex_edge, m, 0.6, {0, 1}, 1));  // a quarter is too much for one
  EXPECT_TRUE(stays_apart(PairKind::vertex_edge, m, 0.6, {0, 0.25}, 1));
  EXPECT_FALSE(stays_apart(PairKind::vertex_edge, m, 0.75, {0, 1}, kTurningGapParts));  // it comes so near
  EXPECT_TRUE(comes_within(PairKind::vertex_edge, m, 0.75));
}

TEST(TurningGap, ProvesNothingOfFeaturesThatTouch) {
  for (const PairKind kind : kAllKinds) {
    const Motion still{};
    EXPECT_FALSE(stays_apart(kind, still, 0, {0, 1}, 1));
    EXPECT_FALSE(stays_apart(kind, still, 0, {0, 1}, kTurningGapParts));
  }
}

}  // namespace
}  // namespace tamis::test
