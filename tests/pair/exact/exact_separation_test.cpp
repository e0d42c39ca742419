// Exact algebra with a minimum separation, against the oracle (which asks inequalities of it, not roots), by hand where
// features graze each other at exactly the separation, and against itself. TAMIS_EXACT_SEPARATION_CASES sets the number
// of random cases of each family.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pair/exact/exact.hpp"
#include "support/ask_pair.hpp"
#include "support/pair_cases.hpp"
#include "support/test_data.hpp"

namespace tamis::test {
namespace {

using oracle::comes_within, oracle::Motion;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Multiples of the lattices' unit, which features of the lattice graze exactly; others; and nearly nothing.
double random_separation(Random& random) {
  switch (random.below(4)) {
    case 0:
      return 0.125 * (1 + random.below(8));
    case 1:
      return std::nextafter(0.125 * (1 + random.below(8)), random.coin() ? 0 : kInfinity);
    case 2:
      return std::ldexp(1 + random.unit(), -random.below(60));
    default:
      return random.unit();
  }
}

/// The oracle finds no such time before the bracket, and some within it.
void expect_first_time(PairKind kind, const Motion& m, double separation, const Decision& decision) {
  const double lower = decision.lower, upper = decision.upper;
  ASSERT_TRUE(0 <= lower && lower <= upper && upper <= 1);
  EXPECT_TRUE(lower == upper || std::nextafter(lower, 2.0) == upper);
  EXPECT_TRUE(comes_within(kind, m, separation, {lower, upper})) << "not within the bracket";
  EXPECT_FALSE(lower > 0 && comes_within(kind, m, separation, {0, lower, true})) << "before the bracket";
}

void check(PairKind kind, const Motion& m, double separation) {
  const Decision decision = decide_exactly(kind, to_points(m), separation);
  EXPECT_EQ(decision.touches(), comes_within(kind, m, separation));
  if (decision.touches()) expect_first_time(kind, m, separation, decision);
}

// Catches a wrong decision, a polynomial that is left out, a root of which the wrong feature is asked.
TEST(ExactSeparation, AgreesWithTheOracleOnTheFirstTime) {
  Random random(101);
  const long cases = repetitions("TAMIS_EXACT_SEPARATION_CASES", 40);
  for (const Family& family : kFamilies)
    for (const PairKind kind : kAllKinds)
      for (long i = 0; i < cases && !HasFailure(); ++i) {
        const Placement& placement = kPlacements[static_cast<std::size_t>(random.below(Index{kPlacements.size()}))];
        const Motion m = placed(family.make(kind, random), placement);
        const double separation = random_separation(random) * placement.scale;
        SCOPED_TRACE(std::string(family.name) + "\n" + describe(kind, m) + "\n  separation " +
                     std::to_string(separation / placement.scale));
        check(kind, m, separation);
      }
}

// Catches a double root that is taken for none, or for a crossing: grazed at exactly s.
TEST(ExactSeparation, GrazingAtExactlyTheSeparationTouches) {
  const auto point_past_point = [](double s) {  // (t - 1/2, 1, 0) 4 against the origin
    return decide_exactly(PairKind::vertex_vertex, {{{{-2, 1, 0}, {0, 0, 0}}}, {{{2, 1, 0}, {0, 0, 0}}}}, s);
  };
  EXPECT_EQ(point_past_point(1).lower, 0.5);
  EXPECT_EQ(point_past_point(1).upper, 0.5);
  EXPECT_FALSE(point_past_point(std::nextafter(1, 0)).touches());
  EXPECT_LT(point_past_point(std::nextafter(1, 2)).upper, 0.5);

  const auto point_past_edge = [](double s) {
    return decide_exactly(PairKind::vertex_edge,
                          {{{{-2, 1, 1}, {0, 0, 0}, {0, 0, 2}}}, {{{2, 1, 1}, {0, 0, 0}, {0, 0, 2}}}}, s);
  };
  EXPECT_EQ(point_past_edge(1).upper, 0.5);
  EXPECT_FALSE(point_past_edge(std::nextafter(1, 0)).touches());

  const auto point_over_face = [](double s) {  // slides past at height 1, above the inside
    return decide_exactly(
        PairKind::vertex_face,
        {{{{-1, 1, 1}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{9, 1, 1}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}}, s);
  };
  EXPECT_EQ(point_over_face(1).upper, 0.1);  // above the side, at x = 0
  EXPECT_FALSE(point_over_face(std::nextafter(1, 0)).touches());

  const auto edge_past_edge = [](double s) {  // crossed at right angles, a height of 1 between their lines always
    return decide_exactly(
        PairKind::edge_edge,
        {{{{-1, -9, 1}, {1, -9, 1}, {0, -1, 0}, {0, 1, 0}}}, {{{-1, 7, 1}, {1, 7, 1}, {0, -1, 0}, {0, 1, 0}}}}, s);
  };
  EXPECT_EQ(edge_past_edge(1).lower, 0.5);  // begins at the end of edge b
  EXPECT_EQ(edge_past_edge(1).upper, 0.5);
  EXPECT_FALSE(edge_past_edge(std::nextafter(1, 0)).touches());
}

// Catches a border between two regions of nearest features that belongs to neither.
TEST(ExactSeparation, BordersBetweenNearestFeaturesBelongToBoth) {
  // Falls at x = 0: past the corner of the edge, where its cap and its side meet.
  const auto fall = [](double x, double s) {
    return decide_exactly(PairKind::vertex_edge,
                          {{{{x, 0, 8}, {0, 0, 0}, {4, 0, 0}}}, {{{x, 0, -8}, {0, 0, 0}, {4, 0, 0}}}}, s);
  };
  for (const double s : {0.25, 1.0, 4.0}) {
    EXPECT_EQ(fall(0, s).upper, (8 - s) / 16);
    EXPECT_EQ(fall(4, s).lower, (8 - s) / 16);
    EXPECT_TRUE(fall(-s, s).touches());
    EXPECT_FALSE(fall(std::nextafter(-s, -9), s).touches());
    EXPECT_TRUE(fall(4 + s, s).touches());
  }
}

// Catches a feature without length or area that is taken for near, whatever its distance is.
TEST(ExactSeparation, DegenerateFeaturesAreNearOnlyWhereTheyAre) {
  const Point far{9, 9, 9}, origin{0, 0, 0};
  for (const Point& end : {Point{9, 9, 9}, Point{8, 9, 9}}) {
    EXPECT_FALSE(decide_exactly(PairKind::vertex_edge, {{{origin, far, far}}, {{origin, end, end}}}, 1).touches());
    EXPECT_FALSE(
        decide_exactly(PairKind::vertex_face, {{{origin, far, far, far}}, {{origin, end, end, end}}}, 1).touches());
    EXPECT_FALSE(
        decide_exactly(PairKind::edge_edge, {{{origin, origin, far, far}}, {{origin, origin, end, end}}}, 1).touches());
  }
  // A face that has no area just when the vertex is s away from its plane, far off.
  const Point a{0, 0, 0}, b{2, 0, 0};
  EXPECT_FALSE(
      decide_exactly(PairKind::vertex_face, {{{{50, 0, 2}, a, b, {1, 1, 0}}}, {{{50, 0, 0}, a, b, {1, -1, 0}}}}, 1)
          .touches());
}

// Catches a square root taken by rounding: s^2 is exact, s against an irrational distance never equal.
TEST(ExactSeparation, TellsIrrationalDistancesFromTheirNeighbours) {
  const auto at_rest = [](double s) {
    return decide_exactly(PairKind::vertex_vertex, {{{{1, 1, 0}, {0, 0, 0}}}, {{{1, 1, 0}, {0, 0, 0}}}}, s).touches();
  };
  EXPECT_FALSE(at_rest(1.4142135623730949));  // the doubles beside the root of 2
  EXPECT_TRUE(at_rest(1.4142135623730951));
}

// Catches a tolerance: as s goes to zero the decision becomes that of touching, and never without a reason.
TEST(ExactSeparation, GoesToTouchingAsItVanishes) {
  Random random(7);
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  for (const Family& family : kFamilies)
    for (const PairKind kind : kAllKinds)
      for (int i = 0; i < 10; ++i) {
        const PairPoints points = to_points(family.make(kind, random));
        const Decision at_zero = decide_exactly(kind, points), near_zero = decide_exactly(kind, points, tiny);
        SCOPED_TRACE(describe(kind, {points.start, points.end}));
        EXPECT_LE(at_zero.touches(), near_zero.touches());
        EXPECT_TRUE(!at_zero.touches() || near_zero.lower <= at_zero.upper);
      }
}

// Catches numbers that outgrow what was made for them.
TEST(ExactSeparation, TakesCoordinatesOfAllSizesTogether) {
  Random random(11);
  for (const PairKind kind : kAllKinds)
    for (int i = 0; i < 12 && !HasFailure(); ++i) {
      Motion m = family_named("random").make(kind, random);
      for (auto* points : {&m.start, &m.end})
        for (Point& point : *points)
          for (double& x : point) x = std::ldexp(x, random.below(120) - 60);
      const double separation = std::ldexp(random.unit(), random.below(120) - 60);
      SCOPED_TRACE(describe(kind, m) + "\n separation " + std::to_string(separation));
      check(kind, m, separation);
    }
}

// Catches a corner or a side that is treated unlike the others.
TEST(ExactSeparation, DoesNotDependOnTheOrderOfVertices) {
  Random random(13);
  for (const Family& family : kFamilies)
    for (const PairKind kind : kAllKinds)
      for (int i = 0; i < 10; ++i) {
        const Motion m = family.make(kind, random);
        const double separation = random_separation(random);
        const Decision a = decide_exactly(kind, to_points(m), separation);
        const Decision b = decide_exactly(kind, to_points(permuted(kind, m, random)), separation);
        EXPECT_EQ(a.touches(), b.touches());
        EXPECT_EQ(a.lower, b.lower);
        EXPECT_EQ(a.upper, b.upper);
      }
}

}  // namespace
}  // namespace tamis::test
