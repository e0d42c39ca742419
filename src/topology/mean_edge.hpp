// The mean edge length: the unit in which searches measure motion.
#pragma once
#include "numerics/length.hpp"
#include "numerics/mean_of_most.hpp"
#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis {

/// Of some thousand edges, in the mesh's order; 0 without edges, and finite always. A few that are much longer than the
/// rest, as a ground below a cloth has them, do not count.
inline double mean_edge(const Mesh& mesh, const Positions& points) {
  constexpr std::size_t kSample = 4096;
  const auto edges = mesh.edges();
  return mean_of_most(edges.size(), 1 + edges.size() / kSample, [&](std::size_t e) {
    const double *a = points[edges[e][0]], *b = points[edges[e][1]];
    return quick_length_of(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  });
}

}  // namespace tamis
