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
  /// Every pair of incident triangles shares a vertex: no tested pair of triangles contains the pair.
  FeaturePairs orphans;
  /// Only the two representatives share a vertex: lost if, and only if, each pair is tested with its representatives.
  FeaturePairs displaced;
};

/// Features without a common vertex. All incident triangles of an edge count, not two of them; a face represents
/// itself. Faces from `face_count` on are no features (topology/surface.hpp).
OrphanSets collect_orphan_sets(const Mesh& mesh, Index face_count);

}  // namespace tamis::lab
