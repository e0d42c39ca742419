// A hierarchy of any items in space: features of a shape, bodies of a world. The order is made once, the boxes over it
// as often as items move.
#pragma once
#include <span>
#include <vector>

#include "bounds/box.hpp"
#include "bounds/moving_boxes.hpp"
#include "bvh/spatial_order.hpp"
#include "numerics/held_bytes.hpp"

namespace tamis {

/// Items sixteen to a block (kBlock), sixteen blocks to a node, and so on up to one root: child c of block b is block
/// 16 b + c of the level below. Level 0 holds the blocks of items.
class SpaceOrder {
 public:
  SpaceOrder() = default;
  /// One center an item.
  SpaceOrder(std::span<const Point> centers, Split split);

  std::span<const Index> items_of(Index block) const {
    const auto first = static_cast<std::size_t>(block) * kBlock;
    return std::span(items_).subspan(first, std::min<std::size_t>(kBlock, items_.size() - first));
  }
  std::size_t block_count() const { return (items_.size() + kBlock - 1) / kBlock; }
  std::uint64_t memory_bytes() const { return held_bytes(items_); }

 private:
  std::vector<Index> items_;
};

/// The boxes of a hierarchy, [level][block].
class BoxLevels {
 public:
  BoxLevels() = default;
  /// `box_of(item)`: a Box.
  template <class F>
  BoxLevels(const SpaceOrder& order, const F& box_of) {
    if (order.block_count() == 0) return;
    std::vector<Box>& leaves = levels_.emplace_back(order.block_count());
    for (std::size_t block = 0; block < leaves.size(); ++block)
      for (const Index item : order.items_of(static_cast<Index>(block))) leaves[block].include(box_of(item));
    build_upwards();
  }

  int root_level() const { return static_cast<int>(levels_.size()) - 1; }
  std::span<const Box> level(int k) const { return levels_[static_cast<std::size_t>(k)]; }
  const Box& box(int level, Index block) const {
    return levels_[static_cast<std::size_t>(level)][static_cast<std::size_t>(block)];
  }
  std::uint64_t memory_bytes() const { return held_bytes(levels_); }

 private:
  void build_upwards();

  std::vector<std::vector<Box>> levels_;
};

}  // namespace tamis
