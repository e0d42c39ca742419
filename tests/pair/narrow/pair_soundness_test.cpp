// One pair through the whole of the decision, against the oracle: all families of motions, all placements, vertices in
// any order. TAMIS_PAIR_CASES sets the number of cases a family and placement (long runs: millions in all).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/ask_pair.hpp"
#include "support/case_name.hpp"
#include "support/test_data.hpp"

namespace tamis::test {
namespace {

using oracle::Motion, oracle::touches;

/// The promises of PairResult about time.
void check_bracket(PairKind kind, const Motion& m, const PairResult& r) {
  ASSERT_LE(0, r.toi_lower);
  ASSERT_LE(r.toi_lower, r.toi_upper);
  ASSERT_LE(r.toi_upper, 1);
  EXPECT_FALSE(r.toi_lower > 0 && touches(kind, m, {0, r.toi_lower, true})) << "touches before toi_lower";
  EXPECT_TRUE(touches(kind, m, {r.toi_lower, r.toi_upper}))
      << "does not touch within the bracket [" << r.toi_lower << ", " << r.toi_upper << "]";
}

/// Largest |component| of any vertex: the unit of the error of a weight's point.
double size_of(const Motion& m) {
  double size = 0;
  for (const auto* points : {&m.start, &m.end})
    for (const Point& p : *points)
      for (double x : p) size = std::max(size, std::abs(x));
  return size;
}

/// The two points the weights name, at the middle of the bracket, are one point but for rounding.
void check_weights(PairKind kind, const Motion& m, const PairResult& r) {
  EXPECT_GE(r.u, 0);
  EXPECT_GE(r.v, 0);
  EXPECT_LE(r.u, 1);
  EXPECT_LE(kind == PairKind::vertex_face ? r.u + r.v : r.v, 1 + 1e-15);
  EXPECT_FALSE(kind == PairKind::vertex_edge && r.v != 0);
  EXPECT_FALSE(kind == PairKind::vertex_vertex && (r.u != 0 || r.v != 0));
  if (r.toi_upper - r.toi_lower > 1e-12) return;
  const double t = 0.5 * (r.toi_lower + r.toi_upper);
  double gap = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto x = [&](std::size_t i) { return (1 - t) * m.start[i][k] + t * m.end[i][k]; };
    const double difference = kind == PairKind::edge_edge
                                  ? (1 - r.u) * x(0) + r.u * x(1) - ((1 - r.v) * x(2) + r.v * x(3))
                                  : x(0) - ((1 - r.u - r.v) * x(1) + r.u * x(2) + r.v * x(3));
    gap = std::max(gap, std::abs(difference));
  }
  EXPECT_LE(gap, 1e-6 * size_of(m)) << "u " << r.u << " v " << r.v << " t " << t;
  const double length = std::hypot(r.normal[0], r.normal[1], r.normal[2]);
  EXPECT_NEAR(length, 1, 1e-12) << "normal";
}

class PairSoundness : public testing::TestWithParam<std::tuple<std::size_t, std::size_t>> {};

TEST_P(PairSoundness, AnswersAreTrueAndProven) {
  const Family& family = kFamilies[std::get<0>(GetParam())];
  const Placement& placement = kPlacements[std::get<1>(GetParam())];
  const long cases = repetitions("TAMIS_PAIR_CASES", 60);
  Random random(17);
  long contacts = 0;
  for (long i = 0; i < cases && !HasFailure(); ++i)
    for (const PairKind kind : kAllKinds) {
      const Motion m = permuted(kind, placed(family.make(kind, random), placement), random);
      const bool truth = touches(kind, m);
      SCOPED_TRACE(describe(kind, m));
      const PairResult r = ask_pair(kind, m, {});
      EXPECT_EQ(truth, r.touches);
      EXPECT_EQ(r.certainty, Certainty::certified);
      if (!r.touches) continue;
      check_bracket(kind, m, r);
      check_weights(kind, m, r);
      contacts += truth;
    }
  RecordProperty("contacts", static_cast<int>(contacts));
}

INSTANTIATE_TEST_SUITE_P(Cases, PairSoundness,
                         testing::Combine(testing::Range(std::size_t{0}, kFamilies.size()),
                                          testing::Range(std::size_t{0}, kPlacements.size())),
                         case_name);

}  // namespace
}  // namespace tamis::test
