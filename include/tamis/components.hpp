// The connected components of a mesh (its objects), and the neighbours of each vertex.
#pragma once
#include <vector>

#include "tamis/mesh.hpp"

namespace tamis {

/// Connected components, numbered as PairFilter::group_of_vertex numbers groups: to leave out pairs, or to give each
/// component a radius.
struct Components {
  /// For each vertex of the mesh the number of its component, in [0, count): components are in the order of their first
  /// vertices. -1 for a vertex that takes no part in contacts (it is not in Mesh::points).
  std::vector<Index> of_vertex;
  Index count = 0;
};

/// Faces and edges connect their vertices; a loose point is a component of its own. Time: nearly linear (union-find:
/// Tarjan 1975).
Components components_of(const Mesh& mesh);

/// One row a vertex: the vertices to which an edge joins it. Throws InvalidMesh if there are more than 2^30 - 1 edges.
/// Time: linear.
IndexRows neighbours_of(const Mesh& mesh);

}  // namespace tamis
