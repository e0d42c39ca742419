// Features that slide on each other in parallel planes while one of them turns about the normal, which lies askew.
// Coordinates are whole multiples of the same power of two, so that the planes' distance is exactly what it is told.
#include <gtest/gtest.h>

#include <cmath>

#include "curves/paths/counted_path.hpp"
#include "curves/paths/turning_pairs.hpp"
#include "tamis/error.hpp"

namespace tamis::test {
namespace {

constexpr Point kNormal{1, 2, 2}, kAcross{2, -1, 0}, kAlso{2, 0, -1};
constexpr std::array<Index, 4> kVertices{0, 1, 2, 3};

/// In the plane through the origin, lifted along the normal by `height` times its length, 3.
Point in_plane(double a, double b, double height) {
  Point x{};
  for (std::size_t k = 0; k < 3; ++k) x[k] = a * kAcross[k] + b * kAlso[k] + height * kNormal[k];
  return x;
}

/// The first feature turns about the normal.
RigidPath sliding(Random& random, PairKind kind, double height) {
  const Index second = kind == PairKind::vertex_face ? 1 : 2;
  std::vector<Point> points;
  std::vector<Index> bodies;
  for (Index v = 0; v < 4; ++v) {
    const double a = (random.below(513) - 256) / 256.0, b = (random.below(513) - 256) / 256.0;
    points.push_back(in_plane(a, b, v < second ? height : 0));
    bodies.push_back(v < second ? 0 : 1);
  }
  return {points, bodies, {{{{}, {{0, 0, 0}, {0.25, 0.5, 0.5}}}}, {}}};
}

PairResult ask(const Path& path, PairKind kind, double separation) {
  return kind == PairKind::vertex_face ? vertex_face(path, kVertices, {.min_separation = separation})
                                       : edge_edge(path, kVertices, {.min_separation = separation});
}

// Bug: a gap is found on parts of the step so short that curves deviate from chords by less, 10^5 of a gap of 1e-12.
TEST(Sliding, IsDecidedOnAFewParts) {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const PairKind kind = random.coin() ? PairKind::vertex_face : PairKind::edge_edge;
    const double height = std::ldexp(1.0, -10 - random.below(35));
    const double separation = random.coin() ? 0 : 0.125;
    const RigidPath path = sliding(random, kind, height + separation);  // 3 times as far apart
    const CountedPath counted(path);
    EXPECT_FALSE(ask(counted, kind, 3 * separation).touches) << i;
    EXPECT_LT(counted.asked, 300) << i;
  }
}

// Bug: what is apart by exactly the separation is cut without end where two neighbouring doubles are left.
TEST(Sliding, AtExactlyTheSeparationEnds) {
  Random random(2);
  int touching = 0;
  for (int i = 0; i < 300; ++i) {
    const PairKind kind = random.coin() ? PairKind::vertex_face : PairKind::edge_edge;
    const RigidPath path = sliding(random, kind, 0.125);
    const CountedPath counted(path);
    touching += ask(counted, kind, 3 * 0.125).touches;
    EXPECT_LT(counted.asked, 1000) << i;
  }
  EXPECT_GT(touching, 30);
}

// Bug: what touches where it starts is cut a hundred times to find that out.
TEST(Sliding, WhatTouchesAtTheStartIsKnownAtOnce) {
  Random random(3);
  int touching = 0;
  for (int i = 0; i < 300; ++i) {
    const PairKind kind = random.coin() ? PairKind::vertex_face : PairKind::edge_edge;
    const RigidPath path = sliding(random, kind, 0);
    const CountedPath counted(path);
    const PairResult result = ask(counted, kind, 0);
    if (!result.touches || result.toi_lower > 0) continue;
    ++touching;
    EXPECT_LT(result.toi_upper, 1e-15) << i;
    EXPECT_LT(counted.asked, 10) << i;
  }
  EXPECT_GT(touching, 30);
}

/// The direction of a point of a body that goes by this chain.
Point direction_of(const RigidChain& chain) {
  const RigidPath path({{1, 2, 3}}, {0}, {chain});
  Point direction{9, 9, 9};
  path.straight_directions(std::array<Index, 1>{0}, {&direction, 1});
  return direction;
}

// Bug: a point is taken to go straight along the axis of one link while another one turns it away.
TEST(Sliding, DirectionsAreAxesThatStay) {
  const Pose none{}, skew{{1, 2, 3}, {0.1, 0.2, 0.2}}, further{{2, 2, 2}, {0.2, 0.4, 0.4}}, other{{0, 0, 0}, {0, 1, 0}};
  const Point axis{0.1, 0.2, 0.2}, no_axis{0, 0, 0};
  EXPECT_EQ(direction_of({{none, skew}}), axis);
  EXPECT_EQ(direction_of({{skew, further}}), axis);
  EXPECT_EQ(direction_of({{none, skew}, {other, other}}), axis) << "what lies within may be turned";
  EXPECT_EQ(direction_of({{none, skew}, {none, none}, {further, skew}}), axis);
  EXPECT_EQ(direction_of(turned_chain(other, axis, {5, 5, 5}, {1, 0, 0})), axis);
  EXPECT_EQ(direction_of({{skew, other}}), no_axis);
  EXPECT_EQ(direction_of({{other, other}, {none, skew}}), no_axis);
  EXPECT_EQ(direction_of({{none, skew}, {none, other}}), no_axis);
  EXPECT_EQ(direction_of({{skew, {{0, 0, 0}, {0.3, 0.6, 0.6 * (1 + 0x1p-52)}}}}), no_axis);
  EXPECT_EQ(direction_of({{none, {{0, 0, 0}, {1e-200, 1e-200, 0}}}, {none, {{0, 0, 0}, {1e-200, 3e-200, 0}}}}),
            no_axis);
  EXPECT_EQ(direction_of({{none, {{1, 1, 1}, {0, 0, 0}}}}), no_axis) << "it goes straight in all directions";
}

}  // namespace
}  // namespace tamis::test
