#include "io/extent.hpp"

#include <algorithm>
#include <limits>

namespace tamis::io {

Extent extent_of(const Mesh& mesh, std::span<const Point> start, std::span<const Point> end) {
  constexpr double kFar = std::numeric_limits<double>::max();
  Point lowest{kFar, kFar, kFar}, highest{-kFar, -kFar, -kFar};
  for (const std::span<const Point> positions : {start, end})
    for (const Index v : mesh.points())
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double x = positions[static_cast<std::size_t>(v)][axis];
        lowest[axis] = std::min(lowest[axis], x);
        highest[axis] = std::max(highest[axis], x);
      }
  Extent extent;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    extent.middle[axis] = lowest[axis] / 2 + highest[axis] / 2;
    extent.half = std::max(extent.half, highest[axis] / 2 - lowest[axis] / 2);
  }
  return extent;
}

}  // namespace tamis::io
