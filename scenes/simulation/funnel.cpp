// Cloth lies on a funnel; a ball presses it down through the spout.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/random.hpp"
#include "scenes/simulation/scenes.hpp"

namespace tamis::simulation {
namespace {

constexpr double kClothSide = 0.7;
constexpr double kBallRadius = 0.06;
constexpr double kSpoutRadius = 0.085;
constexpr double kSpoutLength = 0.45;
constexpr double kFlareRadius = 0.1;                    ///< of the rounded throat
constexpr double kSlope = std::numbers::pi / 180 * 35;  ///< of the cone, against the horizontal
constexpr double kConeLength = 0.55;                    ///< along the slope
constexpr double kBallStart = 0.5, kBallSpeed = 0.27;   ///< above the throat, metres; downwards, metres a second

/// From the spout's lower end over the throat (z = 0) up the cone.
std::vector<Vec> profile(Index rows) {
  std::vector<Vec> points;
  const Index spout = rows / 3, flare = rows / 4, cone = rows - spout - flare;
  for (Index i = 0; i < spout; ++i) points.emplace_back(kSpoutRadius, 0, -kSpoutLength * (spout - i) / spout);
  const double turn = std::numbers::pi / 2 - kSlope;
  for (Index i = 0; i < flare; ++i) {
    const double angle = turn * i / flare;
    points.emplace_back(kSpoutRadius + kFlareRadius * (1 - std::cos(angle)), 0, kFlareRadius * std::sin(angle));
  }
  const Vec foot(kSpoutRadius + kFlareRadius * (1 - std::cos(turn)), 0, kFlareRadius * std::sin(turn));
  for (Index i = 0; i <= cone; ++i)
    points.push_back(foot + kConeLength * i / cone * Vec(std::cos(kSlope), 0, std::sin(kSlope)));
  return points;
}

}  // namespace

Model funnel(Index triangles, std::uint64_t seed) {
  Model model;
  const auto segments = static_cast<Index>(std::clamp(std::sqrt(triangles / 8.0), 24.0, 60.0));
  const Surface cone = revolved(profile(segments / 2), segments, false);
  const auto ball_cells = static_cast<Index>(std::clamp(std::sqrt(triangles / 200.0), 4.0, 12.0));
  const Vec above(0, 0, kBallStart);
  const Surface sphere = mapped(ball(ball_cells, kBallRadius), [&](const Vec& p) -> Vec { return p + above; });
  const auto obstacles = static_cast<Index>(cone.faces.size() + sphere.faces.size());
  const auto cells = static_cast<Index>(std::sqrt(std::max(200.0, (triangles - obstacles) / 2.0)));
  const double edge = kClothSide / cells;

  scenes::Random random(seed);
  const Surface sheet = square(cells, kClothSide);
  const double height = kBallStart - kBallRadius - edge;
  model.add_cloth(
      mapped(sheet, [&](const Vec& p) -> Vec { return p + Vec(0, 0, height - random.between(0, 0.1 * edge)); }), sheet,
      {0.2, 2000, 1e-5});
  model.add_obstacle(sphere,
                     [](double time) { return Eigen::Isometry3d(Eigen::Translation3d(0, 0, -kBallSpeed * time)); });
  model.add_obstacle(cone, at_rest);
  model.thickness = 0.3 * edge;
  model.friction = 0.35;
  return model;
}

}  // namespace tamis::simulation
