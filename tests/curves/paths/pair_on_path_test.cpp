// Pairs of turning bodies against conservative advancement in long double.
#include <gtest/gtest.h>

#include "curves/paths/turning_pairs.hpp"
#include "support/test_data.hpp"

namespace tamis::test {
namespace {

using oracle::Real;

Turning turning(Random& random, double place, double angle, double way) {
  const Point theta = random.point_between(-2, 2), p = random.point_between(-place, place);
  const auto moved = [&](const Point& from, double most) {
    const Point by = random.point_between(-most, most);
    return Point{from[0] + by[0], from[1] + by[1], from[2] + by[2]};
  };
  return {theta, moved(theta, angle), p, moved(p, way)};
}

TurningPair random_pair(Random& random, double angle, double way) {
  TurningPair pair{random.coin() ? PairKind::vertex_face : PairKind::edge_edge,
                   {},
                   turning(random, 0.7, angle, way),
                   turning(random, 0.7, angle, way)};
  for (Point& x : pair.points) x = random.point_between(-1, 1);
  return pair;
}

/// A rod 20 long and as thin as a line turns fast about its middle beside a wall's edge: it sweeps it or misses.
TurningPair rod_through_wall(Random& random) {
  const double speed = random.between(20, 200), height = random.between(-1, 1);
  TurningPair pair{PairKind::edge_edge,
                   {},
                   {{0, 0, 0}, {0, 0, speed}, {0, 0, 0}, {0, 0, random.between(-0.5, 0.5)}},
                   {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
  pair.points = {Point{-10, 0, 0}, Point{10, random.between(-0.01, 0.01), 0}, Point{random.between(5, 11), 4, height},
                 Point{random.between(5, 11), 4, height + random.between(0.001, 0.5)}};
  return pair;
}

/// A corner turns by little about a point a thousand times its size away.
TurningPair far_centre(Random& random) {
  TurningPair pair = random_pair(random, 0.5, 0.3);
  pair.first.theta0 = {0, 0, 0};
  pair.first.theta1 = random.point_between(-1e-3, 1e-3);
  for (std::size_t i = 0; i < (pair.kind == PairKind::vertex_face ? 1u : 2u); ++i) pair.points[i][0] += 1000;
  pair.first.p0 = {-1000, 0, 0};
  pair.first.p1 = {-1000 + random.between(-0.3, 0.3), random.between(-0.3, 0.3), 0};
  return pair;
}

/// Nearly touching at the start: the point lies 1e-9 to 1e-13 in front of the face, or the edge of the edge.
TurningPair close_at_start(Random& random) {
  TurningPair pair = random_pair(random, 1, 1);
  pair.second.theta0 = pair.first.theta0 = {0, 0, 0};
  pair.second.p0 = pair.first.p0 = {0, 0, 0};
  const double gap = std::pow(10.0, random.between(-13, -9)) * (random.coin() ? 1 : -1);
  if (pair.kind == PairKind::vertex_face)
    pair.points = {Point{0.2, 0.3, gap}, Point{0, 0, 0}, Point{1, 0, 0}, Point{0, 1, 0}};
  else
    pair.points = {Point{-1, 0, gap}, Point{1, 0, gap}, Point{0.3, -1, 0}, Point{0.3, 1, 0}};
  return pair;
}

struct Tally {
  int touching = 0, unresolved = 0, all = 0;
};

/// What must hold of every answer.
void compare(const TurningPair& pair, Tally& tally) {
  const Real apart = oracle::apart_until(pair);
  const PairResult r = ask(pair);
  ++tally.all;
  ASSERT_EQ(r.touches, apart <= 1) << "apart until " << static_cast<double>(apart);
  if (!r.touches) return;
  ++tally.touching;
  tally.unresolved += r.certainty == Certainty::unresolved;
  constexpr Real kRounding = 1e-13L;
  EXPECT_GE(Real(r.toi_upper) + kRounding, apart) << "a contact where the pair is apart";
  EXPECT_LE(Real(r.toi_lower), apart + 1e-6L) << "free where the pair is next to touching";
  EXPECT_LE(r.toi_upper - r.toi_lower, 1e-9);
  EXPECT_EQ(r.toi_lower > 0, oracle::distance(pair, 0) > 0) << "zero only where they touch at the start";
}

void compare_many(long count, const auto& make) {
  Random random(7);
  Tally tally;
  for (long i = 0; i < count; ++i) {
    SCOPED_TRACE(i);
    compare(make(random), tally);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(tally.touching, count / 100) << "hardly a contact among them";
  EXPECT_LT(tally.unresolved, count / 100);
}

// Bug: a deviation or a rounding forgotten; a root taken for the first; the inside test at one time only.
TEST(PairOnPath, AgreesWithTheOracleWhateverTheAngle) {
  for (const double angle : {0.01, 0.5, 3.0, 15.0}) {
    SCOPED_TRACE(angle);
    compare_many(repetitions("TAMIS_PATH_PAIRS", 800), [&](Random& r) { return random_pair(r, angle, 1); });
  }
}

// Bug: pieces so long that a rod is on the other side of the wall at their end.
TEST(PairOnPath, FindsAThinRodThatTurnsFastThroughAThinWall) {
  compare_many(repetitions("TAMIS_PATH_PAIRS", 400), rod_through_wall);
}

// Bug: an error bound relative to the distance of the pair and not of its centre.
TEST(PairOnPath, AgreesWithTheOracleWhenTheCentreIsFar) {
  compare_many(repetitions("TAMIS_PATH_PAIRS", 800), far_centre);
}

// Bug: what is within a billionth of the start is taken for the start, or for free.
TEST(PairOnPath, IsExactNextToTheStart) { compare_many(repetitions("TAMIS_PATH_PAIRS", 800), close_at_start); }

// Bug: the linear question and the curved one disagree where nothing turns.
TEST(PairOnPath, AgreesWithStraightMotionWhereNothingTurns) {
  Random random(11);
  int touching = 0;
  for (int i = 0; i < 2000; ++i) {
    TurningPair pair = random_pair(random, 0, 1);
    pair.first.theta0 = pair.first.theta1 = pair.second.theta0 = pair.second.theta1 = {0, 0, 0};
    std::array<Point, 4> start{}, end{};
    for (std::size_t k = 0; k < 4; ++k) {
      const Turning& body = k < (pair.kind == PairKind::vertex_face ? 1u : 2u) ? pair.first : pair.second;
      for (std::size_t x = 0; x < 3; ++x) {
        start[k][x] = pair.points[k][x] + body.p0[x];
        end[k][x] = pair.points[k][x] + body.p1[x];
      }
    }
    const PairResult straight = pair.kind == PairKind::vertex_face ? vertex_face(start, end) : edge_edge(start, end);
    const PairResult curved = ask(pair);
    ASSERT_EQ(curved.touches, straight.touches) << i;
    if (!curved.touches) continue;
    ++touching;
    EXPECT_NEAR(curved.toi_upper, straight.toi_upper, 1e-9) << i;
    EXPECT_NEAR(curved.u, straight.u, 1e-6) << i;
    EXPECT_NEAR(curved.v, straight.v, 1e-6) << i;
  }
  EXPECT_GT(touching, 50);
}

// Bug: the latest time of interest is for straight pairs alone, or cuts a contact before it.
TEST(PairOnPath, ALatestTimeOfInterestOnlyMakesLaterPairsFree) {
  Random random(17);
  int early = 0, late = 0;
  for (int i = 0; i < 1000; ++i) {
    const TurningPair pair = random_pair(random, 2, 1);
    const PairResult whole = ask(pair, {.min_separation = 0.1});
    const PairResult part = ask(pair, {.min_separation = 0.1, .latest = 0.5});
    EXPECT_EQ(part.touches, whole.touches && whole.toi_lower <= 0.5) << i;
    if (part.touches) {
      EXPECT_EQ(part.toi_lower, whole.toi_lower) << i;
    }
    early += part.touches;
    late += whole.touches && !part.touches;
  }
  EXPECT_GT(early, 20);
  EXPECT_GT(late, 20);
}

// Bug: the separation added once and not twice, or the deviations not at all.
TEST(PairOnPath, ComesWithinASeparationWhenTheOracleSaysSo) {
  Random random(13);
  int touching = 0;
  for (int i = 0; i < 1500; ++i) {
    const TurningPair pair = random_pair(random, 2, 1);
    const double separation = random.between(0.01, 0.2);
    const Real apart = oracle::apart_until(pair, Real(separation));
    const PairResult r = ask(pair, {separation});
    ASSERT_EQ(r.touches, apart <= 1) << i;
    if (!r.touches) continue;
    ++touching;
    EXPECT_GE(r.toi_upper + 1e-11, apart) << i;
    EXPECT_LE(r.toi_lower, apart + 1e-6L) << i;
    if (r.certainty == Certainty::certified) {
      EXPECT_LE(oracle::distance(pair, r.toi_upper), separation) << i;
      EXPECT_LE(r.toi_upper - r.toi_lower, 1e-9) << i;
    }
  }
  EXPECT_GT(touching, 100);
}

}  // namespace
}  // namespace tamis::test
