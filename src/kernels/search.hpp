// From a leaf block of one tree down the other tree to pairs of features. Stage by stage over small lists, without
// branches on what boxes meet, which nothing could predict: leaf blocks, fours of features against fours, features.
#pragma once
#include "kernels/box_overlap.hpp"

namespace tamis::TAMIS_ISA {

/// Positions of the set bits, lowest first.
template <class F>
inline void for_each_bit(unsigned mask, const F& f) {
  for (; mask; mask &= mask - 1) f(__builtin_ctz(mask));
}

/// Calls f(first, count) for the batches that make up sixteen lanes.
template <class F>
[[gnu::always_inline]] inline void for_sixteen_lanes(const F& f) {
  for (int first = 0; first < kBlock; first += kFloatLanes) f(first);
}

/// Appends first, first + 1, ... for the bits of `mask`, sixteen at most.
inline void append_bits(unsigned mask, int first, std::int32_t* list, int& count) {
  for_sixteen_lanes([&](int lane) {
    const unsigned some = mask >> lane & ((1u << kFloatLanes) - 1);
    store_compressed(some, counting_from(first + lane), list + count);
    count += __builtin_popcount(some);
  });
}

/// `Boxes`: SweptBoxes, BoxesAtEnds or NearBoxes. A four: lanes 4k to 4k + 3 of a leaf block, which lie close together
/// (bvh/spatial_order.hpp). Sixteen pairs at once: lane 4i + j stands for feature i of a four of the block searched
/// from and feature j of a four of the other.
template <PairKind kind, class Boxes>
class BlockSearch {
 public:
  BlockSearch(Search& search, int block) : search_(search), block_(block), boxes_(search, block) {
    Bounds bounds;
    boxes_.bound(search.a, 1, block / kBlock, bounds);
    for (int k = 0; k < Bounds::kCount; ++k) hull_[k] = bounds.at[k][block % kBlock];
    boxes_.bound(search.a, 0, block, bounds);
    const CornerBlock& corners = search.a.corners[block];
    for (std::size_t four = 0; four < 4; ++four) {
      Four& mine = fours_[four];
      for_sixteen_lanes([&](int first) {
        for (int k = 0; k < Bounds::kCount; ++k)
          each_four_times(bounds.at[k] + 4 * four, first).store_aligned(mine.bounds.at[k] + first);
        for (int c = 0; c < kCornersA; ++c)
          each_four_times(corners.vertex[c] + 4 * four, first).store_aligned(mine.vertex[c] + first);
      });
    }
    for (int k = 0; k < Bounds::kCount; ++k)
      for_sixteen_lanes([&](int first) { hull_of_fours(bounds, k, first).store_aligned(bounds.at[k] + first); });
    for (int k = 0; k < Bounds::kCount; ++k)
      for (std::size_t four = 0; four < 4; ++four) four_hulls_[k][four] = bounds.at[k][4 * four];
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
  static constexpr int kCornersA = kIsSelf ? 2 : 1, kCornersB = kIsSelf ? 2 : 3;
  static constexpr int kMostLeaves = 32, kAhead = 4;

  /// Each of its four features four times: in lanes 4i to 4i + 3 feature i.
  struct Four {
    Bounds bounds;
    alignas(64) std::int32_t vertex[kCornersA][kBlock];
  };

  /// In the lanes of each four: of bound k.
  static FloatLanes hull_of_fours(const Bounds& bounds, int k, int first) {
    return k < Bounds::kCount / 2 ? least_of_four(bounds.lanes(k, first)) : largest_of_four(bounds.lanes(k, first));
  }

  void visit(int level, int node) {
    ++search_.nodes_visited;
    Bounds hulls;
    boxes_.bound(search_.b, level, node, hulls);
    unsigned mask = 0;
    for_sixteen_lanes([&](int first) {
      mask |=
          bits(boxes_.meet([&](int k) { return FloatLanes(hull_[k]); }, [&](int k) { return hulls.lanes(k, first); }))
          << first;
    });
    // In the same tree only blocks from this one on: child c covers leaf blocks below (c + 1) 16^(level-1).
    if (kIsSelf) {
      const int first = (block_ >> (4 * (level - 1))) - node * kBlock;
      if (first >= kBlock) return;
      if (first > 0) mask &= ~0u << first;
    }
    if (level > 1) return for_each_bit(mask, [&](int child) { visit(level - 1, node * kBlock + child); });
    append_bits(mask, node * kBlock, leaves_, leaf_count_);
    if (leaf_count_ > kMostLeaves - kBlock) match_leaves();
  }

  void visit_others() {
    for (const std::int32_t other : search_.others) {
      ++search_.nodes_visited;
      leaves_[leaf_count_++] = other;
      if (leaf_count_ == kMostLeaves) match_leaves();
    }
  }

  void match_leaves() {
    int count = 0;
    for (int i = 0; i < kAhead && i < leaf_count_; ++i) fetch(leaves_[i]);
    for (int i = 0; i < leaf_count_; ++i) {
      if (i + kAhead < leaf_count_) fetch(leaves_[i + kAhead]);
      boxes_.bound(search_.b, 0, leaves_[i], theirs_[i]);
      append_bits(fours_that_meet(leaves_[i], theirs_[i]), kBlock * i, matches_, count);
    }
    int found_count = 0;
    for (int i = 0; i < count; ++i) {
      found_[found_count] = features_that_meet(matches_[i]);
      matches_[found_count] = matches_[i];
      found_count += found_[found_count] != 0;
    }
    for (int i = 0; i < found_count; ++i) append(matches_[i], found_[i]);
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

  /// Bit 4i + j: their four i may meet my four j.
  unsigned fours_that_meet(int leaf, const Bounds& theirs) const {
    unsigned mask = 0;
    for_sixteen_lanes([&](int first) {
      mask |= bits(boxes_.meet([&](int k) { return repeat_four(four_hulls_[k]); },
                               [&](int k) { return hull_of_fours(theirs, k, first); }))
              << first;
    });
    constexpr unsigned kNotBefore = 0xf731;  // within one block: i >= j
    return kIsSelf && leaf == block_ ? mask & kNotBefore : mask;
  }

  /// `match`: place in leaves_, their four, my four.
  unsigned features_that_meet(int match) const {
    const int place = match / kBlock, other = match / 4 % 4, four = match % 4, leaf = leaves_[place];
    const Bounds& theirs = theirs_[place];
    const Four& mine = fours_[four];
    unsigned mask = 0;
    for_sixteen_lanes([&](int first) {
      const auto met = boxes_.meet([&](int k) { return mine.bounds.lanes(k, first); },
                                   [&](int k) { return repeat_four(theirs.at[k] + 4 * other); });
      mask |= (bits(met) & ~adjacent(mine, search_.b.corners[leaf], 4 * other, first)) << first;
    });
    constexpr unsigned kAfter = 0x08ce;  // within one four: j > i
    return kIsSelf && leaf == block_ && other == four ? mask & kAfter : mask;
  }

  /// Bits of the lanes whose two features share a vertex; of empty lanes, anything.
  static unsigned adjacent(const Four& mine, const CornerBlock& theirs, int lane, int first) {
    using Unsigned = xsimd::batch<std::uint32_t, Arch>;
    Unsigned differ(~0u);  // 0 where two vertices are one: cheaper than as many masks
    for (int c = 0; c < kCornersA; ++c)
      for (int o = 0; o < kCornersB; ++o)
        differ = xsimd::min(differ, xsimd::bitwise_cast<Unsigned>(IntLanes::load_aligned(mine.vertex[c] + first) ^
                                                                  repeat_four(theirs.vertex[o] + lane)));
    return bits(differ == Unsigned(0u));
  }

  void append(int match, unsigned found) {
    PairBuffer& pairs = *search_.pairs;
    if (pairs.count + kBlock > PairBuffer::kCapacity) search_.flush(search_);
    const Four& mine = fours_[match % 4];
    const CornerBlock& theirs = search_.b.corners[leaves_[match / kBlock]];
    const int lane = match / 4 % 4 * 4;
    for_sixteen_lanes([&](int first) {
      const unsigned mask = found >> first & ((1u << kFloatLanes) - 1);
      const auto put = [&](int corner, const IntLanes& lanes) {
        store_compressed(mask, lanes, pairs.corner[corner] + pairs.count);
      };
      const auto my = [&](int corner) { return IntLanes::load_aligned(mine.vertex[corner] + first); };
      const auto their = [&](int corner) { return repeat_four(theirs.vertex[corner] + lane); };
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
      }
      FloatLanes(0.0f).store_unaligned(pairs.t_in + pairs.count);
      FloatLanes(boxes_.t_limit()).store_unaligned(pairs.t_out + pairs.count);
      pairs.count += __builtin_popcount(mask);
    });
  }

  Search& search_;
  const int block_;
  const Boxes boxes_;
  float hull_[Bounds::kCount];
  float four_hulls_[Bounds::kCount][4];
  Four fours_[4];
  int leaf_count_ = 0;
  alignas(64) std::int32_t leaves_[kMostLeaves + kBlock];
  Bounds theirs_[kMostLeaves];
  std::int32_t matches_[kMostLeaves * kBlock + kBlock];
  unsigned found_[kMostLeaves * kBlock];
};

}  // namespace tamis::TAMIS_ISA
