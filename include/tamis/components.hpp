// The connected components of a mesh (its objects).
#pragma once
#include <vector>

#include "tamis/mesh.hpp"

namespace tamis {

/// Connected components, numbered as PairFilter::group_of_vertex numbers groups. Use them to skip pairs, or to give
/// each component a radius.
struct Components {
  /// For each vertex of the mesh the number of its component, in [0, count). Components are in the order of their first
  /// vertices. -1 for a vertex that takes no part in contacts (it is not in Mesh::points).
  std::vector<Index> of_vertex;
  Index count = 0;  ///< number of components
};

/// Finds the connected components. Faces and edges connect their vertices. A loose point is a component of its own.
/// Time: nearly linear (union-find: Tarjan 1975).
/// Returns the component of each vertex.
[[nodiscard]] Components components_of(const Mesh& mesh);

}  // namespace tamis
