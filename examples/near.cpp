#include <cstdio>
#include <tamis/tamis.hpp>

int main() {
  // a triangle, and a point 0.1 above it
  const tamis::Mesh mesh(4, {{0, 1, 2}}, {}, {3});
  const std::vector<tamis::Point> x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, 0.1}};
  std::vector<tamis::Point> force(x.size(), tamis::Point{});
  tamis::Detector detector(mesh);
  const double reach = 0.2, stiffness = 100;
  for (const tamis::NearPair& pair : detector.pairs_within(x, reach)) {
    const auto weights = tamis::weights_of(pair.kind, pair.u, pair.v);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t axis = 0; axis < 3 && pair.vertices[i] >= 0; ++axis)
        force[pair.vertices[i]][axis] += stiffness * (reach - pair.distance) * weights[i] * pair.direction[axis];
  }
  for (const tamis::Point& f : force) std::printf("%5.1f %5.1f %5.1f\n", f[0] + 0.0, f[1] + 0.0, f[2] + 0.0);
}
