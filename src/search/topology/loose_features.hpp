// The features that belong to no larger one.
#pragma once
#include <vector>

#include "tamis/mesh.hpp"

namespace tamis {

struct LooseFeatures {
  std::vector<Edge> edges;    ///< of no face, in the mesh's order
  std::vector<Index> points;  ///< of no face and no edge, or a face that is one vertex (so has no edges); ascending

  explicit LooseFeatures(const Mesh& mesh);
};

}  // namespace tamis
