// The mean edge length: the unit in which searches measure motion.
#pragma once
#include <algorithm>
#include <limits>

#include "numerics/length.hpp"
#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis {

/// Of some thousand edges, in the mesh's order; 0 without edges, and finite always. A few that are much longer than the
/// rest, as a ground below a cloth has them, do not count.
inline double mean_edge(const Mesh& mesh, const Positions& points) {
  constexpr std::size_t kSample = 4096;
  constexpr double kMuchLonger = 32;
  const auto edges = mesh.edges();
  for (double most = std::numeric_limits<double>::infinity();;) {
    double sum = 0, longest = 0;
    int count = 0;
    for (std::size_t e = 0; e < edges.size(); e += 1 + edges.size() / kSample) {
      const double *a = points[edges[e][0]], *b = points[edges[e][1]];
      const double length = quick_length_of(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
      if (!(length <= most)) continue;
      sum += length;
      longest = std::max(longest, length);
      ++count;
    }
    const double mean = count > 0 ? std::min(sum / count, std::numeric_limits<double>::max()) : 0;
    if (!(longest > kMuchLonger * mean)) return mean;
    most = mean;
  }
}

}  // namespace tamis
