// Loose points that fall on a sheet. Every fourth ends exactly on a vertex, every fourth exactly on an edge, every
// fourth passes a vertex at t=1/2; the others fall at random.
#include <algorithm>
#include <cmath>

#include "scenes/generators/generators.hpp"
#include "scenes/point_math.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace tamis::scenes {

Scene points_on_cloth(Index triangles, std::uint64_t seed) {
  const Index side = std::max(Index{2}, static_cast<Index>(std::sqrt(triangles / 2.0)) + 1);
  Scene scene;
  Random random(seed);
  for (Index i = 0; i < side; ++i)
    for (Index j = 0; j < side; ++j) {
      const Point start{double(i), random.on_lattice(8, 0x1p-4), double(j)};
      scene.add_vertex(start, start + Point{0, random.on_lattice(8, 0x1p-4), 0}, 0);
    }
  add_grid_faces(scene, 0, side, side);
  const Index sheet = scene.vertex_count();
  for (Index i = 0; i < sheet; ++i) {
    const auto a = static_cast<std::size_t>(random.below(sheet));
    const std::size_t b = a == 0 ? 1 : a - 1;
    const Point middle = 0.5 * (scene.start[a] + scene.end[a]);
    const Point height{0, 1 + random.unit(), 0};
    const Point above{(side - 1) * random.unit(), 0.5 + random.unit(), (side - 1) * random.unit()};
    const Point dyadic_height{0.25, 1.5, 0.5};
    Index point = 0;
    if (i % 4 == 0) point = scene.add_vertex(scene.start[a] + height, scene.end[a], 1);
    if (i % 4 == 1) point = scene.add_vertex(scene.start[a] + height, 0.5 * (scene.end[a] + scene.end[b]), 1);
    if (i % 4 == 2) point = scene.add_vertex(middle + dyadic_height, middle - dyadic_height, 1);
    if (i % 4 == 3) point = scene.add_vertex(above, above - Point{0, 1 + random.unit(), 0}, 1);
    scene.loose_points.push_back(point);
  }
  return scene;
}

}  // namespace tamis::scenes
