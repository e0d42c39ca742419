#include <vector>

#include "matrix/kinds/kinds.hpp"
#include "scenes/generators/generators.hpp"
#include "scenes/point_math.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

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

Scene passing_bodies(Index triangles, std::uint64_t) {
  const Shape ball = unit_sphere(sphere_cells(triangles, 2, triangles));
  Scene scene;
  for (Index body = 0; body < 2; ++body)
    add_shape(
        scene, ball, body,
        [&](const Point& p) {
          return rotated(p, {0.1 * body, 0.2, 0}) + Point{3.0 * body, 0, 0};
        },
        [&](const Point& p) {
          return rotated(p, {0.1 * body, 0.2, 0}) + Point{3.0 - 3.0 * body, 0.1, 0};
        });
  return scene;
}

Scene scattered_groups(Index triangles, std::uint64_t seed) {
  constexpr Index kGroups = 16;
  Scene scene = soup(triangles, seed);
  for (Index& group : scene.group_of_vertex) group %= kGroups;
  return scene;
}

}  // namespace tamis::matrix
