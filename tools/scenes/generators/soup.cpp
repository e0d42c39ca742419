// Separate triangles with random corners and random motion, about as large and as fast as they are far apart.
#include <cmath>

#include "scenes/generators/generators.hpp"
#include "scenes/point_math.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace tamis::scenes {

Scene soup(Index triangles, std::uint64_t seed) {
  const double distance = 1 / cube_root(static_cast<double>(triangles));
  Scene scene;
  Random random(seed);
  for (Index i = 0; i < triangles; ++i) {
    const Point centre = random.point_between(0, 1), motion = random.point_between(-distance, distance);
    std::array<Point, 3> start, end;
    for (std::size_t k = 0; k < 3; ++k) {
      start[k] = centre + random.point_between(-distance / 2, distance / 2);
      end[k] = start[k] + motion + random.point_between(-distance / 4, distance / 4);
    }
    add_triangle(scene, start, end, i);
  }
  return scene;
}

}  // namespace tamis::scenes
