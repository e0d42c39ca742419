#include "planners/scene.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace tamis::planners {
namespace {

using Random = std::mt19937_64;
double any(Random& random) { return std::uniform_real_distribution<double>(-1, 1)(random); }

/// A rough ball of about so many triangles, stretched and moved.
scenes::Shape rough(int triangles, const Point& half, const Point& middle) {
  scenes::Shape shape = scenes::unit_sphere(static_cast<Index>(std::max(1., std::sqrt(triangles / 12.))));
  for (Point& p : shape.points) {
    const double bump = 1 + 0.03 * std::sin(9 * p[0]) * std::sin(8 * p[1] + 7 * p[2]);
    for (std::size_t k = 0; k < 3; ++k) p[k] = middle[k] + bump * half[k] * p[k];
  }
  return shape;
}

scenes::Shape box(const Point& half, const Point& middle) {
  scenes::Shape shape = scenes::unit_cube(1);
  Point low = shape.points[0], high = low;
  for (const Point& p : shape.points)
    for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
  for (Point& p : shape.points)
    for (std::size_t k = 0; k < 3; ++k) p[k] = middle[k] + half[k] * (2 * (p[k] - low[k]) / (high[k] - low[k]) - 1);
  return shape;
}

}  // namespace

/// The lengths are those of a common arm of 0.85 m.
Scene make_scene(int triangles) {
  Scene scene;
  const std::array<Point, kAxes> places{
      {{0, 0, 0.09}, {0, 0.13, 0}, {0, -0.12, 0.425}, {0, 0, 0.39}, {0, 0.1, 0}, {0, 0, 0.1}}};
  const std::array<Point, kAxes> axes{{{0, 0, 1}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 0}}};
  const std::array<Point, kAxes> halves{{{0.06, 0.07, 0.08},
                                         {0.06, 0.06, 0.26},
                                         {0.05, 0.05, 0.23},
                                         {0.04, 0.06, 0.05},
                                         {0.04, 0.05, 0.06},
                                         {0.03, 0.09, 0.03}}};
  const std::array<Point, kAxes> middles{
      {{0, 0, 0}, {0, 0, 0.2}, {0, 0, 0.2}, {0, 0.04, 0}, {0, 0, 0.04}, {0, 0.1, 0}}};
  for (std::size_t k = 0; k < kAxes; ++k) {
    const auto number = static_cast<Index>(k);
    scene.joints.push_back({number - 1, {places[k], {}}, JointKind::turning, axes[k], number});
    scene.links.push_back(rough(triangles, halves[k], middles[k]));
    for (std::size_t i = 0; i + 2 < k; ++i) scene.self_pairs.push_back({i, k});
  }
  scene.obstacles.push_back(box({0.9, 0.9, 0.02}, {0, 0, -0.12}));    // the table
  scene.obstacles.push_back(box({0.25, 0.5, 0.01}, {0.6, 0, 0.55}));  // a board
  scene.obstacles.push_back(box({0.02, 0.5, 0.3}, {0.85, 0, 0.25}));
  Random random(5);
  for (int i = 0; i < 12; ++i) {
    const double angle = 3.14 * any(random), way = 0.5 + 0.2 * any(random), height = 0.45 + 0.4 * any(random);
    scene.obstacles.push_back(
        rough(triangles, {0.07, 0.07, 0.07}, {way * std::cos(angle), way * std::sin(angle), height}));
  }
  return scene;
}

Edges random_edges(std::size_t count, double radians, std::uint64_t seed) {
  Random random(seed);
  Edges edges;
  for (std::size_t i = 0; i < count; ++i) {
    std::array<double, kAxes> start{}, way{};
    double square = 0;
    for (std::size_t k = 0; k < kAxes; ++k) {
      start[k] = 2.5 * any(random);
      way[k] = 2.5 * any(random) - (radians > 0 ? 0 : start[k]);
      square += way[k] * way[k];
    }
    const double factor = radians > 0 ? radians / std::sqrt(square) : 1;
    for (std::size_t k = 0; k < kAxes; ++k) {
      edges.starts.push_back(start[k]);
      edges.ends.push_back(start[k] + factor * way[k]);
    }
  }
  return edges;
}

}  // namespace tamis::planners
