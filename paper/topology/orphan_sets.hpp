// Orphan sets (Tang, Curtis, Yoon, Manocha 2009): triangle pairs that share a vertex are never tested; the pairs of
// features that would be lost with them are collected once per topology and tested every step.
#pragma once
#include <array>
#include <vector>

#include "tamis/mesh.hpp"

namespace tamis::lab {

struct FeaturePairs {
  std::vector<std::array<Index, 2>> vf;  ///< vertex, face
  std::vector<std::array<Index, 2>> ee;  ///< two edges, the smaller index first
};

struct OrphanSets {
  /// Pairs whose incident triangles share a vertex in every combination: no tested pair of triangles contains them.
  FeaturePairs orphans;
  /// Pairs whose two representatives share a vertex, but not all incident triangles do: lost if, and only if, each pair
  /// is tested in its representatives alone.
  FeaturePairs displaced;
};

/// Collects pairs of features without a common vertex. Looks at all incident triangles of an edge, not just two; a face
/// represents itself. Faces from `face_count` on are no features (search/topology/surface.hpp).
OrphanSets collect_orphan_sets(const Mesh& mesh, Index face_count);

}  // namespace tamis::lab
