#include "io/scale_step.hpp"

#include <fmt/format.h>

#include <cmath>

#include "tamis/error.hpp"

namespace tamis::io {

void scale_step(const std::vector<Point>& start, std::vector<Point>& end, double scale) {
  if (scale == 1) return;
  for (std::size_t v = 0; v < end.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double& x = end[v][axis];
      x = start[v][axis] + scale * (x - start[v][axis]);
      if (!std::isfinite(x))
        throw InvalidOptions(
            fmt::format("a scale of {} takes vertex {} beyond the largest double: give a smaller one", scale, v));
    }
}

}  // namespace tamis::io
