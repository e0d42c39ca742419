#include <cstdio>
#include <tamis/tamis.hpp>

int main() {
  const tamis::Mesh mesh(6, {{0, 1, 2}, {3, 4, 5}});  // two triangles; the second one's corner 3 falls
  const std::vector<tamis::Point> start{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, 1}, {1, 0.5, 2}, {0.5, 1, 2}};
  auto end = start;
  end[3] = {0.25, 0.25, -1};
  tamis::Detector detector(mesh);
  for (const auto& contact : detector.contacts({start, end}))
    std::printf("vertex %d meets the face in [%.6f, %.6f]\n", contact.vertices[0], contact.toi_lower,
                contact.toi_upper);
}
