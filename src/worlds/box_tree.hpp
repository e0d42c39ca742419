// A hierarchy of any items in space: features of a shape, bodies of a world. The order of items is made once. Boxes are
// made again whenever items have moved.
#pragma once
#include <span>
#include <vector>

#include "numbers/held_bytes.hpp"
#include "search/bounds/box.hpp"
#include "search/bounds/moving_boxes.hpp"
#include "search/bvh/spatial_order.hpp"
#include "search/topology/at.hpp"

namespace tamis {

/// Items sixteen to a leaf (kBlock), sixteen nodes to a node above, and so on up to one root. Nodes are numbered: the
/// leaves first, then level by level. The root is the last one.
class BoxTree {
 public:
  BoxTree() = default;  ///< to be assigned to
  /// One center an item.
  explicit BoxTree(std::span<const Point> centers);

  Index leaf_count() const { return static_cast<Index>((items_.size() + kBlock - 1) / kBlock); }
  Index node_count() const { return leaf_count() + static_cast<Index>(first_child_.size()) - 1; }
  /// REQUIRES: there are items.
  Index root() const { return node_count() - 1; }
  bool is_leaf(Index node) const { return node < leaf_count(); }
  /// The items of a leaf.
  std::span<const Index> items_of(Index leaf) const {
    const std::size_t first = at(leaf) * kBlock;
    return std::span(items_).subspan(first, std::min<std::size_t>(kBlock, items_.size() - first));
  }
  /// Calls f(child), ascending, for each child of a node that is not a leaf.
  template <class F>
  void for_each_child(Index node, const F& f) const {
    const std::size_t inner = at(node - leaf_count());
    for (Index child = first_child_[inner]; child < first_child_[inner + 1]; ++child) f(child);
  }
  /// The boxes of all nodes. `box_of(item)`: an item's Box.
  template <class F>
  std::vector<Box> boxes(const F& box_of) const {
    std::vector<Box> boxes(at(node_count()));
    for (Index node = 0; node < node_count(); ++node)
      if (is_leaf(node))
        for (const Index item : items_of(node)) boxes[at(node)].include(box_of(item));
      else
        for_each_child(node, [&](Index child) { boxes[at(node)].include(boxes[at(child)]); });
    return boxes;
  }
  std::uint64_t memory_bytes() const { return held_bytes(items_, first_child_); }

 private:
  std::vector<Index> items_;        ///< leaf by leaf
  std::vector<Index> first_child_;  ///< of each node that is not a leaf; the last entry is the root's number
};

}  // namespace tamis
