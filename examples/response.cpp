#include <cstdio>
#include <tamis/tamis.hpp>

int main() {
  // a triangle that rests, and a point that falls on it and slides along it
  const tamis::Mesh mesh(4, {{0, 1, 2}}, {}, {3});
  const std::vector<tamis::Point> start{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 1}};
  std::vector<tamis::Point> velocity{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0.1, 0, -2}};  // a step
  const std::vector<double> inverse_mass{0, 0, 0, 1};                                 // 0: nothing moves it
  std::vector<tamis::Point> end = start;
  for (std::size_t v = 0; v < 4; ++v)
    for (std::size_t axis = 0; axis < 3; ++axis) end[v][axis] += velocity[v][axis];

  tamis::Detector detector(mesh);
  for (const tamis::Contact& c : detector.contacts({start, end}, {.min_separation = 1e-3})) {
    const auto weights = tamis::weights_of(c.kind, c.u, c.v);
    double approach = 0, mobility = 0;  // along the direction in which the first feature must go
    for (std::size_t i = 0; i < 4 && c.vertices[i] >= 0; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        approach += weights[i] * velocity[c.vertices[i]][axis] * c.normal[axis];
      mobility += weights[i] * weights[i] * inverse_mass[c.vertices[i]];
    }
    if (approach >= 0 || mobility == 0) continue;
    for (std::size_t i = 0; i < 4 && c.vertices[i] >= 0; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        velocity[c.vertices[i]][axis] -=
            approach / mobility * weights[i] * inverse_mass[c.vertices[i]] * c.normal[axis];
    std::printf("at t = %.3f; the point goes on with (%.1f, %.1f, %.1f)\n", c.toi_lower, velocity[3][0], velocity[3][1],
                velocity[3][2]);
  }
}
