// The shape of a binary hierarchy, one triangle a leaf; bounds live beside it, one a node.
#pragma once
#include <span>
#include <vector>

#include "numbers/assert.hpp"
#include "numbers/vec.hpp"
#include "tamis/mesh.hpp"

namespace tamis::lab {

/// Nodes in depth-first order: the left child of node i is i + 1, every child comes after its parent.
class BinaryTree {
 public:
  /// Top-down: triangles are split at the median of the longest side of the box of their centres.
  void build(std::span<const Vec3<double>> centres);

  /// Top-down: each node splits its part of the given order in the middle.
  void build_in_order(std::span<const Index> triangles);

  Index size() const { return static_cast<Index>(links_.size()); }
  bool is_leaf(Index node) const { return link(node) < 0; }
  Index left(Index node) const { return node + 1; }
  Index right(Index node) const { return link(node); }
  /// REQUIRES: a leaf.
  Index triangle(Index node) const {
    TAMIS_ASSERT(is_leaf(node));
    return ~link(node);
  }
  std::uint64_t memory_bytes() const { return links_.capacity() * sizeof(Index); }

 private:
  Index link(Index node) const { return links_[static_cast<std::size_t>(node)]; }

  std::vector<Index> links_;  ///< right child, or complement of the triangle
};

}  // namespace tamis::lab
