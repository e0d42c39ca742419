// From a leaf block of one tree down the other tree to pairs of features. Stage by stage over small lists, without
// branches on what boxes meet, which nothing could predict: leaf blocks, features against leaf blocks, features.
#pragma once
#include "kernels/box_overlap.hpp"

namespace tamis::TAMIS_ISA {

/// Positions of the set bits, lowest first.
template <class F>
inline void for_each_bit(unsigned mask, const F& f) {
  for (; mask; mask &= mask - 1) f(__builtin_ctz(mask));
}

/// The bits of sixteen from `first` on.
inline unsigned from_bit(int first) { return first >= kBlock ? 0 : ~0u << std::max(first, 0); }

/// Appends first, first + 1, ... for the bits of `mask`, sixteen at most.
inline void append_bits(unsigned mask, int first, std::int32_t* list, int& count) {
  for_sixteen_lanes([&](int lane) {
    const unsigned some = mask >> lane & ((1u << kFloatLanes) - 1);
    store_compressed(some, counting_from(first + lane), list + count);
    count += __builtin_popcount(some);
  });
}

/// `Boxes`: SweptBoxes, StillBoxes, RestBoxes, BoxesAtEnds or NearBoxes. A row: one feature of the block searched from
/// and the sixteen of another block.
template <PairKind kind, class Boxes, Course course = Course::step>
class BlockSearch {
 public:
  BlockSearch(Search& search, int block)
      : search_(search), block_(block), corners_(search.a.corners[block]), boxes_(search, block) {
    Bounds hulls;
    boxes_.bound(search.a, 1, block / kBlock, hulls);
    for (int k = 0; k < Bounds::kCount; ++k) my_hull_[k] = hulls.at[k][block % kBlock];
    boxes_.bound(search.a, 0, block, mine_);
  }

  void run() {
    if (search_.b.leaf_blocks == 0) return;
    if (search_.others.empty())
      visit(search_.b.level_count - 1, 0);
    else
      visit_others();
    match_leaves();
  }

 private:
  using Bounds = typename Boxes::Bounds;
  static constexpr bool kIsSelf = kind == PairKind::edge_edge;
  static constexpr int kCornersA = kIsSelf || course == Course::along_edge ? 2 : 1, kCornersB = kIsSelf ? 2 : 3;
  static constexpr int kMostLeaves = 32, kAhead = 4;

  void visit(int level, int node) {
    ++search_.nodes_visited;
    Bounds hulls;
    boxes_.bound(search_.b, level, node, hulls);
    const unsigned mask = children_that_meet(level, node, hulls);
    if (level > 1) return for_each_bit(mask, [&](int child) { visit(level - 1, node * kBlock + child); });
    for_each_bit(mask, [&](int child) { append_leaf(node * kBlock + child, hulls, child); });
    if (leaf_count_ > kMostLeaves - kBlock) match_leaves();
  }

  /// Unless none of my features may meet its hull, which is lane `lane` of `hulls`.
  void append_leaf(int leaf, const Bounds& hulls, int lane) {
    leaves_[leaf_count_] = leaf;
    rows_of_[leaf_count_] = rows_that_meet(hulls, lane);
    leaf_count_ += rows_of_[leaf_count_] != 0;
  }

  unsigned children_that_meet(int level, int node, const Bounds& hulls) const {
    unsigned mask = 0;
    for_sixteen_lanes([&](int first) {
      mask |= bits(boxes_.meet([&](int k) { return FloatLanes(my_hull_[k]); },
                               [&](int k) { return hulls.lanes(k, first); }))
              << first;
    });
    // In the same tree only blocks from this one on: child c covers leaf blocks below (c + 1) 16^(level-1).
    if (kIsSelf) mask &= from_bit((block_ >> (4 * (level - 1))) - node * kBlock);
    return search_.a.groups.may_touch ? without_kept_apart(mask, level, node) : mask;
  }

  /// Of the bits of a node's children, those that may touch by their groups.
  unsigned without_kept_apart(unsigned mask, int level, int node) const {
    unsigned rest = mask;
    for_each_bit(mask, [&](int child) {
      if (are_kept_apart(search_.a, block_, search_.b, level - 1, node * kBlock + child)) rest &= ~(1u << child);
    });
    return rest;
  }

  void visit_others() {
    for (const std::int32_t other : search_.others) {
      ++search_.nodes_visited;
      Bounds hulls;
      boxes_.bound(search_.b, 1, other / kBlock, hulls);
      append_leaf(other, hulls, other % kBlock);
      if (leaf_count_ == kMostLeaves) match_leaves();
    }
  }

  void match_leaves() {
    int count = 0;
    for (int i = 0; i < kAhead && i < leaf_count_; ++i) fetch(leaves_[i]);
    for (int i = 0; i < leaf_count_; ++i) {
      if (i + kAhead < leaf_count_) fetch(leaves_[i + kAhead]);
      boxes_.bound(search_.b, 0, leaves_[i], theirs_[i]);
      append_bits(rows_of_[i], kBlock * i, rows_, count);
    }
    int found_count = 0;
    for (int i = 0; i < count; ++i) {
      found_[found_count] = features_that_meet(rows_[i]);
      rows_[found_count] = rows_[i];
      found_count += found_[found_count] != 0;
    }
    for (int i = 0; i < found_count; ++i) append(rows_[i], found_[i]);
    leaf_count_ = 0;
  }

  /// Boxes and corners are on their way while other blocks are looked at.
  void fetch(int leaf) const {
    const auto fetch_all = [](const auto& block) {
      for (std::size_t byte = 0; byte < sizeof(block); byte += 64)
        __builtin_prefetch(reinterpret_cast<const char*>(&block) + byte);
    };
    fetch_all(search_.b.levels[0][leaf]);
    fetch_all(search_.b.corners[leaf]);
  }

  /// Bits of my features that may meet some of the block whose hull is in that lane.
  unsigned rows_that_meet(const Bounds& hulls, int lane) const {
    unsigned mask = 0;
    for_sixteen_lanes([&](int first) {
      mask |= bits(boxes_.meet([&](int k) { return mine_.lanes(k, first); },
                               [&](int k) { return FloatLanes(hulls.at[k][lane]); }))
              << first;
    });
    return mask;
  }

  /// Bits of a block's features that may meet one of mine. `row`: place in leaves_, my lane.
  unsigned features_that_meet(int row) const {
    const int place = row / kBlock, lane = row % kBlock, leaf = leaves_[place];
    const Bounds& theirs = theirs_[place];
    unsigned mask = 0;
    for_sixteen_lanes([&](int first) {
      const auto met = boxes_.meet([&](int k) { return FloatLanes(mine_.at[k][lane]); },
                                   [&](int k) { return theirs.lanes(k, first); });
      mask |= (bits(met) & ~adjacent(lane, search_.b.corners[leaf], first)) << first;
    });
    return kIsSelf && leaf == block_ ? mask & (~1u << lane) : mask;
  }

  /// Bits of the lanes of `theirs` that share a vertex with one of mine; of empty lanes, anything.
  unsigned adjacent(int lane, const CornerBlock& theirs, int first) const {
    using Unsigned = xsimd::batch<std::uint32_t, Arch>;
    Unsigned differ(~0u);  // 0 where two vertices are one: cheaper than as many masks
    for (int c = 0; c < kCornersA; ++c)
      for (int o = 0; o < kCornersB; ++o)
        differ = xsimd::min(differ, xsimd::bitwise_cast<Unsigned>(IntLanes(corners_.vertex[c][lane]) ^
                                                                  IntLanes::load_aligned(theirs.vertex[o] + first)));
    return bits(differ == Unsigned(0u));
  }

  void append(int row, unsigned found) {
    PairBuffer& pairs = *search_.pairs;
    if (pairs.count + kBlock > PairBuffer::kCapacity) search_.flush(search_);
    const CornerBlock& theirs = search_.b.corners[leaves_[row / kBlock]];
    const int lane = row % kBlock;
    for_sixteen_lanes([&](int first) {
      const unsigned mask = found >> first & ((1u << kFloatLanes) - 1);
      const auto put = [&](int corner, const IntLanes& lanes) {
        store_compressed(mask, lanes, pairs.corner[corner] + pairs.count);
      };
      const auto my = [&](int corner) { return IntLanes(corners_.vertex[corner][lane]); };
      const auto their = [&](int corner) { return IntLanes::load_aligned(theirs.vertex[corner] + first); };
      if constexpr (kIsSelf) {
        // The smaller edge first, so that the answer does not depend on the order in the tree: by its first vertex,
        // in which two edges without a common vertex differ.
        const auto is_first = my(0) < their(0);
        for (int c = 0; c < 2; ++c) {
          put(c, select(is_first, my(c), their(c)));
          put(2 + c, select(is_first, their(c), my(c)));
        }
      } else {
        put(0, my(0));
        for (int c = 0; c < kCornersB; ++c) put(1 + c, their(c));
        if constexpr (course == Course::along_edge) put(4, my(1));
      }
      FloatLanes(0.0f).store_unaligned(pairs.t_in + pairs.count);
      FloatLanes(boxes_.t_limit()).store_unaligned(pairs.t_out + pairs.count);
      pairs.count += __builtin_popcount(mask);
    });
  }

  Search& search_;
  const int block_;
  const CornerBlock& corners_;
  const Boxes boxes_;
  float my_hull_[Bounds::kCount];
  Bounds mine_;
  int leaf_count_ = 0;
  alignas(64) std::int32_t leaves_[kMostLeaves + kBlock];
  unsigned rows_of_[kMostLeaves + kBlock];
  Bounds theirs_[kMostLeaves];
  std::int32_t rows_[kMostLeaves * kBlock + kBlock];
  unsigned found_[kMostLeaves * kBlock];
};

}  // namespace tamis::TAMIS_ISA
