// Patches of surface: an order of the triangles in which nested halves are connected, and the contour of each half.
#pragma once
#include <vector>

#include "search/topology/rows.hpp"
#include "tamis/mesh.hpp"

namespace tamis::lab {

/// Each half of the order, each half of a half, and so on, is a patch grown by breadth-first search: connected where
/// the mesh allows it. Of an odd number of triangles, the second half has one more.
std::vector<Index> patch_order(const Mesh& mesh);

/// For every patch of the nested halving of `order`, numbered depth-first as the nodes of a BinaryTree: the vertices of
/// its contour in the order of the triangles' winding. Empty unless the triangles' oriented sides, opposite ones
/// cancelled, are one closed loop that visits no vertex twice. Patches of fewer than `smallest` triangles: empty.
IndexRows patch_contours(const Mesh& mesh, const std::vector<Index>& order, std::size_t smallest);

}  // namespace tamis::lab
