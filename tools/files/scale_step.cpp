#include "files/scale_step.hpp"

#include <fmt/format.h>

#include <cmath>

#include "tamis/error.hpp"

namespace tamis::io {

double part_of_way(double start, double end, double part) {
  const double way = end - start;
  // A way beyond the largest double is gone in halves, which doubles hold.
  return std::isfinite(way) ? start + part * way : 2 * (start / 2 + part * (end / 2 - start / 2));
}

void scale_step(const std::vector<Point>& start, std::vector<Point>& end, double scale) {
  if (scale == 1) return;
  for (std::size_t v = 0; v < end.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double& x = end[v][axis];
      const bool is_known = std::isfinite(x) && std::isfinite(start[v][axis]);
      x = part_of_way(start[v][axis], x, scale);
      if (is_known && !std::isfinite(x))
        throw InvalidOptions(
            fmt::format("a scale of {} takes vertex {} beyond the largest double: give a smaller one", scale, v));
    }
}

}  // namespace tamis::io
