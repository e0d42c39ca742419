// Refit: new bounds for an old tree, from the leaves up.
#pragma once
#include <vector>

#include "paper/bvh/binary_tree.hpp"

namespace tamis::lab {

/// `leaf_volume(triangle)` gives the bounds of a leaf. Returns the sum of all nodes' extents in units of the root's:
/// a measure of how good the tree is, smaller is better.
template <class Volume, class LeafVolume>
double refit(const BinaryTree& tree, const LeafVolume& leaf_volume, std::vector<Volume>& volumes) {
  volumes.resize(static_cast<std::size_t>(tree.size()));
  double sum = 0;
  for (Index node = tree.size() - 1; node >= 0; --node) {
    const auto at = [&](Index i) -> Volume& { return volumes[static_cast<std::size_t>(i)]; };
    at(node) = tree.is_leaf(node) ? Volume(leaf_volume(tree.triangle(node)))
                                  : merge(at(tree.left(node)), at(tree.right(node)));
    sum += at(node).extent();
  }
  return volumes.empty() || !(volumes[0].extent() > 0) ? 0 : sum / volumes[0].extent();
}

}  // namespace tamis::lab
