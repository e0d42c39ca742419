// Nothing moves: two sheets that coincide at every second vertex, a third one that crosses them, and separate triangles
// between.
#include <algorithm>
#include <cmath>

#include "scenes/generators/generators.hpp"
#include "scenes/point_math.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace tamis::scenes {

Scene static_meshes(Index triangles, std::uint64_t seed) {
  constexpr Index kSheets = 3;
  const Index side = std::max(Index{2}, static_cast<Index>(std::sqrt(triangles / (2.0 * (kSheets + 1)))) + 1);
  Scene scene;
  Random random(seed);
  const double height = random.between(0.1, 0.4);
  for (Index sheet = 0; sheet < kSheets; ++sheet) {
    const Index first = scene.vertex_count();
    for (Index i = 0; i < side; ++i)
      for (Index j = 0; j < side; ++j) {
        // Sheets 0 and 2 coincide where i + j is even, and part elsewhere; sheet 1 crosses them.
        const double y = sheet == 1 ? height * (2 * i - side) / side : sheet == 2 && (i + j) % 2 != 0 ? 0.125 : 0;
        const Point p{double(i), y, double(j)};
        scene.add_vertex(p, p, sheet);
      }
    add_grid_faces(scene, first, side, side);
  }
  for (Index i = 0; static_cast<Index>(scene.faces.size()) < triangles; ++i) {
    const Point centre{random.between(0, side), random.between(-1, 1), random.between(0, side)};
    const std::array corners{centre, centre + random.point_between(-1, 1), centre + random.point_between(-1, 1)};
    add_triangle(scene, corners, corners, kSheets + i);
  }
  return scene;
}

}  // namespace tamis::scenes
