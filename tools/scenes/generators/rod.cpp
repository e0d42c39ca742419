// A chain of loose edges that winds through a soup of triangles.
#include "scenes/generators/generators.hpp"
#include "scenes/point_math.hpp"
#include "scenes/random.hpp"

namespace tamis::scenes {

Scene rod(Index triangles, std::uint64_t seed) {
  Scene scene = soup(triangles, seed);
  for (Index& group : scene.group_of_vertex) group = 1;
  Random random(seed + 1);
  Point at = random.point_between(0, 1);
  const double length = 1 / cube_root(static_cast<double>(triangles));
  Index last = -1;
  for (Index i = 0; i < 2 * triangles; ++i) {
    const Index next = scene.add_vertex(at, at + random.point_between(-length / 2, length / 2), 0);
    if (last >= 0) scene.loose_edges.push_back({last, next});
    last = next;
    // A step of the walk, reflected into the box.
    at = at + random.point_between(-length, length);
    for (double& x : at) x = x < 0 ? -x : x > 1 ? 2 - x : x;
  }
  return scene;
}

}  // namespace tamis::scenes
