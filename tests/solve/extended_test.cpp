// The double-double stage against the oracle, over whole steps: it must be right by itself, although the library shows
// it only what doubles leave. And what it is for: it decides by far most of what is near a border by rounding only.
#include "solve/extended.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/pair_cases.hpp"
#include "support/test_data.hpp"

namespace tamis::test {
namespace {

using oracle::Motion, oracle::touches;

constexpr PairKind kKinds[] = {PairKind::vertex_face, PairKind::edge_edge};

void check(PairKind kind, const Motion& m, const Decision& d) {
  SCOPED_TRACE(describe(kind, m));
  const bool truth = touches(kind, m);
  if (d.verdict == Verdict::is_free) {
    EXPECT_FALSE(truth) << "missed";
    return;
  }
  ASSERT_TRUE(0 <= d.lower && d.lower <= d.upper && d.upper <= 1);
  EXPECT_FALSE(d.lower > 0 && touches(kind, m, {0, d.lower, true})) << "touches before " << d.lower;
  if (d.verdict == Verdict::touches) {
    EXPECT_TRUE(touches(kind, m, {d.lower, d.upper})) << "no contact in [" << d.lower << ", " << d.upper << "]";
  }
}

// TAMIS_EXTENDED_CASES sets the number of cases a family and placement (long runs).
TEST(Extended, KeepsItsPromisesInEveryFamilyAndPlacement) {
  Random random(23);
  const long cases = repetitions("TAMIS_EXTENDED_CASES", 25);
  for (const Family& family : kFamilies)
    for (const Placement& placement : kPlacements)
      for (const PairKind kind : kKinds)
        for (long i = 0; i < cases && !HasFailure(); ++i) {
          const Motion m = permuted(kind, placed(family.make(kind, random), placement), random);
          const PairMotion<double> rounded = make_motion(kind, to_points(m));
          if (!std::isfinite(rounded.size_d + rounded.size_e + rounded.size_f)) continue;
          check(kind, m, decide_in_extended(kind, to_points(m), {0, 1}));
        }
}

// Units in the last place beside a contact: what doubles leave, nearly all of it.
TEST(Extended, DecidesWhatIsNearContactByRoundingOnly) {
  Random random(29);
  int left_by_doubles = 0, left = 0;
  for (int i = 0; i < 2000; ++i) {
    const PairKind kind = kKinds[i % 2];
    const Motion m = family_named("near_contact").make(kind, random);
    const Decision in_doubles = subdivide(kind, make_motion(kind, to_points(m)), {0, 1});
    if (in_doubles.verdict != Verdict::unsure) continue;
    ++left_by_doubles;
    const Decision d = decide_in_extended(kind, to_points(m), {in_doubles.lower, in_doubles.upper});
    check(kind, m, d);
    left += d.verdict == Verdict::unsure;
  }
  RecordProperty("left_by_doubles", left_by_doubles);
  RecordProperty("left", left);
  EXPECT_GT(left_by_doubles, 200);
  EXPECT_LT(left, left_by_doubles / 20);
}

// A root in so flat a part of the cubic that doubles bracket it within 1e-9 only.
TEST(Extended, SharpensAWideBracket) {
  Random random(31);
  int wide = 0;
  for (int i = 0; i < 40000; ++i) {
    Motion m = family_named("random").make(PairKind::vertex_face, random);
    for (auto* points : {&m.start, &m.end})
      for (Point& p : *points) p[2] *= 0x1p-20;
    for (std::size_t v = 0; v < 4; ++v) m.end[v][2] = m.start[v][2] + 0x1p-16 * (m.end[v][2] - m.start[v][2]);
    const auto motion = make_motion(PairKind::vertex_face, to_points(m));
    const Decision d = subdivide(PairKind::vertex_face, motion, {0, 1});
    if (!d.is_one_crossing || d.upper - d.lower <= kWideBracket) continue;
    ++wide;
    const auto bracket = sharpened(PairKind::vertex_face, to_points(m), {d.lower, d.upper});
    EXPECT_LT(bracket.t_out - bracket.t_in, 1e-14);
    check(PairKind::vertex_face, m, {Verdict::touches, bracket.t_in, bracket.t_out});
  }
  EXPECT_GT(wide, 20) << "the test makes no wide brackets";
}

}  // namespace
}  // namespace tamis::test
