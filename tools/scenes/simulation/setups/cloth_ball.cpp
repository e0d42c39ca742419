// Cloth drops over a ball above the floor; the ball starts to turn, and winds the cloth up.
#include <algorithm>
#include <cmath>

#include "scenes/random.hpp"
#include "scenes/simulation/scenes.hpp"

namespace tamis::simulation {
namespace {

constexpr double kRadius = 0.5;
constexpr double kClothSide = 3.0;
constexpr double kClearance = 0.15;  ///< between the floor and the ball
constexpr double kSpinStart = 0.5;   ///< seconds: the cloth has fallen onto the floor
constexpr double kSpinRise = 0.5;    ///< seconds
constexpr double kSpin = 2.0;        ///< radians per second

/// The spin rises linearly, then stays.
double angle_at(double time) {
  const double t = std::max(0.0, time - kSpinStart);
  return t < kSpinRise ? kSpin * t * t / (2 * kSpinRise) : kSpin * (t - kSpinRise / 2);
}

}  // namespace

Model cloth_ball(Index triangles, std::uint64_t seed) {
  Model model;
  const Vec centre(0, 0, kClearance + kRadius);
  const auto ball_cells = static_cast<Index>(std::clamp(std::sqrt(triangles / 60.0 / 12), 4.0, 12.0));
  const Surface floor = square(8, 2 * kClothSide);
  const Surface sphere = mapped(ball(ball_cells, kRadius), [&](const Vec& p) -> Vec { return p + centre; });
  const auto obstacles = static_cast<Index>(floor.faces.size() + sphere.faces.size());
  const auto cells = static_cast<Index>(std::sqrt(std::max(2.0, (triangles - obstacles) / 2.0)));
  const double edge = kClothSide / cells;

  scenes::Random random(seed);
  const Surface sheet = square(cells, kClothSide);
  const double height = kClearance + 2 * kRadius + edge;
  model.add_cloth(
      mapped(sheet, [&](const Vec& p) -> Vec { return p + Vec(0, 0, height + random.between(0, 0.1 * edge)); }), sheet,
      {0.2, 2000, 2e-5});
  model.add_obstacle(sphere, [centre](double time) {
    const Eigen::AngleAxisd turn(angle_at(time), Vec::UnitZ());
    return Eigen::Isometry3d(Eigen::Translation3d(centre) * turn * Eigen::Translation3d(-centre));
  });
  model.add_obstacle(floor, at_rest);
  model.thickness = 0.3 * edge;
  model.friction = 0.9;
  model.drag = 1.5;
  model.frame_time = 1.0 / 25;
  return model;
}

}  // namespace tamis::simulation
