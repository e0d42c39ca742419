// Closed, bumpy spheres on a lattice, a little apart. The heap collapses towards its middle, and each sphere also flies
// and turns at random: about half of the neighbours collide, each on a small cap.
#include <algorithm>
#include <cmath>

#include "scenes/generators/generators.hpp"
#include "scenes/point_math.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace tamis::scenes {
namespace {

// Lengths in units of the lattice.
constexpr double kBodyRadius = 0.47;
constexpr double kBodyBump = 0.05;  // share of the radius: no contact at t=0
constexpr double kPull = 0.08;
constexpr double kFlight = 0.1;
constexpr double kTurn = 0.05;  // tangent of half the angle
constexpr Index kFewestBodies = 8;
constexpr Index kMostBodyCells = 24;

}  // namespace

Scene colliding_bodies(Index triangles, std::uint64_t seed) {
  const Index cells = std::max(Index{2}, sphere_cells(triangles, kFewestBodies, kMostBodyCells));
  const Shape sphere = unit_sphere(cells);
  const Index bodies = std::max(Index{2}, triangles / static_cast<Index>(sphere.faces.size()));
  const Index side = static_cast<Index>(std::ceil(cube_root(bodies)));
  const double scale = 1.0 / side;
  const double half = 0.5 * (side - 1);
  const Point middle{half, half, half};

  Scene scene;
  Random random(seed);
  for (Index body = 0; body < bodies; ++body) {
    const Point centre{double(body % side), double(body / side % side), double(body / (side * side))};
    const Point turned = random.point_between(-1, 1), turn = turned + random.point_between(-kTurn, kTurn);
    const Point flight = kPull * (middle - centre) + random.point_between(-kFlight, kFlight);
    const SmoothNoise bumps(random.bits());
    const auto bumpy = [&](const Point& p) {
      return (kBodyRadius * (1 + kBodyBump * bumps(4 * p[0], 4 * p[1], 4 * p[2]))) * p;
    };
    add_shape(
        scene, sphere, body, [&](const Point& p) { return scale * (centre + rotated(bumpy(p), turned)); },
        [&](const Point& p) { return scale * (centre + flight + rotated(bumpy(p), turn)); });
  }
  return scene;
}

}  // namespace tamis::scenes
