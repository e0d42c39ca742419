// The objects of a mesh: what is connected by common vertices.
#pragma once
#include <vector>

#include "tamis/mesh.hpp"

namespace tamis::io {

/// Vertices that faces and edges connect.
struct Components {
  std::vector<Index> of_vertex;  ///< numbered in the order of their first vertices; -1 for a vertex that nothing uses
  Index count = 0;
};

Components components_of(const Mesh& mesh);

}  // namespace tamis::io
