// Pairs whose first time of touching is known by hand: every degeneracy that public codes have been seen to miss.
#include <gtest/gtest.h>

#include <cmath>

#include "pair/exact/exact.hpp"

namespace tamis {
namespace {

using Points = std::array<Point, 4>;

Decision vf(const Points& start, const Points& end) { return decide_exactly(PairKind::vertex_face, {start, end}); }
Decision ee(const Points& start, const Points& end) { return decide_exactly(PairKind::edge_edge, {start, end}); }

void expect_free(const Decision& decision) { EXPECT_FALSE(decision.touches()); }

/// The first time is the double `time`.
void expect_at(double time, const Decision& decision) {
  EXPECT_TRUE(decision.touches());
  EXPECT_EQ(decision.lower, time);
  EXPECT_EQ(decision.upper, time);
}

/// The first time is not a double and lies within half a spacing of `nearest`.
void expect_near(double nearest, const Decision& decision) {
  EXPECT_TRUE(decision.touches());
  EXPECT_EQ(decision.upper, std::nextafter(decision.lower, 2.0));
  EXPECT_TRUE(decision.lower == nearest || decision.upper == nearest);
}

const Points kFace{{{0, 0, 0}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};

/// The vertex moves, the face (0,0,0), (4,0,0), (0,4,0) stands still.
Decision point_to_face(const Point& from, const Point& to) {
  Points start = kFace, end = kFace;
  start[0] = from;
  end[0] = to;
  return vf(start, end);
}

/// Edge a moves, edge b from (-1,0,0) to (1,0,0) stands still.
Decision edge_to_edge(const std::array<Point, 2>& from, const std::array<Point, 2>& to) {
  const Point b0{-1, 0, 0}, b1{1, 0, 0};
  return ee({from[0], from[1], b0, b1}, {to[0], to[1], b0, b1});
}

TEST(ExactTime, is_a_double_where_the_root_is_one) {
  expect_at(0.5, point_to_face({1, 1, 1}, {1, 1, -1}));
  expect_at(0.25, point_to_face({1, 1, 1}, {1, 1, -3}));
  expect_at(0x1p-40, point_to_face({1, 1, 0x1p-60}, {1, 1, 0x1p-60 - 0x1p-20}));
}

TEST(ExactTime, is_enclosed_by_neighbours_where_the_root_is_rational) {
  expect_near(1.0 / 3, point_to_face({1, 1, 1}, {1, 1, -2}));
  expect_near(1e-300 / (1e-300 + 1), point_to_face({1, 1, 1e-300}, {1, 1, -1}));
}

/// The face (0,0,0), (4,0,0), (0,4,0) tilts: its plane is z = t x. The vertex goes from `from` to `to`.
Decision point_to_tilting_face(const Point& from, const Point& to) {
  Points start = kFace, end = kFace;
  end[2][2] = 4;
  start[0] = from;
  end[0] = to;
  return vf(start, end);
}

TEST(ExactTime, is_enclosed_by_neighbours_where_the_root_is_irrational) {
  // x = t and z = 1 - t meet z = t x where t^2 + t = 1.
  expect_near((std::sqrt(5.0) - 1) / 2, point_to_tilting_face({0, 1, 1}, {1, 1, 0}));
}

TEST(ExactTime, counts_both_ends_of_the_step) {
  expect_at(0, point_to_face({1, 1, 0}, {1, 1, 5}));
  expect_at(1, point_to_face({1, 1, 5}, {1, 1, 0}));
  expect_free(point_to_face({1, 1, 5}, {1, 1, 0x1p-1000}));
}

TEST(ExactTime, is_of_the_first_touching_root_not_of_the_first_root) {
  // In the plane at t = 1/4, where x = -1, and at t = 3/4, where x = 1.
  expect_at(0.75, point_to_tilting_face({-2, 1, -0.75}, {2, 1, 1.25}));
}

TEST(ExactVertexFace, touches_on_the_closed_boundary_only) {
  expect_at(0.5, point_to_face({0, 0, 1}, {0, 0, -1}));
  expect_at(0.5, point_to_face({2, 2, 1}, {2, 2, -1}));
  expect_at(0.5, point_to_face({4, 0, 1}, {4, 0, -1}));
  expect_free(point_to_face({2, 2 + 0x1p-51, 1}, {2, 2 + 0x1p-51, -1}));
  expect_free(point_to_face({-0x1p-1074, 1, 1}, {-0x1p-1074, 1, -1}));
}

TEST(ExactVertexFace, sees_touch_and_go) {
  // The height over the plane is -(t - 1/2)^2: a double root. Lower by 2^-53 there is none, higher there are two.
  constexpr double tiny = 0x1p-53;
  expect_at(0.5, point_to_tilting_face({0, 1, -0.25}, {1, 1, 0.75}));
  expect_free(point_to_tilting_face({0, 1, -0.25 - tiny}, {1, 1, 0.75 - tiny}));
  expect_near(0.5 - std::sqrt(tiny), point_to_tilting_face({0, 1, -0.25 + tiny}, {1, 1, 0.75 + tiny}));
}

TEST(ExactVertexFace, sees_a_triple_root) {
  const Points start{{{1, 1, 1}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  Points end = start;
  for (Point& point : end)
    for (double& x : point) x = -x;
  expect_at(0.5, vf(start, end));  // everything in one point, and K = c (1-2t)^3
}

TEST(ExactEdgeEdge, sees_touch_and_go) {
  // K = 4 (1-2t)^2, and edge b shrinks to a point on edge a at that time.
  expect_at(0.5,
            ee({{{0, -1, 0}, {0, 1, 0}, {-1, 0, 1}, {-1, 0, -1}}}, {{{0, -1, 0}, {0, 1, 0}, {1, 0, -1}, {1, 0, 1}}}));
}

TEST(ExactEdgeEdge, touches_at_end_points_only_when_closed) {
  expect_at(0.5, edge_to_edge({{{1, -1, 1}, {1, 1, 1}}}, {{{1, -1, -1}, {1, 1, -1}}}));
  expect_at(0.5, edge_to_edge({{{1, 0, 1}, {1, 1, 1}}}, {{{1, 0, -1}, {1, 1, -1}}}));
  expect_free(
      edge_to_edge({{{1 + 0x1p-52, -1, 1}, {1 + 0x1p-52, 1, 1}}}, {{{1 + 0x1p-52, -1, -1}, {1 + 0x1p-52, 1, -1}}}));
}

TEST(ExactCoplanar, point_slides_into_the_face_in_its_plane) {
  expect_at(0.5, point_to_face({-1, 1, 0}, {1, 1, 0}));
  expect_near(1.0 / 3, point_to_face({-1, 1, 0}, {2, 1, 0}));
  expect_free(point_to_face({-1, 1, 0}, {-0x1p-1000, 1, 0}));
  expect_free(point_to_face({-1, 0, 0}, {0, -1, 0}));
  expect_at(0.5, point_to_face({-1, 1, 0}, {1, -1, 0}));  // passes the corner only
}

TEST(ExactCoplanar, point_leaves_and_static_pairs_touch_at_the_start) {
  expect_at(0, point_to_face({1, 1, 0}, {-5, 1, 0}));
  expect_at(0, point_to_face({1, 1, 0}, {1, 1, 0}));
  expect_free(point_to_face({3, 3, 0}, {3, 3, 0}));
  expect_free(point_to_face({1, 1, 1}, {1, 1, 1}));
}

TEST(ExactCoplanar, edges_slide_in_a_plane) {
  expect_at(0.5, edge_to_edge({{{0, 1, 0}, {0, 2, 0}}}, {{{0, -1, 0}, {0, 0, 0}}}));
  expect_at(0.5, edge_to_edge({{{0, 1, 0}, {1, 1, 0}}}, {{{0, -1, 0}, {1, -1, 0}}}));  // parallel
  expect_at(0, edge_to_edge({{{0, 1, 0}, {0, -2, 0}}}, {{{0, 9, 0}, {0, 7, 0}}}));     // crosses at the start
  expect_free(edge_to_edge({{{2, 1, 0}, {2, 2, 0}}}, {{{2, -1, 0}, {2, 0, 0}}}));
}

TEST(ExactCoplanar, edges_slide_along_one_line) {
  expect_at(0.5, edge_to_edge({{{2, 0, 0}, {3, 0, 0}}}, {{{0, 0, 0}, {1, 0, 0}}}));
  expect_near(1.0 / 3, edge_to_edge({{{2, 0, 0}, {3, 0, 0}}}, {{{-1, 0, 0}, {0, 0, 0}}}));
  expect_free(edge_to_edge({{{2, 0, 0}, {3, 0, 0}}}, {{{1.5, 0, 0}, {9, 0, 0}}}));
  expect_at(1, edge_to_edge({{{2, 0, 0}, {3, 0, 0}}}, {{{1, 0, 0}, {9, 0, 0}}}));
  expect_at(0, edge_to_edge({{{-5, 0, 0}, {5, 0, 0}}}, {{{-5, 0, 0}, {5, 0, 0}}}));
}

TEST(ExactDegenerate, edges_of_no_length) {
  expect_at(0.5, edge_to_edge({{{0.5, 0, 1}, {0.5, 0, 1}}}, {{{0.5, 0, -1}, {0.5, 0, -1}}}));
  expect_free(edge_to_edge({{{1.5, 0, 1}, {1.5, 0, 1}}}, {{{1.5, 0, -1}, {1.5, 0, -1}}}));
  const Point p{1, 2, 3}, q{3, 2, 1}, r{5, 2, -1};
  expect_at(0.5, ee({p, p, q, q}, {r, r, q, q}));  // two points
  expect_at(0, ee({q, q, q, q}, {p, p, r, r}));    // all in one point
  expect_free(ee({p, p, q, q}, {p, p, r, r}));
}

TEST(ExactDegenerate, faces_of_no_area) {
  const Points needle{{{1, 0, 1}, {0, 0, 0}, {2, 0, 0}, {1, 0, 0}}};
  Points end = needle;
  end[0] = {1, 0, -1};
  expect_at(0.5, vf(needle, end));
  end[0] = {1, 1, -1};
  expect_free(vf(needle, end));
  const Points dot{{{1, 1, 1}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
  end = dot;
  end[0] = {-1, -1, -1};
  expect_at(0.5, vf(dot, end));
  end[0] = {-1, -1, 0};
  expect_free(vf(dot, end));
}

TEST(ExactDegenerate, face_that_degenerates_just_when_the_point_meets_its_plane) {
  // Corner c crosses side ab at t = 1/2, and the point meets that line at the same time.
  const Points start{{{1, 0, 1}, {0, 0, 0}, {2, 0, 0}, {1, 1, 0}}};
  Points end{{{1, 0, -1}, {0, 0, 0}, {2, 0, 0}, {1, -1, 0}}};
  expect_at(0.5, vf(start, end));
  end[0][0] = 5;  // at x = 3: on the line, off the face
  expect_free(vf(start, end));
}

TEST(ExactRange, mixes_the_smallest_and_largest_doubles) {
  expect_near(1.0 / 3, point_to_face({1e-300, 1e-300, 1e300}, {1e-300, 1e-300, -2e300}));
  expect_free(point_to_face({-1e-300, 1e-300, 1e300}, {-1e-300, 1e-300, -2e300}));
  expect_at(0.5, point_to_face({0x1p-1074, 0x1p-1074, 0x1p1023}, {0x1p-1074, 0x1p-1074, -0x1p1023}));
}

TEST(ExactRange, tells_nearly_equal_times_apart) {
  // At t = 1/3 the point meets the plane at x = 0; the face's side there lies beside it by 2^-900, or exactly at it.
  const auto with_side_at = [](double x) {
    const Point a{x, 0, 0}, b{4, 0, 0}, c{x, 4, 0};
    return vf({{{-1, 1, 1}, a, b, c}}, {{{2, 1, -2}, a, b, c}});
  };
  expect_near(1.0 / 3, with_side_at(-0x1p-900));
  expect_near(1.0 / 3, with_side_at(0));
  expect_free(with_side_at(0x1p-900));
}

}  // namespace
}  // namespace tamis
