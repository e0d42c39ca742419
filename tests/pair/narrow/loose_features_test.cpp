// A point against an edge, and against a point: by hand. All families of motions: pair_soundness_test.cpp,
// separation_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tamis/error.hpp"
#include "tamis/pair.hpp"

namespace tamis {
namespace {

PairOptions within(double separation) { return {separation}; }

// A point falls past the middle of an edge of length 2 at a distance of 1, on a straight line.
PairResult point_past_edge(double height, const PairOptions& options) {
  return vertex_edge({{{1, -1, 5}, {0, 0, 0}, {2, 0, 0}}}, {{{1, -1, 5 - height}, {0, 0, 0}, {2, 0, 0}}}, options);
}

// Bug: the edge counts as a line, or its ends only.
TEST(LooseEdge, IsTouchedByAPointThatPassesWithinTheSeparation) {
  const PairResult r = point_past_edge(10, within(std::sqrt(2.0)));
  ASSERT_TRUE(r.touches);
  EXPECT_NEAR(r.toi_lower, 0.4, 1e-9);  // at height 1
  EXPECT_LE(r.toi_lower, r.toi_upper);
  EXPECT_DOUBLE_EQ(r.u, 0.5);
  EXPECT_EQ(r.v, 0);
  EXPECT_NEAR(r.normal[1], -std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(r.normal[2], std::sqrt(0.5), 1e-6);
  EXPECT_FALSE(point_past_edge(10, within(0.99)).touches);
  EXPECT_FALSE(point_past_edge(2, within(1.5)).touches);
}

// Bug: beyond its ends the edge goes on, or is cut off flat.
TEST(LooseEdge, EndsInHalfCircles) {
  const std::array<Point, 3> start{{{3, 0, 5}, {0, 0, 0}, {2, 0, 0}}}, end{{{3, 0, -5}, {0, 0, 0}, {2, 0, 0}}};
  EXPECT_FALSE(vertex_edge(start, end, within(0.999)).touches);
  const PairResult r = vertex_edge(start, end, within(1.25));
  ASSERT_TRUE(r.touches);
  EXPECT_NEAR(r.toi_upper, 0.425, 1e-9);  // at height 0.75
  EXPECT_EQ(r.u, 1);
}

// Bug: without a separation nothing is ever proven to touch, so that it comes out unresolved, or not at all.
TEST(LooseFeatures, TouchExactlyOrNotAtAll) {
  const auto through_edge = [](double x) {
    return vertex_edge({{{x, 0, 1}, {0, 0, 0}, {2, 0, 0}}}, {{{x, 0, -1}, {0, 0, 0}, {2, 0, 0}}}, within(0));
  };
  for (const double x : {0.0, 0.1, 2.0}) {
    EXPECT_EQ(through_edge(x).certainty, Certainty::certified);
    EXPECT_EQ(through_edge(x).toi_lower, 0.5);
    EXPECT_EQ(through_edge(x).toi_upper, 0.5);
  }
  EXPECT_FALSE(through_edge(std::nextafter(2.0, 3.0)).touches);
  EXPECT_FALSE(through_edge(-std::numeric_limits<double>::denorm_min()).touches);
  const PairResult r = vertex_vertex({{{1, 2, 3}, {3, 2, 1}}}, {{{5, 2, -1}, {3, 2, 1}}}, within(0));
  EXPECT_TRUE(r.touches);
  EXPECT_EQ(r.toi_lower, 0.5);
  EXPECT_FALSE(vertex_vertex({{{1, 2, 3}, {3, 2, 1}}}, {{{5, 2, -1}, {3, 2.25, 1}}}, within(0)).touches);
}

TEST(LoosePoints, ComeWithinASeparation) {
  const PairResult r = vertex_vertex({{{0, 0, 0}, {10, 0, 0}}}, {{{0, 0, 0}, {0, 0, 0}}}, within(2.5));
  ASSERT_TRUE(r.touches);
  EXPECT_NEAR(r.toi_lower, 0.75, 1e-12);
  EXPECT_LE(r.toi_upper - r.toi_lower, 1e-12);
  EXPECT_NEAR(r.normal[0], -1, 1e-9);
}

TEST(LooseFeatures, BadCoordinatesAreNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)vertex_edge({{{0, 0, 0}, {0, 0, 0}, {nan, 0, 0}}}, {{}}), InvalidStep);
  EXPECT_THROW((void)vertex_vertex({{{0, 0, 0}, {0, nan, 0}}}, {{}}), InvalidStep);
  EXPECT_THROW((void)vertex_vertex({{}}, {{}}, {-1}), InvalidOptions);
}

}  // namespace
}  // namespace tamis
