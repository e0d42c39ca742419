// What the edges of a mesh connect: its objects, and the neighbours of each vertex.
#pragma once
#include <vector>

#include "tamis/mesh.hpp"

namespace tamis {

/// Connected components, as groups for PairFilter::group_of_vertex or for a radius each.
struct Components {
  /// One number a vertex of the mesh, in [0, count): components in the order of their first vertices. -1 for a vertex
  /// that takes no part in contacts (Mesh::points).
  std::vector<Index> of_vertex;
  Index count = 0;
};

/// By faces and edges; a loose point is a component of its own. Time: nearly linear (union-find: Tarjan 1975).
Components components_of(const Mesh& mesh);

/// For each vertex those at the other end of an edge. Throws InvalidMesh if there are more than 2^30 - 1 edges. Time:
/// linear.
IndexRows neighbours_of(const Mesh& mesh);

}  // namespace tamis
