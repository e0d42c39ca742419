// The neighbours of each vertex.
#pragma once
#include "search/topology/rows.hpp"
#include "tamis/mesh.hpp"

namespace tamis {

/// One row a vertex: the vertices to which an edge joins it. Throws InvalidMesh if there are more than 2^30 - 1 edges.
/// Time: linear.
IndexRows neighbours_of(const Mesh& mesh);

}  // namespace tamis
