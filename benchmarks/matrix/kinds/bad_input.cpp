#include "matrix/kinds/kinds.hpp"
#include "scenes/generators/generators.hpp"
#include "scenes/point_math.hpp"
#include "scenes/random.hpp"

namespace tamis::matrix {

using namespace scenes;

Scene huge_beside_tiny(Index triangles, std::uint64_t seed) {
  Scene scene = soup(triangles, seed);
  for (std::size_t v = 0; v < scene.start.size(); ++v) {
    const double motion = scene.group_of_vertex[v] % 2 == 0 ? 1e300 : 1e-300;
    scene.end[v] = scene.start[v] + motion * (scene.end[v] - scene.start[v]);
  }
  return scene;
}

Scene infinite_ratio(Index triangles, std::uint64_t seed) {
  Scene scene = folded_cloth(triangles, seed);
  for (std::size_t v = 0; v < scene.start.size(); ++v) {
    scene.end[v] = scene.end[v] - scene.start[v];
    scene.start[v] = 1e-310 * scene.start[v];
  }
  return scene;
}

Scene one_flies_through(Index triangles, std::uint64_t seed) {
  Scene scene = folded_cloth(triangles, seed);
  const std::size_t middle = scene.start.size() / 2;
  scene.end[middle] = scene.start[middle] + Point{100, 100, 100};
  return scene;
}

Scene exploding_cloth(Index triangles, std::uint64_t seed) {
  Scene scene = folded_cloth(triangles, seed);
  Random numbers(seed);
  const auto way = [&] { return numbers.between(-100, 100); };
  for (std::size_t v = 0; v < scene.start.size(); ++v) scene.end[v] = scene.start[v] + Point{way(), way(), way()};
  return scene;
}

}  // namespace tamis::matrix
