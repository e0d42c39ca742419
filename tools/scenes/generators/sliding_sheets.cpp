// Sheets that share one plane during the whole step, and slide in it. The plane itself rises. The coplanarity
// polynomial of every pair is zero at all times: a method that takes this for "no contact" makes the classical miss.
#include <algorithm>
#include <cmath>

#include "scenes/generators/generators.hpp"
#include "scenes/point_math.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace tamis::scenes {

Scene sliding_sheets(Index triangles, std::uint64_t seed) {
  constexpr Index kSheets = 3;
  const Index side = std::max(Index{2}, static_cast<Index>(std::sqrt(triangles / (2.0 * kSheets))) + 1);
  Scene scene;
  Random random(seed);
  // Slopes on a lattice of powers of two keep the plane exact.
  const double slope_x = random.on_lattice(4, 0.25), slope_z = random.on_lattice(4, 0.25),
               rise = random.on_lattice(4, 0.25);
  const auto in_plane = [&](double x, double z) { return Point{x, slope_x * x + slope_z * z, z}; };
  for (Index sheet = 0; sheet < kSheets; ++sheet) {
    const Index first = scene.vertex_count();
    const double x0 = sheet * (side - 0.5), z0 = random.on_lattice(8, 0x1p-3);
    const double dx = random.on_lattice(8, 0x1p-3), dz = random.on_lattice(8, 0x1p-3);
    for (Index i = 0; i < side; ++i)
      for (Index j = 0; j < side; ++j) {
        const double wobble = random.on_lattice(2, 0x1p-3);
        scene.add_vertex(in_plane(x0 + i, z0 + j), in_plane(x0 + i + dx + wobble, z0 + j + dz) + Point{0, rise, 0},
                         sheet);
      }
    add_grid_faces(scene, first, side, side);
  }
  return scene;
}

}  // namespace tamis::scenes
