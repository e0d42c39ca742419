// Contours whose self-intersection is known by hand.
#include "paper/filters/contour_test.hpp"

#include <gtest/gtest.h>

#include "support/contracts.hpp"

namespace tamis::lab {
namespace {

const Vec3<double> kUp{0, 0, 1};

using Loop = std::vector<Moving<double>>;

Loop still(const std::vector<Vec3<double>>& points) {
  Loop loop;
  for (const auto& p : points) loop.push_back({p, p});
  return loop;
}

ProjectedContour projected(const Loop& loop, const Vec3<double>& axis = kUp) {
  ProjectedContour contour;
  contour.project(loop, axis);
  return contour;
}

const Loop kSquare = still({{-1, -1, 0}, {1, -1, 0.5}, {1, 1, 0}, {-1, 1, -0.5}});

TEST(contour, a_convex_loop_passes_both_tests) {
  EXPECT_TRUE(projected(kSquare).proves_star_shaped());
  EXPECT_TRUE(projected(kSquare).proves_simple());
}

TEST(contour, a_loop_seen_from_below_is_no_star_but_simple) {
  EXPECT_FALSE(projected(kSquare, {0, 0, -1}).proves_star_shaped());
  EXPECT_TRUE(projected(kSquare, {0, 0, -1}).proves_simple());
}

TEST(contour, points_on_a_straight_side_do_not_count_as_a_fold) {
  const auto contour = projected(still({{-1, -1, 0}, {0, -1, 0}, {0.5, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}));
  EXPECT_TRUE(contour.proves_star_shaped());
  EXPECT_TRUE(contour.proves_simple());
}

TEST(contour, a_crescent_is_simple_but_no_star) {
  const auto contour = projected(still({{-2, 0, 0}, {0, -1.5, 0}, {2, 0, 0}, {0, -1.2, 0}}));
  EXPECT_FALSE(contour.proves_star_shaped());
  EXPECT_TRUE(contour.proves_simple());
}

TEST(contour, a_figure_of_eight_fails_both_tests) {
  const auto contour = projected(still({{-1, -1, 0}, {1, 1, 0}, {1, -1, 0}, {-1, 1, 0}}));
  EXPECT_FALSE(contour.proves_star_shaped());
  EXPECT_FALSE(contour.proves_simple());
}

TEST(contour, a_loop_that_winds_twice_is_no_star_though_every_edge_turns_left) {
  // The bug this would catch: counting the turns of the edges and not the turns of the whole.
  const auto contour =
      projected(still({{2, 0, 0}, {0, 2, 0}, {-2, 0, 0}, {0, -2, 0}, {1, 0, 1}, {0, 1, 1}, {-1, 0, 1}, {0, -1, 1}}));
  EXPECT_FALSE(contour.proves_star_shaped());
  EXPECT_FALSE(contour.proves_simple());
}

TEST(contour, a_loop_that_folds_only_on_the_way_fails_both_tests) {
  // Two corners change places and come back to a convex loop: at both ends all is well.
  Loop loop = kSquare;
  loop[0].at1 = kSquare[2].at0;
  loop[1].at1 = kSquare[3].at0;
  loop[2].at1 = kSquare[0].at0;
  loop[3].at1 = kSquare[1].at0;
  EXPECT_FALSE(projected(loop).proves_star_shaped());
  EXPECT_FALSE(projected(loop).proves_simple());
}

TEST(contour, a_vertex_that_touches_another_edge_is_not_proven_apart) {
  const auto contour = projected(still({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {0, -1, 1}, {-1, 1, 0}}));
  EXPECT_FALSE(contour.proves_star_shaped());
  EXPECT_FALSE(contour.proves_simple());
}

using ContourContracts = test::Contracts;

TEST_F(ContourContracts, AContourOfTwoPoints) {
  const Moving<double> points[2] = {};
  ProjectedContour contour;
  EXPECT_DEATH(contour.project(points, {0, 0, 1}), "loop.size");
}

}  // namespace
}  // namespace tamis::lab
