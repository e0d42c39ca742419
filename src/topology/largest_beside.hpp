// What a feature has is the largest of what its vertices have: of two quantities the largest sum, which one vertex'
// own sums are not, where another one has more of the second.
#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "numerics/assert.hpp"
#include "topology/at.hpp"

namespace tamis {

/// Of each vertex the largest number of any vertex that it shares a feature with, itself among them; empty of none. So
/// with any second number of each vertex, the largest sum of a feature's vertices is no less than the largest of both
/// numbers together. Any two vertices of a face are an edge. REQUIRES: one of each vertex, or none.
inline std::vector<double> largest_beside(const Mesh& mesh, std::span<const double> of_vertex) {
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
