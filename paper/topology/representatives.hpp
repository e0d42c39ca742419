// Representative triangles (Curtis, Tamstorf, Manocha 2008): each vertex and each edge is given to one of its
// triangles, so that a pair of features is met in one pair of triangles only.
#pragma once
#include <vector>

#include "tamis/mesh.hpp"

namespace tamis::lab {

/// The features of one triangle. Bit k of a mask: corner k, or side k from corner k to corner k+1.
struct TriangleFeatures {
  Face vertices;
  std::array<Index, 3> edges;
  std::uint8_t own_vertices, own_edges;  ///< the features that the triangle represents
  std::uint8_t all_vertices, all_edges;  ///< all its features, each once even if the triangle is degenerate
};

/// The representative is the first incident triangle. REQUIRES (not checked: O(n)): every feature has one
/// (search/topology/surface.hpp).
std::vector<TriangleFeatures> choose_representatives(const Mesh& mesh);

inline bool share_a_vertex(const Face& a, const Face& b) {
  unsigned equal = 0;
  for (Index v : a) equal |= unsigned(v == b[0]) | unsigned(v == b[1]) | unsigned(v == b[2]);
  return equal != 0;
}

}  // namespace tamis::lab
