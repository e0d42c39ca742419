// A feature has the largest radius of its vertices. This need not be the radius of the vertex that moves or deviates
// most. Where both are added vertex by vertex, each vertex takes the largest radius of its neighbourhood instead.
#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "numbers/assert.hpp"
#include "search/topology/at.hpp"

namespace tamis {

/// For each vertex, the largest number of itself and the vertices at the other ends of its edges, which share a feature
/// with it. Empty if there are no numbers. For every feature: max over its vertices of (result + b) >= max(a) + max(b).
/// So summing per vertex is a safe bound. REQUIRES: one number a vertex, or none.
inline std::vector<double> neighbourhood_maximum(const Mesh& mesh, std::span<const double> of_vertex) {
  TAMIS_ASSERT(of_vertex.empty() || of_vertex.size() == at(mesh.vertex_count()));
  std::vector<double> largest(of_vertex.begin(), of_vertex.end());
  if (largest.empty()) return largest;
  for (const auto& [a, b] : mesh.edges()) {
    largest[at(a)] = std::max(largest[at(a)], of_vertex[at(b)]);
    largest[at(b)] = std::max(largest[at(b)], of_vertex[at(a)]);
  }
  return largest;
}

}  // namespace tamis
