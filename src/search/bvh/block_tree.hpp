// The hierarchy. Features are in an order that halves space again and again (spatial_order.hpp). Sixteen make a leaf
// block, sixteen blocks make a node, and so on up to one root block. The tree is implicit: child c of block b is block
// 16 b + c of the level below.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "numbers/held_bytes.hpp"
#include "numbers/platform.hpp"
#include "numbers/raw_array.hpp"
#include "search/bounds/moving_boxes.hpp"
#include "search/bounds/packed_motion.hpp"
#include "search/bvh/group_order.hpp"
#include "search/bvh/order_axes.hpp"
#include "tamis/mesh.hpp"

namespace tamis {

/// 16^8 > 2^31 features.
inline constexpr int kMaxLevels = 9;

/// Which blocks hold features of one group alone, and which groups may touch.
struct BlockGroups {
  const Index* of[kMaxLevels];    ///< of[k]: the group of each block of levels[k], kMixed if there are several
  const std::uint8_t* may_touch;  ///< group_count x group_count, symmetric, row-major; null: all may
  Index group_count;

  static constexpr Index kMixed = -1;
};

/// The view of a tree for kernels.
struct TreeView {
  const BoxBlock* levels[kMaxLevels];     ///< levels[0]: features, levels[k]: hulls of the blocks of levels[k-1]
  const BoxBlock* residuals[kMaxLevels];  ///< the same of the residuals of their vertices; null without
  int level_count;
  int leaf_blocks;
  const CornerBlock* corners;
  BlockGroups groups;
  /// For each block of levels[k]: whether it holds a marked feature. Null: nothing is marked, all pairs are of
  /// interest.
  const std::uint8_t* marked[kMaxLevels];
  bool has_exclusions;  ///< by groups or marks
};

/// True if no feature of leaf block `block` of `a` makes a pair of interest with a feature of block `other` in level
/// `level` of `b`. Either their groups may not touch, or neither block holds a marked feature.
TAMIS_ALWAYS_INLINE bool are_excluded(const TreeView& a, int block, const TreeView& b, int level, int other) {
  if (a.marked[0] && !a.marked[0][block] && !b.marked[level][other]) return true;
  if (!a.groups.may_touch) return false;
  const std::ptrdiff_t mine = a.groups.of[0][block], theirs = b.groups.of[level][other];
  return mine >= 0 && theirs >= 0 && a.groups.may_touch[mine * a.groups.group_count + theirs] == 0;
}

/// Computes the boxes of a leaf block's features. These have `corners` vertices each and fill the first `in_use` lanes.
/// Extends `hull` by them. One of the kernels.
using BoundLeaf = void (*)(const BoxVertex* vertices, const CornerBlock& block, int corners, int in_use,
                           const BoxMargins& margins, BoxBlock& boxes, MovingBox& hull);

class BlockTree {
 public:
  /// Points, edges or faces. The span must outlive the tree.
  void set_features(std::span<const Index> points);
  template <std::size_t corners>
  void set_features(std::span<const std::array<Index, corners>> features) {
    corners_ = static_cast<int>(corners);
    vertices_ = features.empty() ? std::span<const Index>() : std::span(features[0].data(), corners * features.size());
  }
  /// The groups of all vertices, as PairFilter has them. A feature has the group of its first vertex. Keeps the spans.
  void set_groups(std::span<const Index> group_of_vertex, std::span<const std::uint8_t> may_touch, Index group_count);

  /// Chooses the order by these axes, then refits. An exception of `pause` leaves a tree that can only be built again.
  void build(
      const PackedMotion& motion, const OrderAxes& by, BoundLeaf bound_leaf, const Pause& pause = [] {});
  bool is_built() const { return is_built_; }
  /// New boxes in the old order. REQUIRES: is_built(); REQUIRES (not checked: O(n)): positions of all vertices.
  void refit(const PackedMotion& motion, BoundLeaf bound_leaf);
  /// Boxes of `motion`'s residuals. REQUIRES: as refit(), and a residual for each vertex.
  void refit_residuals(const PackedMotion& motion, BoundLeaf bound_leaf);

  Index feature_count() const { return static_cast<Index>(vertices_.size() / static_cast<std::size_t>(corners_)); }
  TreeView view() const;
  /// Marks the features that have a vertex with a nonzero entry; empty: no marks. REQUIRES: is_built(), or empty.
  void mark(std::span<const std::uint8_t> of_vertex);
  /// Half the surface area of the leaf blocks' hulls, summed, in the frame of the boxes. A traversal's cost grows with
  /// it.
  struct Areas {
    double at_start = 0, swept = 0;
  };
  Areas areas() const;
  std::uint64_t memory_bytes() const {
    return held_bytes(corner_blocks_, no_self_contact_, levels_, residuals_, group_of_block_, marked_);
  }

 private:
  /// True if there is a group without self-contact, and any other group.
  bool separates_groups() const {
    return groups_.group_count > 1 && std::ranges::find(no_self_contact_, std::uint8_t{1}) != no_self_contact_.end();
  }
  Index vertex_of(Index feature, std::size_t corner) const {
    return vertices_[static_cast<std::size_t>(feature) * static_cast<std::size_t>(corners_) + corner];
  }
  GroupOrder order_groups(const PackedMotion& motion) const;
  template <int axes>
  void choose_order(const PackedMotion& motion, const OrderAxes& by, const Pause& pause);
  void group_blocks();
  using Levels = std::vector<RawArray<BoxBlock>>;

  /// Fills all levels with boxes around `vertices`.
  void fill(Levels& levels, const std::vector<BoxVertex>& vertices, const BoxMargins& margins,
            BoundLeaf bound_leaf) const;

  bool is_built_ = false;
  int corners_ = 1;
  std::span<const Index> vertices_;
  RawArray<CornerBlock> corner_blocks_;
  Levels levels_, residuals_;
  std::span<const Index> group_of_vertex_;
  BlockGroups groups_{};
  std::vector<std::uint8_t> no_self_contact_;       ///< of each group, as 0 or 1
  std::vector<std::vector<Index>> group_of_block_;  ///< as BlockGroups::of
  std::vector<std::vector<std::uint8_t>> marked_;   ///< as TreeView::marked; empty: no marks
};

}  // namespace tamis
