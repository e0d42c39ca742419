// What a displacement gradient explains, and how far it may shrink what it turns and stretches.
#include "search/bounds/displacement_gradient.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace tamis {
namespace {

using Vec = Vec3<double>;

DisplacementGradient turning(double angle, double stretch = 1) {
  const double c = stretch * std::cos(angle), s = stretch * std::sin(angle);
  return {{{{c - 1, -s, 0}, {s, c - 1, 0}, {0, 0, 0}}}};
}

double least_stretch_of(const DisplacementGradient& gradient) { return stretch_bounds(gradient).least; }

/// Of the vectors (I + t G) x, over many times and unit vectors x.
double shortest(const DisplacementGradient& gradient, std::mt19937& random) {
  std::normal_distribution<double> normal;
  double shortest2 = 1;
  for (int i = 0; i < 20'000; ++i) {
    const Vec x{normal(random), normal(random), normal(random)};
    const Vec moved = x + (i % 101 / 100.0) * gradient.at(x);
    shortest2 = std::min(shortest2, dot(moved, moved) / dot(x, x));
  }
  return std::sqrt(shortest2);
}

// Half a turn leads all through one line.
TEST(DisplacementGradient, ATurnShrinksByTheCosineOfItsHalf) {
  for (const double angle : {0.0, 0.1, 1.0, 2.0, 3.0, 3.141592653589793}) {
    EXPECT_LE(least_stretch_of(turning(angle)), std::cos(angle / 2) + 1e-15) << angle;
    EXPECT_GE(least_stretch_of(turning(angle)), std::cos(angle / 2) - 0.1 * (1 - std::cos(angle / 8)) - 0.02) << angle;
  }
  EXPECT_NEAR(least_stretch_of(turning(1.0, 0.25)), 0.25, 1e-3);
}

// Bug: a bound that holds for turns alone.
TEST(DisplacementGradient, NothingShrinksMoreThanTheBound) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> entry(-0.8, 0.8);
  for (int i = 0; i < 200; ++i) {
    DisplacementGradient gradient;
    for (Vec& row : gradient.rows) row = {entry(random), entry(random), entry(random)};
    const double truth = shortest(gradient, random), bound = least_stretch_of(gradient);
    EXPECT_LE(bound, truth) << i;
    EXPECT_GE(bound, truth > 0.3 ? truth - 0.15 : 0) << i << ": says nothing";
  }
}

TEST(DisplacementGradient, IsNoneOfWhatIsNotANumber) {
  DisplacementGradient gradient;
  gradient.rows[1].y = std::nan("");
  EXPECT_EQ(least_stretch_of(gradient), 0);
  gradient.rows[1].y = 1e300;
  EXPECT_EQ(least_stretch_of(gradient), 0);
}

TEST(DisplacementGradient, NothingGrowsMoreThanTheBound) {
  EXPECT_NEAR(stretch_bounds(turning(1.0)).greatest, 1, 1e-9);
  EXPECT_GE(stretch_bounds(turning(0.5, 1.5)).greatest, 1.5);
  EXPECT_LE(stretch_bounds(turning(0.5, 1.5)).greatest, 1.5 + 1e-9);
}

// Bug: a point, or a line, whose gradient is anything, spoils that of all others.
TEST(DisplacementGradient, OfAPointOrALineIsSmall) {
  const std::vector<Point> start{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}},
      end{{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 3}};
  const std::vector<Index> all{0, 1, 2, 3}, one{2};
  PackedMotion motion;
  motion.assign({start, end}, all, {});
  const DisplacementGradient line = fit_gradient(motion, all, 1).gradient;
  for (const Vec& row : line.rows) EXPECT_LT(dot(row, row), 1.01);
  EXPECT_GE(stretch_bounds(fit_gradient(motion, one, 3).gradient).least, 0.999);
}

// Bug: a gradient transposed, or not about the middle.
TEST(DisplacementGradient, ExplainsWhatTurnsAsAWhole) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<Point> start, end;
  std::vector<Index> all;
  for (Index v = 0; v < 3000; ++v) {
    const Vec x{coordinate(random) + 5, coordinate(random), coordinate(random)};
    const Vec moved = x + turning(1.0).at(x);
    start.push_back({x.x, x.y, x.z});
    end.push_back({moved.x + 2, moved.y, moved.z - 3});
    all.push_back(v);
  }
  PackedMotion motion;
  motion.assign({start, end}, all, {});
  const GradientFit fit = fit_gradient(motion, all, 3);
  EXPECT_NEAR(fit.gradient.rows[0].y, -std::sin(1.0), 1e-4);
  EXPECT_NEAR(fit.gradient.rows[1].x, std::sin(1.0), 1e-4);
  for (const PackedVertex& vertex : motion.vertices) {
    const Vec place = motion.frame.place(vertex) - fit.mean_position, way = motion.frame.displacement(vertex);
    const Vec residual = way - fit.mean_displacement - fit.gradient.at(place);
    EXPECT_LT(dot(residual, residual), 1e-9);
  }
}

}  // namespace
}  // namespace tamis
