// Four round rods side by side, twisted around each other by half a turn, that twist a little further and are pressed
// together: long bodies near each other all along, with few contacts.
#include <algorithm>
#include <cmath>

#include "scenes/generators/generators.hpp"
#include "scenes/point_math.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace tamis::scenes {
namespace {

constexpr Index kRods = 4;
// Lengths in units of the rods' length.
constexpr double kOffset = 0.04;            // of a rod's centre line from the axis, in y and in z
constexpr double kRodRadius = 0.99 * 0.04;  // of a rod: they do not touch at t=0
constexpr double kRodBump = 0.005;          // share of the radius
constexpr double kRodPress = 0.03;          // how much nearer the centre lines are at t=1
constexpr double kFurther = 0.01;           // share of half a turn

/// A point on the rim of the square with corners (+-1, +-1), `part` of the way round from the middle of a side.
Point on_square(double part) {
  const double along = std::fmod(8 * part + 1, 8);
  const int side = static_cast<int>(along / 2);
  const double t = along - 2 * side - 1;
  switch (side) {
    case 0:
      return {0, t, -1};
    case 1:
      return {0, 1, t};
    case 2:
      return {0, -t, 1};
    default:
      return {0, -1, -t};
  }
}

/// Turns p about the x axis by an angle that grows along the axis, in all by about `turn` half turns.
Point twisted(const Point& p, double turn) { return rotated(p, {turn * (2 * p[0] - 1), 0, 0}); }

}  // namespace

Scene twisted_rods(Index triangles, std::uint64_t seed) {
  // 2 x around x along triangles a rod, their cells about square.
  const double each = static_cast<double>(triangles) / kRods;
  // A multiple of four: vertices face those of the neighbours.
  const Index around = 4 * std::max(Index{1}, static_cast<Index>(std::lround(std::sqrt(each / 8) / 4)));
  const Index along = std::max(Index{1}, static_cast<Index>(std::lround(each / (2.0 * around))));
  Scene scene;
  for (Index rod = 0; rod < kRods; ++rod) {
    const Point centre{0, rod % 2 == 0 ? kOffset : -kOffset, rod < 2 ? kOffset : -kOffset};
    const SmoothNoise bumps(seed * kRods + static_cast<std::uint64_t>(rod));
    const Index first = scene.vertex_count();
    for (Index i = 0; i <= along; ++i)
      for (Index j = 0; j < around; ++j) {
        const Point rim = unit(on_square(static_cast<double>(j) / around));
        const double x = static_cast<double>(i) / along;
        const double radius = kRodRadius * (1 - kRodBump * (1 + bumps(40 * x, 2 * rim[1], 2 * rim[2])));
        const Point p = Point{x, 0, 0} + radius * rim;
        scene.add_vertex(twisted(p + centre, 1), twisted(p + (1 - kRodPress) * centre, 1 + kFurther), rod);
      }
    for (Index i = 0; i < along; ++i)
      for (Index j = 0; j < around; ++j) {
        const auto corner = [&](Index di, Index dj) { return first + (i + di) * around + (j + dj) % around; };
        scene.faces.push_back({corner(0, 0), corner(0, 1), corner(1, 1)});
        scene.faces.push_back({corner(0, 0), corner(1, 1), corner(1, 0)});
      }
  }
  return scene;
}

}  // namespace tamis::scenes
