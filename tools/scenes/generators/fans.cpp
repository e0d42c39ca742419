// Non-manifold fans: one edge shared by three to six triangles, chained at single vertices (bow ties), each chain
// flying through its neighbours.
#include <algorithm>

#include "scenes/generators/generators.hpp"
#include "scenes/point_math.hpp"
#include "scenes/random.hpp"

namespace tamis::scenes {

Scene fans(Index triangles, std::uint64_t seed) {
  Scene scene;
  Random random(seed);
  Index joint = 0;
  for (Index fan = 0; static_cast<Index>(scene.faces.size()) < triangles; ++fan) {
    const Index chain = fan / 3;
    const Point centre = random.point_between(-1, 1), flight = random.point_between(-0.5, 0.5);
    const auto add = [&] {
      const Point start = centre + random.point_between(-0.7, 0.7);
      return scene.add_vertex(start, start + flight + random.point_between(-0.1, 0.1), chain);
    };
    if (fan % 3 == 0) joint = add();
    const Index hub = add();
    const Index blades = 3 + random.below(4);
    Index tip = joint;
    for (Index k = 0; k < blades; ++k) {
      tip = add();
      scene.faces.push_back(random.coin() ? Face{joint, hub, tip} : Face{hub, joint, tip});
    }
    joint = tip;
  }
  return scene;
}

}  // namespace tamis::scenes
