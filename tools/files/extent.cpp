#include "files/extent.hpp"

#include <algorithm>

namespace tamis::io {

void Box::add(const Mesh& mesh, std::span<const Point> positions) {
  for (const Index v : mesh.points())
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double x = positions[static_cast<std::size_t>(v)][axis];
      lowest[axis] = std::min(lowest[axis], x);
      highest[axis] = std::max(highest[axis], x);
    }
}

Extent extent_of(const Mesh& mesh, std::span<const Point> start, std::span<const Point> end) {
  Box box;
  box.add(mesh, start);
  box.add(mesh, end);
  Extent extent;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    extent.middle[axis] = box.lowest[axis] / 2 + box.highest[axis] / 2;
    extent.half = std::max(extent.half, box.highest[axis] / 2 - box.lowest[axis] / 2);
  }
  return extent;
}

}  // namespace tamis::io
