// Cloth lies on a funnel; a ball presses it down through the spout.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/random.hpp"
#include "scenes/simulation/scenes.hpp"

namespace tamis::simulation {
namespace {

constexpr double kSheetSide = 0.9;
constexpr double kBallRadius = 0.07;
constexpr double kSpoutRadius = 0.1;
constexpr double kSpoutLength = 0.45;
constexpr double kFlareRadius = 0.1;                    ///< of the rounded throat
constexpr double kSlope = std::numbers::pi / 180 * 20;  ///< of the cone, against the horizontal
constexpr double kConeLength = 0.7;                     ///< along the slope
constexpr double kDescent = 3.2;                        ///< seconds the ball takes to the end of the spout

/// Where the throat, an arc from the upright spout, meets the cone.
Vec foot_of_cone() {
  return {kSpoutRadius + kFlareRadius * (1 - std::sin(kSlope)), 0, kFlareRadius * std::cos(kSlope)};
}

double height_of_cone(double radius) {
  const Vec foot = foot_of_cone();
  return foot.z() + (radius - foot.x()) * std::tan(kSlope);
}

/// From the spout's lower end over the throat (z = 0) up the cone.
std::vector<Vec> profile(Index rows) {
  std::vector<Vec> points;
  const Index spout = rows / 3, flare = rows / 4, cone = rows - spout - flare;
  for (Index i = 0; i < spout; ++i) points.emplace_back(kSpoutRadius, 0, -kSpoutLength * (spout - i) / spout);
  for (Index i = 0; i < flare; ++i) {
    const double angle = (std::numbers::pi / 2 - kSlope) * i / flare;
    points.emplace_back(kSpoutRadius + kFlareRadius * (1 - std::cos(angle)), 0, kFlareRadius * std::sin(angle));
  }
  for (Index i = 0; i <= cone; ++i)
    points.push_back(foot_of_cone() + kConeLength * i / cone * Vec(std::cos(kSlope), 0, std::sin(kSlope)));
  return points;
}

}  // namespace

Model funnel(Index triangles, std::uint64_t seed) {
  Model model;
  const auto segments = static_cast<Index>(std::clamp(std::sqrt(triangles / 8.0), 24.0, 60.0));
  const Surface cone = revolved(profile(segments / 2), segments, false);
  const auto ball_cells = static_cast<Index>(std::clamp(std::sqrt(triangles / 200.0), 4.0, 12.0));
  const auto obstacles = static_cast<Index>(cone.faces.size()) + 12 * ball_cells * ball_cells;
  const auto cells = static_cast<Index>(std::sqrt(std::max(200.0, (triangles - obstacles) / 2.0)));
  const double edge = kSheetSide / cells;
  const double height = height_of_cone(kSheetSide / std::numbers::sqrt2) + edge;
  const double ball_height = height + edge + kBallRadius;

  scenes::Random random(seed);
  const auto laid = [&](const Vec& p) -> Vec { return p + Vec(0, 0, height - random.between(0, 0.1 * edge)); };
  const auto held = [&](const Vec& p) -> Vec { return p + Vec(0, 0, ball_height); };
  const Surface sheet = square(cells, kSheetSide);
  model.add_cloth(mapped(sheet, laid), sheet, {0.2, 2000, 1e-5});
  model.add_obstacle(mapped(ball(ball_cells, kBallRadius), held), [ball_height](double time) {
    return Eigen::Isometry3d(Eigen::Translation3d(0, 0, -(ball_height + kSpoutLength) * time / kDescent));
  });
  model.add_obstacle(cone, at_rest);
  model.thickness = 0.25 * edge;
  model.friction = 0.4;
  return model;
}

}  // namespace tamis::simulation
