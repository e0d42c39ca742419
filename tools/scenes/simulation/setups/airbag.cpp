// A folded bag, held at the hub of a steering wheel, fills with gas.
#include <algorithm>
#include <cmath>

#include "scenes/random.hpp"
#include "scenes/simulation/scenes.hpp"

namespace tamis::simulation {
namespace {

constexpr double kBagRadius = 0.33;
constexpr double kBase = 0.065;     ///< half the width of the panel that lies on the hub
constexpr double kInflator = 0.05;  ///< radius of the bag's opening, held at the hub
constexpr double kRimRadius = 0.19, kRimThickness = 0.015;
constexpr double kHubRadius = 0.075;

/// A curve in the plane (x, z) by arc length: straight panels and half circles in turn, folded to and fro upwards.
class Fold {
 public:
  /// `clearance`: between the two halves, and between each inner turn and the middle.
  Fold(double turn_radius, double clearance) : radius_(turn_radius), panel_(kBase - turn_radius - clearance) {}

  /// Place at arc length s from the middle of the bag; `aside`: distance from the curve, upwards on the base panel.
  /// The left half mirrors the right one.
  Vec at(double s, double aside) const {
    Vec p = right(std::abs(s), aside);
    if (s < 0) p.x() = -p.x();
    return p;
  }

 private:
  Vec right(double s, double aside) const {
    if (s < kBase) return {s, 0, aside};
    s -= kBase;
    const double arc = kPi * radius_, period = panel_ + arc;
    const int turn = static_cast<int>(s / period);
    const double rest = s - turn * period;
    const bool goes_in = turn % 2 == 0;  // after the first turn the curve runs towards the middle
    const double x = goes_in ? kBase : kBase - panel_, z = 2 * radius_ * turn;
    const double side = goes_in ? 1 : -1;
    if (rest < arc) {
      const double angle = rest / radius_, r = radius_ - side * aside;
      return {x + side * r * std::sin(angle), 0, z + radius_ - r * std::cos(angle)};
    }
    return {x - side * (rest - arc), 0, z + 2 * radius_ - side * aside};
  }

  double radius_, panel_;
};

/// Ring, hub and three spokes, the top of the hub at z = 0.
Surface wheel(Index segments) {
  std::vector<Vec> ring, hub;
  const Index around = segments / 4;
  for (Index i = 0; i < around; ++i) {
    const double angle = 2 * kPi * i / around;
    ring.emplace_back(kRimRadius + kRimThickness * std::cos(angle), 0, kRimThickness * std::sin(angle) - kRimThickness);
  }
  hub = {{kHubRadius, 0, -0.06}, {kHubRadius, 0, -0.01}, {kHubRadius - 0.01, 0, 0}, {0.04, 0, 0}, {0.002, 0, 0}};
  std::vector<Surface> parts{revolved(ring, segments, true), revolved(hub, segments, false)};
  const Surface spoke = box({kRimRadius - kRimThickness - kHubRadius - 0.004, 0.03, 0.012});
  for (int i = 0; i < 3; ++i) {
    const Eigen::AngleAxisd turn(kPi / 2 + 2 * kPi * i / 3, Vec::UnitZ());
    parts.push_back(mapped(spoke, [&](const Vec& p) -> Vec {
      return turn * (p + Vec((kRimRadius - kRimThickness + kHubRadius) / 2, 0, -0.02));
    }));
  }
  return joined(parts);
}

}  // namespace

Model airbag(Index triangles, std::uint64_t seed) {
  Model model;
  const auto segments = static_cast<Index>(std::clamp(std::sqrt(triangles / 2.0), 24.0, 64.0)) / 4 * 4;
  const Surface steering_wheel = wheel(segments);
  const auto bag_triangles = triangles - static_cast<Index>(steering_wheel.faces.size());
  const auto rings = static_cast<Index>(std::sqrt(std::max(108.0, bag_triangles / 12.0)));
  const double edge = kBagRadius / rings;
  model.thickness = 0.25 * edge;
  const double gap = 1.5 * model.thickness, turn_radius = std::max(0.7 * edge, 2.5 * gap);

  const Surface bag = pillow(rings, kBagRadius, gap);
  const Fold fold(turn_radius, gap);
  scenes::Random random(seed);
  const Index first =
      model.add_cloth(mapped(bag,
                             [&](const Vec& p) -> Vec {
                               const Vec folded = fold.at(p.x(), p.z());
                               return {folded.x(), p.y() + random.between(-0.02, 0.02) * edge, folded.z() + gap};
                             }),
                      bag, {0.25, 5000, 5e-5});
  const auto points = static_cast<Index>(bag.points.size());
  for (Index v = 0; v < points; ++v) {
    const Vec& p = bag.points[static_cast<std::size_t>(v)];
    if (p.z() < 0 && p.head<2>().norm() < kInflator) model.particles.inverse_mass[first + v] = 0;
  }
  model.gases.push_back({model.faces, 150, 1.2 * kBagRadius * kBagRadius * kBagRadius, 0.15});
  model.add_obstacle(steering_wheel, at_rest);
  model.friction = 0.2;
  model.drag = 2;
  model.frame_time = 1.0 / 360;
  model.substeps = 4;
  return model;
}

}  // namespace tamis::simulation
