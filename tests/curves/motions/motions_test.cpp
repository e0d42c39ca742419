// Motions as engines mean them, against their own formulas in more digits than a double has.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "curves/paths/turning_pairs.hpp"
#include "tamis/error.hpp"

namespace tamis::test {
namespace {

using oracle::Real;
using oracle::RealPoint;

RealPoint real_of(const Point& p) { return {p[0], p[1], p[2]}; }
RealPoint plus_part(const RealPoint& a, Real factor, const RealPoint& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}
RealPoint part_way(const RealPoint& a, const RealPoint& b, Real t) { return plus_part(a, t, plus_part(b, -1, a)); }
Real norm_of(const RealPoint& a) { return std::hypot(a[0], a[1], a[2]); }

/// By so much of the turn.
RealPoint rotated(const Point& turn, Real part, const RealPoint& x) {
  return oracle::position({{}, turn, {}, {}}, x, part);
}
RealPoint placed(const Pose& pose, const Point& x) {
  return plus_part(real_of(pose.position), 1, rotated(pose.rotation, 1, real_of(x)));
}
RealPoint on_chain(const RigidChain& chain, const Point& point, Real t) {
  RealPoint x = real_of(point);
  for (auto link = chain.rbegin(); link != chain.rend(); ++link)
    x = oracle::position({link->start.rotation, link->end.rotation, link->start.position, link->end.position}, x, t);
  return x;
}

Pose random_pose(Random& random) { return {random.point_between(-3, 3), random.point_between(-1.8, 1.8)}; }

/// Of where the path has the point.
Real off_from(const RealPoint& expected, const RigidChain& chain, double time, const Point& x) {
  std::array<Point, 1> point{};
  std::array<double, 1> error{};
  (void)RigidPath({x}, {0}, {chain}).points_at(time, std::array<Index, 1>{0}, point, error);
  return norm_of(plus_part(real_of(point[0]), -1, expected));
}

TEST(Motions, TurnAtConstantSpeedAboutACenterThatGoesStraight) {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const Pose start = random_pose(random);
    const Point turn = random.point_between(-4, 4), end = random.point_between(-3, 3),
                center = random.point_between(-2, 2), x = random.point_between(-2, 2);
    const RigidChain chain = turned_chain(start, turn, end, center);
    for (const double t : {0.0, 0.3, 0.71, 1.0}) {
      const RealPoint arm = rotated(start.rotation, 1, plus_part(real_of(x), -1, real_of(center)));
      const RealPoint expected = plus_part(part_way(placed(start, center), real_of(end), t), 1, rotated(turn, t, arm));
      EXPECT_LT(off_from(expected, chain, t, x), 1e-14L);
    }
  }
}

TEST(Motions, BetweenPosesEndWhereTheyEnd) {
  Random random(2);
  for (int i = 0; i < 300; ++i) {
    const Pose start = random_pose(random), end = random_pose(random);
    const Point center = random.point_between(-2, 2), x = random.point_between(-2, 2);
    const RigidChain chain = chain_between(start, end, center);
    EXPECT_LT(off_from(placed(start, x), chain, 0, x), 1e-14L);
    EXPECT_LT(off_from(placed(end, x), chain, 1, x), 2e-14L);
    EXPECT_LE(std::hypot(chain[0].end.rotation[0], chain[0].end.rotation[1], chain[0].end.rotation[2]), 3.1415926536);
  }
}

TEST(Motions, OfTheOriginStartExactlyWhereTheyAreGiven) {
  const Pose start{{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}};
  EXPECT_EQ(turned_chain(start, {1, 2, 3}, {4, 5, 6})[0].start.position, start.position);
  EXPECT_EQ(chain_between(start, {{4, 5, 6}, {}})[0].end.position, (Point{4, 5, 6}));
}

/// How much of the turn is done at t: a unit quaternion goes straight from (1, 0, 0, 0), and is normalized.
Real part_by_nlerp(Real angle, Real t) {
  const Real half = angle / 2;
  return std::atan2(t * std::sin(half), 1 - t + t * std::cos(half)) / half;
}

TEST(Motions, ThatBlendQuaternionsStayAsNearAsTheBoundSays) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const double size = i % 2 == 0 ? 1.8 : 0.01;
    const Pose start = random_pose(random);
    const RigidChain chain = chain_between(start, {{}, random.point_between(-size, size)});
    const Point turn = chain[0].end.rotation;
    const double bound = nlerp_deviation({}, {{}, turn});
    const RealPoint x = real_of(random.point_between(-1, 1)), axis = real_of(turn);
    const RealPoint arm{axis[1] * x[2] - axis[2] * x[1], axis[2] * x[0] - axis[0] * x[2],
                        axis[0] * x[1] - axis[1] * x[0]};  // across the axis
    Real farthest = 0;
    for (int k = 1; k < 64; ++k) {
      const Real t = k / Real(64), part = part_by_nlerp(norm_of(axis), t);
      farthest = std::max(farthest, norm_of(plus_part(rotated(turn, part, arm), -1, rotated(turn, t, arm))));
    }
    EXPECT_LE(farthest, bound * norm_of(arm) + 1e-17L);
    EXPECT_GE(farthest, 0.25 * bound * norm_of(arm) - 1e-17L);
  }
  EXPECT_EQ(nlerp_deviation({}, {}), 0);
  EXPECT_THROW((void)nlerp_deviation({}, {{}, {std::nan(""), 0, 0}}), InvalidPath);
}

/// Chains as long as an arm's. Errors are sharp enough to be of use, and deviations hold on pieces.
TEST(Motions, OfChainsAreWithinTheirErrorsAndDeviations) {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    RigidChain chain;
    for (int link = 0; link < 1 + i % 8; ++link) chain.push_back({random_pose(random), random_pose(random)});
    const Point x = random.point_between(-2, 2);
    const RigidPath path({x}, {0}, {chain});
    const std::array<Index, 1> vertex{0};
    for (const double t : {0.0, 0.37, 0.5, 1.0}) {
      Point point{};
      double error = 0;
      path.points_at(t, vertex, {&point, 1}, {&error, 1});
      const RealPoint expected = on_chain(chain, x, t);
      for (std::size_t k = 0; k < 3; ++k) EXPECT_LE(std::fabs(point[k] - expected[k]), error + 1e-17L);
      EXPECT_LT(error, 4e-12);
    }
    const double from = 0.4, to = 0.4 + 0.05 * (1 + i % 5);
    double deviation = 0;
    path.deviations(from, to, vertex, {&deviation, 1});
    for (int k = 1; k < 16; ++k) {
      const Real part = k / Real(16);
      const RealPoint chord = part_way(on_chain(chain, x, from), on_chain(chain, x, to), part);
      const RealPoint curve = on_chain(chain, x, from + part * (Real(to) - from));
      EXPECT_LE(norm_of(plus_part(curve, -1, chord)), deviation + 1e-16L);
    }
  }
}

}  // namespace
}  // namespace tamis::test
