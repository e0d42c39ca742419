// Exact algebra on pairs that touch at the start and count once they have come apart: against the oracle, which looks
// at single times and asks for touching during parts of the step, and by hand. TAMIS_RECONTACT_CASES sets the number
// of random cases of each family.
#include <gtest/gtest.h>

#include <cmath>

#include "pair/exact/exact.hpp"
#include "support/ask_pair.hpp"
#include "support/pair_cases.hpp"
#include "support/test_data.hpp"
#include "support/thread_seconds.hpp"

namespace tamis::test {
namespace {

using oracle::Motion, oracle::Times;

bool touches_during(PairKind kind, const Motion& m, double separation, const Times& times) {
  return separation > 0 ? oracle::comes_within(kind, m, separation, times) : oracle::touches(kind, m, times);
}

/// A double after which the pair touches no more in the times, and the one before it, after which it does. REQUIRES:
/// the pair touches at the start of them.
struct LastTouch {
  double lower, upper;
};
LastTouch last_touch(PairKind kind, const Motion& m, double separation, const Times& times) {
  LastTouch last{times.from, times.to};
  for (int halvings = 0; halvings < 26; ++halvings) {
    const double middle = 0.5 * (last.lower + last.upper);
    const bool is_later = middle < times.to && touches_during(kind, m, separation, {middle, times.to, times.half_open});
    (is_later ? last.lower : last.upper) = middle;
  }
  return last;
}

/// Of what is free, or before the time of touching: the pair stays as it was at the start until it leaves for good.
void expect_one_span(PairKind kind, const Motion& m, double separation, const Times& times) {
  const LastTouch last = last_touch(kind, m, separation, times);
  if (last.lower == 0) return;
  EXPECT_NE(oracle::stays_within(kind, m, separation, {0, last.lower}), oracle::Always::no) << "until " << last.lower;
}

enum class Course { as_usual, one_span, returns };

Course course_of(PairKind kind, const Motion& m, double separation) {
  const PairPoints points = to_points(m);
  const Decision decision = decide_recontact_exactly(kind, points, separation);
  if (!touches_during(kind, m, separation, {0, 0})) {
    const Decision usual = decide_exactly(kind, points, separation);
    EXPECT_EQ(decision.touches(), usual.touches());
    EXPECT_EQ(decision.lower, usual.lower);
    EXPECT_EQ(decision.upper, usual.upper);
    return Course::as_usual;
  }
  if (!decision.touches()) {
    expect_one_span(kind, m, separation, {});
    return Course::one_span;
  }
  const double lower = decision.lower, upper = decision.upper;
  EXPECT_TRUE(0 <= lower && lower <= upper && upper <= 1 && upper > 0);
  EXPECT_TRUE(lower == upper || std::nextafter(lower, 2.0) == upper);
  EXPECT_TRUE(touches_during(kind, m, separation, {lower, upper})) << "not within the bracket";
  if (lower == 0) return Course::returns;
  expect_one_span(kind, m, separation, {0, lower, true});
  EXPECT_LT(last_touch(kind, m, separation, {0, lower, true}).upper, upper) << "it has not been apart";
  return Course::returns;
}

// Catches a start that counts, a return that does not, a second return in place of the first, and a time that is taken
// for the end of a span within it.
TEST(ExactRecontact, AgreesWithTheOracle) {
  Random random(31);
  const long cases = repetitions("TAMIS_RECONTACT_CASES", 6);
  std::array<long, 3> courses{};
  for (const Family& family : kFamilies)
    for (const PairKind kind : kAllKinds)
      for (long i = 0; i < cases && !HasFailure(); ++i) {
        const Placement& placement = kPlacements[static_cast<std::size_t>(random.below(Index{kPlacements.size()}))];
        const Motion m = placed(family.make(kind, random), placement);
        const double separation = random.below(3) == 0 ? 0 : separation_of_any_size(random) * placement.scale;
        SCOPED_TRACE(std::string(family.name) + "\n" + describe(kind, m) + "\n  separation " +
                     std::to_string(separation / placement.scale));
        ++courses[static_cast<std::size_t>(course_of(kind, m, separation))];
      }
  for (const long course : courses) EXPECT_GT(course, 2);
}

/// An edge that turns in the plane y = 0, at x = 0 by the height t^2/2 - t/4 over its width: at the origin at t = 0 and
/// t = 1/2. Against it the origin, as a point or as an edge along y; or as a face that holds the edge and y.
constexpr Point kA0{-1, 0, 0}, kA1{-0.5, 0, 0.75}, kB0{1, 0, 0}, kB1{1, 0, -1}, kOrigin{0, 0, 0};

Motion turning(PairKind kind) {
  const auto beside = [](const Point& p, double y) { return Point{p[0], y, p[2]}; };
  switch (kind) {
    case PairKind::vertex_face:
      return {{kOrigin, beside(kA0, -1), beside(kB0, -1), beside(kB0, 3)},
              {kOrigin, beside(kA1, -1), beside(kB1, -1), beside(kB1, 3)}};
    case PairKind::edge_edge:
      return {{Point{0, -1, 0}, Point{0, 1, 0}, kA0, kB0}, {Point{0, -1, 0}, Point{0, 1, 0}, kA1, kB1}};
    default:
      return {{kOrigin, kA0, kB0, kOrigin}, {kOrigin, kA1, kB1, kOrigin}};
  }
}

// Catches a pair that is forgotten once it has touched at the start.
TEST(ExactRecontact, ATouchThatComesBackCounts) {
  for (const PairKind kind : {PairKind::vertex_face, PairKind::edge_edge, PairKind::vertex_edge}) {
    const PairPoints points = to_points(turning(kind));
    EXPECT_EQ(decide_exactly(kind, points).upper, 0);
    const Decision again = decide_recontact_exactly(kind, points);
    EXPECT_TRUE(again.touches());
    EXPECT_EQ(again.lower, 0.5);
    EXPECT_EQ(again.upper, 0.5);
    // Within a separation that it does not leave on the way there, and within one that it leaves and comes back to.
    EXPECT_FALSE(decide_recontact_exactly(kind, points, 0.25).touches());
    const Decision near = decide_recontact_exactly(kind, points, 0x1p-8);
    EXPECT_TRUE(near.touches());
    EXPECT_GT(near.lower, 0.25);
    EXPECT_LT(near.upper, 0.5);
  }
}

// Catches a span of touching that is taken for a moment, at its start, its end or within it.
TEST(ExactRecontact, WhatSlidesInContactCountsWhenItHasComeOffAndMeetsAgain) {
  // On a line: one end of the edge passes the point at t = 1/4, the other at t = 1/2.
  const Motion m{{kOrigin, Point{-1, 0, 0}, Point{1, 0, 0}, kOrigin},
                 {kOrigin, Point{1, 0, 0}, Point{-3, 0, 0}, kOrigin}};
  const Decision again = decide_recontact_exactly(PairKind::vertex_edge, to_points(m));
  EXPECT_TRUE(again.touches());
  EXPECT_EQ(again.lower, 0.5);
  EXPECT_EQ(again.upper, 0.5);
  const Motion off{m.start, {kOrigin, Point{-9, 0, 0}, Point{-3, 0, 0}, kOrigin}};
  EXPECT_FALSE(decide_recontact_exactly(PairKind::vertex_edge, to_points(off)).touches());
}

// Catches a contact of what never comes apart, at rest against each other or within a separation.
TEST(ExactRecontact, WhatNeverComesApartIsNoContact) {
  const Point up{0, 0, 1};
  for (const PairKind kind : kAllKinds) {
    Motion m = turning(kind == PairKind::vertex_vertex ? PairKind::vertex_edge : kind);
    if (kind == PairKind::vertex_vertex) m.start[1] = kOrigin;
    m.end = m.start;
    for (const double separation : {0.0, 0x1p-8, 2.0}) {
      EXPECT_FALSE(decide_recontact_exactly(kind, to_points(m), separation).touches());
      Motion carried = m;
      for (Point& p : carried.end) p[2] += up[2];
      EXPECT_FALSE(decide_recontact_exactly(kind, to_points(carried), separation).touches());
    }
  }
}

// Catches a pair that counts for passing through where it began. docs/cpp.md says so.
TEST(ExactRecontact, WhatPassesThroughFromTheVeryTouchIsNoContact) {
  const Motion m{{Point{0.25, 0.25, 0}, Point{0, 0, 0}, Point{1, 0, 0}, Point{0, 1, 0}},
                 {Point{0.25, 0.25, -1}, Point{0, 0, 0}, Point{1, 0, 0}, Point{0, 1, 0}}};
  EXPECT_EQ(decide_exactly(PairKind::vertex_face, to_points(m)).upper, 0);
  EXPECT_FALSE(decide_recontact_exactly(PairKind::vertex_face, to_points(m)).touches());
}

// Catches a touch at the very end of the step that is taken for the end of nothing.
TEST(ExactRecontact, AReturnAtTheEndOfTheStepCounts) {
  Motion m = turning(PairKind::edge_edge);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 3; ++k) m.end[i][k] = 0.5 * m.start[i][k] + 0.5 * m.end[i][k];
  const Decision again = decide_recontact_exactly(PairKind::edge_edge, to_points(m));
  EXPECT_TRUE(again.touches());
  EXPECT_EQ(again.lower, 1);
}

// Bug: of two times next to each other, 2^-731 before the end of the step, one got twice as many bits with each step of
// the other: millions, and 20 s for a pair.
TEST(ExactRecontact, TakesNoMoreBitsThanTwoTimesNeed) {
  const PairPoints points{
      {Point{-0x1.9b708b5d2f424p-3, -0x1.a62957412e86p-3, 0}, Point{0x1.389919319f282p+731, -0x1.1253fb415d93p+727, 0},
       Point{-0x1.1ccb68931d16p-2, 0x1.86122526099p-4, 0}, Point{0x1.ca714333c207ep-1, 0x1.7e6c3c53cca5ap-1, 0}},
      {Point{-0x1.aa191c4a1e2b1p-4, -0x1.3037f45a7503cp-2, 0}, Point{0x1.25df219d203a6p-1, 0x1.a208cd61ddab3p-1, 0},
       Point{-0x1.0b1f8e633895ap-2, 0x1.6f06ae36fbe9ep-5, 0}, Point{0x1.ee31e1551ff1ep-1, 0x1.a3ecdc0c232d1p-1, 0}}};
  const double start = thread_seconds();
  EXPECT_FALSE(decide_recontact_exactly(PairKind::edge_edge, points, 0x1.cac991c828ccep-2).touches());
  EXPECT_LT(thread_seconds() - start, 2);
}

}  // namespace
}  // namespace tamis::test
