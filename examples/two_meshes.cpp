#include <cstdio>
#include <tamis/tamis.hpp>

int main() {
  // a floor and a body that falls through it: append the vertices, offset the faces, make one Detector
  std::vector<tamis::Point> start{{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}};
  std::vector<tamis::Face> faces{{0, 1, 2}, {0, 2, 3}};
  const std::vector<tamis::Point> body{{0.3, 0.1, 1}, {1, 0, 2}, {0, 1, 2}, {0, 0, 2}};
  const std::vector<tamis::Face> body_faces{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

  const int offset = 4;  // the number of vertices so far
  start.insert(start.end(), body.begin(), body.end());
  for (const auto& [a, b, c] : body_faces) faces.push_back({a + offset, b + offset, c + offset});
  auto end = start;
  for (int v = offset; v < 8; ++v) end[v][2] -= 4;

  tamis::Detector detector(tamis::Mesh(8, faces));
  const tamis::EarliestContact first = detector.earliest({start, end});
  std::printf("free up to %.6f of the step\n", first.toi_lower);
  if (first.contact) std::printf("then vertex %d of the body meets the floor\n", first.contact->vertices[0] - offset);
}
