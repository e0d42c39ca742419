// Equal spheres with coordinates on a lattice of powers of two and mirror symmetry in x, y and z, their centres on a
// larger such lattice: neighbours are mirror images and touch pole to pole, exactly on the symmetry plane. By turns
// they arrive at t=1, start in touch and part, stay in touch, slide along, or pass through each other.
#include <algorithm>
#include <cmath>

#include "scenes/generators/generators.hpp"
#include "scenes/point_math.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace tamis::scenes {
namespace {

constexpr double kSphereUnit = 0x1p-10;  // radius 1

Shape lattice_sphere(Index cells) {
  Shape sphere = unit_sphere(cells);
  for (Point& p : sphere.points)
    for (double& x : p) x = kSphereUnit * std::round(x / kSphereUnit);
  return sphere;
}

/// How a sphere moves in its row: towards its neighbour, the other way round, or not.
Point sphere_motion(Index variant, bool is_even, Random& random) {
  const double towards = is_even ? 1 : -1;
  switch (variant) {
    case 0:
      return {0, 0, 0};
    case 1:
      return {towards * 0.25, 0, 0};
    case 2:
      return {-towards * 0.25, 0, 0};
    case 3:
      return {0, towards * 0.25, towards * 0.125};
    case 4:
      return {towards * 0.75, 0, 0};
    default:
      return random.point_on_lattice(256, kSphereUnit);
  }
}

}  // namespace

Scene touching_spheres(Index triangles, std::uint64_t seed) {
  // An even number of cells has vertices at the poles: six contacts of vertex stars at each sphere.
  const Index cells = std::max(Index{2}, sphere_cells(triangles, 12, 8) / 2 * 2);
  const Shape sphere = lattice_sphere(cells);
  const Index bodies = std::max(Index{2}, triangles / static_cast<Index>(sphere.faces.size()));
  Scene scene;
  Random random(seed);
  for (Index body = 0; body < bodies; ++body) {
    const Index row = body / 2, variant = (row + static_cast<Index>(seed % 6)) % 6;
    const bool is_even = body % 2 == 0;
    // Variants 1 and 4 start a gap apart: the spheres touch exactly at t=1, or meet at t=1/3 and pass through each
    // other.
    const double gap = variant == 1 || variant == 4 ? 0.5 : 0;
    const Point centre{is_even ? 0 : 2 + gap, 2.0 * (row % 3), 2.0 * (row / 3)};
    const Point flight = sphere_motion(variant, is_even, random);
    add_shape(
        scene, sphere, body, [&](const Point& p) { return centre + p; },
        [&](const Point& p) { return centre + flight + p; });
  }
  return scene;
}

}  // namespace tamis::scenes
