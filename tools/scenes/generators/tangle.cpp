// Random triangles over few vertices: edges with any number of triangles, duplicates, and adjacency everywhere. A
// method that loses pairs of features because their triangles are neighbours shows it here.
#include <algorithm>

#include "scenes/generators/generators.hpp"
#include "scenes/point_math.hpp"
#include "scenes/random.hpp"

namespace tamis::scenes {

Scene tangle(Index triangles, std::uint64_t seed) {
  const Index vertices = std::max(Index{5}, triangles / 2);
  Scene scene;
  Random random(seed);
  for (Index i = 0; i < vertices; ++i) {
    const Point start = random.point_between(-1, 1);
    scene.add_vertex(start, start + random.point_between(-0.5, 0.5), 0);
  }
  for (Index i = 0; i < triangles; ++i) {
    const Index a = random.below(vertices), b = (a + 1 + random.below(vertices - 1)) % vertices;
    Index c = random.below(vertices);
    while (c == a || c == b) c = (c + 1) % vertices;
    scene.faces.push_back({a, b, c});
  }
  return scene;
}

}  // namespace tamis::scenes
