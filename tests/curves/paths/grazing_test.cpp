// Touches that cross nothing. A point (or an edge along z) at the distance r from the z axis turns about it beside a
// wall in the plane x = c: it touches iff r^2 >= c^2, which integers decide exactly.
#include <gtest/gtest.h>

#include <cmath>

#include "curves/paths/turning_pairs.hpp"
#include "oracle/exact_numbers.hpp"

namespace tamis::test {
namespace {

/// `rod` at t=0; turned by `turn` about z.
TurningPair beside_wall(PairKind kind, double x, double y, double wall, double turn) {
  TurningPair pair{
      kind, {}, {{0, 0, 0}, {0, 0, turn}, {0, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
  if (kind == PairKind::vertex_face)
    pair.points = {Point{x, y, 0.125}, Point{wall, -8, -8}, Point{wall, 8, -8}, Point{wall, 0, 8}};
  else
    pair.points = {Point{x, y, -1}, Point{x, y, 1.25}, Point{wall, -8, 0}, Point{wall, 8, 0.5}};
  return pair;
}

/// The sign of r^2 - c^2.
int excess(double x, double y, double wall) {
  const oracle::Rational a(x), b(y), c(wall);
  return (a * a + b * b - c * c).sign();
}

/// Away from the wall by whole units in the last place.
double moved(double x, int ulps) {
  for (; ulps > 0; --ulps) x = std::nextafter(x, HUGE_VAL);
  for (; ulps < 0; ++ulps) x = std::nextafter(x, -HUGE_VAL);
  return x;
}

// Bug: a near miss by 1e-16 or less that only doubles look at is reported; a touch by as little is lost.
TEST(Grazing, IsDecidedByLastPlaces) {
  Random random(3);
  int free = 0, touching = 0;
  for (int i = 0; i < 600; ++i) {
    const PairKind kind = random.coin() ? PairKind::vertex_face : PairKind::edge_edge;
    const double angle = random.between(-2, -0.5), r = random.between(0.5, 4);
    const double x = r * std::cos(angle), y = r * std::sin(angle);
    const double wall = moved(std::hypot(x, y), random.below(9) - 4);
    const TurningPair pair = beside_wall(kind, x, y, wall, 2.5 - angle / 2);
    const int sign = excess(x, y, wall);
    const PairResult result = ask(pair);
    ASSERT_EQ(result.touches, sign >= 0) << i;
    ++(sign >= 0 ? touching : free);
    if (sign <= 0) continue;
    // r cos(angle + turn t) = c the first time.
    const long double depth = (static_cast<long double>(x) * x + static_cast<long double>(y) * y) / wall / wall - 1;
    const long double t = (-std::atan2(static_cast<long double>(y), static_cast<long double>(x)) - std::sqrt(depth)) /
                          static_cast<long double>(pair.first.theta1[2]);
    EXPECT_NEAR(result.toi_lower, static_cast<double>(t), 1e-9) << i;
    EXPECT_LE(result.toi_upper - result.toi_lower, 1e-9) << i;
  }
  EXPECT_GT(free, 100);
  EXPECT_GT(touching, 100);
}

// Bug: a touch at the very start is free because the pair separates; one that just misses stops the step.
TEST(Grazing, AtTheStartWhileSeparating) {
  for (const PairKind kind : {PairKind::vertex_face, PairKind::edge_edge})
    for (const double turn : {1e-6, 0.3, 1.0, kPi, -1.0}) {
      const auto at_start = [&](double wall) { return ask(beside_wall(kind, 1, 0, wall, turn)); };
      EXPECT_TRUE(at_start(1).touches);
      EXPECT_EQ(at_start(1).toi_lower, 0);
      EXPECT_LT(at_start(1).toi_upper, 1e-9);
      EXPECT_FALSE(at_start(moved(1, 1)).touches);
      EXPECT_FALSE(at_start(1 + 1e-13).touches);
    }
}

// Bug: a vertex that turns within the plane of a face spends all that is spent on a pair before it comes to a side.
TEST(Grazing, WithinThePlaneOfTheFace) {
  const TurningPair pair{
      PairKind::vertex_face,
      {Point{1.0904383941764577, 0.1447207950015108, 0.2}, Point{2.05, 0, 0.2},
       Point{0.99562603208088674, 0.31352118871697499, 0.2}, Point{1.1610804934643759, 0.14079101853620818, 0.2}},
      {{0, 0, 0}, {0, 0, 0.1}, {0, 0, 0}, {0, 0, 0}},
      {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
  int checks = 0;  // one for each 64 parts
  const PairResult result = ask(pair, {.is_cancelled = [&] { return ++checks > 100; }});
  EXPECT_TRUE(result.touches);
  EXPECT_NEAR(result.toi_lower, 0.786275345613, 1e-11);
  EXPECT_LE(result.toi_upper - result.toi_lower, 1e-9);
}

// Bug: only the first turn is looked at; each turn passes the wall once more, nearer each time.
TEST(Grazing, AfterManyFullTurns) {
  for (const PairKind kind : {PairKind::vertex_face, PairKind::edge_edge})
    for (const int turns : {1, 7, 60}) {
      TurningPair pair = beside_wall(kind, 1, 0, 1.5, -2 * kPi * turns);
      EXPECT_FALSE(ask(pair).touches);
      // The axis goes to the wall: in the last turn the rod reaches it.
      pair.first.p1 = {0.5 + 1e-6, 0, 0};
      const PairResult result = ask(pair);
      ASSERT_TRUE(result.touches) << turns;
      EXPECT_GT(result.toi_lower, 1 - 1.0 / turns - 1e-3);
      EXPECT_LE(result.toi_upper - result.toi_lower, 1e-9);
      pair.first.p1 = {0.5 - 1e-6, 0, 0};
      EXPECT_FALSE(ask(pair).touches) << turns;
    }
}

// Bug: brackets in the unit of the angle or of the length.
TEST(Grazing, TimesOfAQuarterTurnAreThoseOfTheCircle) {
  for (const double scale : {1e-9, 1.0, 1e12}) {
    TurningPair pair = beside_wall(PairKind::vertex_face, 0, -1, 0.5, kPi / 2);
    for (Point& p : pair.points)
      for (double& x : p) x *= scale;
    const PairResult result = ask(pair);
    ASSERT_TRUE(result.touches);
    EXPECT_EQ(result.certainty, Certainty::certified);
    EXPECT_NEAR(result.toi_lower, 1.0 / 3, 1e-9) << scale;
    EXPECT_NEAR(result.toi_upper, 1.0 / 3, 1e-9) << scale;
  }
}

}  // namespace
}  // namespace tamis::test
