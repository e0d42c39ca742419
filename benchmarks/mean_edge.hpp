// The mean length of a mesh's edges.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis::bench {

/// 0 if there are none.
inline double mean_edge(const Mesh& mesh, const std::vector<Point>& points) {
  double sum = 0;
  for (const auto& [a, b] : mesh.edges()) {
    const Point &p = points[static_cast<std::size_t>(a)], &q = points[static_cast<std::size_t>(b)];
    sum += std::sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) + (p[2] - q[2]) * (p[2] - q[2]));
  }
  return sum / static_cast<double>(std::max<std::size_t>(mesh.edges().size(), 1));
}

}  // namespace tamis::bench
