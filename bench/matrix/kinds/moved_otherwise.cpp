#include <vector>

#include "matrix/kinds/kinds.hpp"
#include "scenes/generators/generators.hpp"
#include "scenes/point_math.hpp"
#include "scenes/random.hpp"

namespace tamis::matrix {

using namespace scenes;

Scene fast_body(Index triangles, std::uint64_t seed) {
  Scene scene = colliding_bodies(triangles, seed);
  for (std::size_t v = 0; v < scene.start.size(); ++v)
    if (scene.group_of_vertex[v] == 0) scene.end[v] = scene.start[v] + Point{1, 1, 1};
  return scene;
}

Scene spinning_bodies(Index triangles, std::uint64_t seed) {
  Scene scene = colliding_bodies(triangles, seed);
  const auto groups = static_cast<std::size_t>(scene.group_of_vertex.back()) + 1;
  std::vector<Point> sums(groups, Point{}), axes;
  std::vector<int> counts(groups, 0);
  Random random(seed);
  for (std::size_t g = 0; g < groups; ++g) axes.push_back(0.41421356 * unit(random.point_between(-1, 1)));
  for (std::size_t v = 0; v < scene.start.size(); ++v) {
    const auto g = static_cast<std::size_t>(scene.group_of_vertex[v]);
    sums[g] = sums[g] + scene.start[v];
    ++counts[g];
  }
  for (std::size_t v = 0; v < scene.start.size(); ++v) {
    const auto g = static_cast<std::size_t>(scene.group_of_vertex[v]);
    const Point centre = (1.0 / counts[g]) * sums[g];
    scene.end[v] = centre + rotated(scene.start[v] - centre, axes[g]);
  }
  return scene;
}

Scene fast_together(Index triangles, std::uint64_t seed) {
  Scene scene = folded_cloth(triangles, seed);
  for (Point& p : scene.end) p = p + Point{100, 50, 25};
  return scene;
}

}  // namespace tamis::matrix
