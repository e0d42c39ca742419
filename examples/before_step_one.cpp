#include <cstdio>
#include <tamis/tamis.hpp>

int main() {
  // a triangle, a rod through it, and a step in which both go up together
  const std::vector<tamis::Point> x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, -1}, {0.2, 0.2, 1}};
  auto end = x;
  for (tamis::Point& p : end) p[2] += 1;
  tamis::Detector detector(tamis::Mesh(5, {{0, 1, 2}}, {{3, 4}}));
  std::printf("the step is %s\n", detector.is_free({x, end}) ? "free" : "not free");
  for (const auto& [edge, face, s_lower, s_upper, u, v] : detector.intersections(x))
    std::printf("but edge %d %d passes through face %d %d %d\n", edge[0], edge[1], face[0], face[1], face[2]);
}
