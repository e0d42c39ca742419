// The features of a mesh that are drawn besides its triangles.
#pragma once
#include <vector>

#include "tamis/mesh.hpp"

namespace tamis::io {

/// The edges of no triangle.
std::vector<Edge> rods_of(const Mesh& mesh);

/// The points of no edge.
std::vector<Index> loose_points_of(const Mesh& mesh);

}  // namespace tamis::io
