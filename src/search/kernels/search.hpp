// The traversal: from a leaf block of one tree down the other tree, to the leaf blocks that it may meet. Their features
// are then tested by LeafRows.
#pragma once
#include "search/kernels/leaf_rows.hpp"

namespace tamis::TAMIS_ISA {

/// The bits of sixteen from `first` on.
inline unsigned from_bit(int first) { return first >= kBlock ? 0 : ~0u << std::max(first, 0); }

/// `Boxes`: the box test, MovingBoxes, RestBoxes, KeepBoxes or ClearanceBoxes.
template <PairKind kind, class Boxes, Course course = Course::step>
class BlockSearch {
 public:
  BlockSearch(Search& search, int block)
      : search_(search), block_(block), boxes_(search, block), rows_(search, block, boxes_) {
    Bounds hulls;
    boxes_.bound(search.a, 1, block / kBlock, hulls);
    for (int k = 0; k < Bounds::kCount; ++k) my_hull_[k] = hulls.at[k][block % kBlock];
    if constexpr (Boxes::kMoves) means_ = boxes_.means(search.a.levels[0][block], rows_.bounds());
    if constexpr (Boxes::kHasReach) expect_short_reaches();
  }

  void run() {
    if (search_.b.leaf_blocks == 0) return;
    visit(search_.b.level_count - 1, 0);
    rows_.match();
  }

 private:
  using Bounds = typename Boxes::Bounds;
  /// A reach up to this part of a leaf block's extent is short. Hardly any features but neighbours are within
  /// it. On small motions 0.02 loses a gain of 1.23; 0.15 takes 1.4 times as long.
  static constexpr float kShortReach = 0x1p-4f;

  void visit(int level, int node) {
    ++search_.nodes_visited;
    Bounds hulls;
    boxes_.bound(search_.b, level, node, hulls);
    unsigned mask = children_that_meet(level, node, hulls), fast = 0;
    if constexpr (Boxes::kMoves) {
      const BoxBlock& children = search_.b.levels[level][node];
      fast = mask & boxes_.move_far(children, hulls, means_);
      if (fast)
        mask &= ~fast | boxes_.meet_at_some_time(search_.a.levels[1][block_ / kBlock], block_ % kBlock, children);
    }
    if (level > 1) return for_each_bit(mask, [&](int child) { visit(level - 1, node * kBlock + child); });
    if constexpr (Boxes::kHasReach) find_reaches(node, hulls);
    for_each_bit(mask, [&](int child) {
      MetLeaf leaf{node * kBlock + child, fast >> child & 1 ? Test::some_time : Test::boxes, 0, 0};
      if constexpr (Boxes::kHasReach)
        if (has_short_reaches_ && reaches_[child] >= 0) leaf = {leaf.block, Test::reach, reaches_[child], 0};
      rows_.append(leaf, hulls, child);
    });
    if (rows_.is_full()) rows_.match();
  }

  unsigned children_that_meet(int level, int node, const Bounds& hulls) const {
    unsigned mask = lanes_that_meet(
        boxes_, [&](int k, int) { return FloatLanes(my_hull_[k]); },
        [&](int k, int first) { return hulls.lanes(k, first); });
    // Of the same tree only leaf blocks from mine on: child c covers leaf blocks below (c + 1) 16^(level-1).
    if constexpr (RowPairs<kind, course>::kIsSelf) mask &= from_bit((block_ >> (4 * (level - 1))) - node * kBlock);
    return search_.a.has_exclusions ? without_excluded(mask, level, node) : mask;
  }

  /// Clears the bits of children that make no pair of interest with mine.
  unsigned without_excluded(unsigned mask, int level, int node) const {
    unsigned rest = mask;
    for_each_bit(mask, [&](int child) {
      if (are_excluded(search_.a, block_, search_.b, level - 1, node * kBlock + child)) rest &= ~(1u << child);
    });
    return rest;
  }

  /// True if some reach can be short. The reach between two blocks is at least half of the reach within mine. Any
  /// residual is at least half the range of my residuals away from one end of that range.
  void expect_short_reaches() {
    const auto mine = [&](int k) { return FloatLanes(my_hull_[k]); };
    extent_ = extent(search_, block_);
    has_short_reaches_ = boxes_.reach(mine, mine).get(0) <= 2 * kShortReach * extent_;
  }

  /// Computes the reach between my block and each leaf block of a node; -1 where it is not short.
  void find_reaches(int node, const Bounds& hulls) {
    if (!has_short_reaches_) return;
    for_sixteen_lanes([&](int first) {
      const FloatLanes reach =
          boxes_.reach([&](int k) { return FloatLanes(my_hull_[k]); }, [&](int k) { return hulls.lanes(k, first); });
      const FloatLanes least = min(FloatLanes(extent_), extent_at_start(search_.b.levels[1][node], first));
      select(reach <= FloatLanes(kShortReach) * least, reach, FloatLanes(-1.0f)).store_aligned(reaches_ + first);
    });
  }

  Search& search_;
  const int block_;
  const Boxes boxes_;
  LeafRows<kind, Boxes, course> rows_;
  float my_hull_[Bounds::kCount];
  MovingBoxes::Means means_;
  bool has_short_reaches_ = false;
  float extent_ = 0;
  alignas(64) float reaches_[kBlock];  ///< of the leaf blocks of a node
};

}  // namespace tamis::TAMIS_ISA
