// From a leaf block of one tree down the other tree to pairs of features.
#pragma once
#include "kernels/box_overlap.hpp"
#include "kernels/kernels.hpp"

namespace tamis::TAMIS_ISA {

/// Positions of the set bits, lowest first.
template <class F>
inline void for_each_bit(unsigned mask, const F& f) {
  for (; mask; mask &= mask - 1) f(__builtin_ctz(mask));
}

/// Bits of the lanes of `block` of which one of the first `corners` corners is `vertex`.
template <int corners>
inline unsigned lanes_with(const CornerBlock& block, std::int32_t vertex) {
  unsigned result = 0;
  for (int first = 0; first < kBlock; first += kFloatLanes) {
    auto same = IntLanes::load_aligned(block.vertex[0] + first) == IntLanes(vertex);
    for (int c = 1; c < corners; ++c)
      same = same | (IntLanes::load_aligned(block.vertex[c] + first) == IntLanes(vertex));
    result |= bits(same) << first;
  }
  return result;
}

template <PairKind kind>
class BlockSearch {
 public:
  BlockSearch(Search& search, int block)
      : search_(search), block_(block), boxes_(search.a.levels[0][block]), hull_(hull_of(search.a, block)) {}

  void run() {
    if (search_.b.leaf_blocks == 0) return;
    visit(search_.b.level_count - 1, 0);
  }

 private:
  static constexpr bool kIsSelf = kind == PairKind::edge_edge;
  static constexpr int kCornersA = kIsSelf ? 2 : 1, kCornersB = kIsSelf ? 2 : 3;

  static WideBox hull_of(const TreeView& tree, int block) {
    return WideBox(tree.levels[1][block / kBlock], block % kBlock);
  }

  void visit(int level, int node) {
    if (level == 0) return visit_leaf(node);
    ++search_.nodes_visited;
    alignas(64) float t_in[kBlock], t_out[kBlock];
    unsigned mask = overlap(search_.b.levels[level][node], hull_, limit(), t_in, t_out);
    // In the same tree only blocks from this one on: child c covers leaf blocks below (c + 1) 16^(level-1).
    if (kIsSelf) {
      const int first = (block_ >> (4 * (level - 1))) - node * kBlock;
      if (first >= kBlock) return;
      if (first > 0) mask &= ~0u << first;
    }
    for_each_bit(mask, [&](int child) { visit(level - 1, node * kBlock + child); });
  }

  FloatLanes limit() const { return FloatLanes(search_.t_limit); }

  /// First each side's boxes against the other's hull, then row by row on the side where fewer remain.
  void visit_leaf(int other) {
    if (search_.pairs->count + kBlock * kBlock > PairBuffer::kCapacity) search_.flush(search_);
    alignas(64) float t_in[kBlock], t_out[kBlock];
    const BoxBlock& boxes = search_.b.levels[0][other];
    const unsigned rows = overlap(boxes_, hull_of(search_.b, other), limit(), t_in, t_out);
    if (!rows) return;
    const unsigned columns = overlap(boxes, hull_, limit(), t_in, t_out);
    const bool is_same = kIsSelf && other == block_;
    if (__builtin_popcount(columns) < __builtin_popcount(rows) && !is_same)
      for_each_bit(columns, [&](int b) {
        const unsigned mask = overlap(boxes_, WideBox(boxes, b), limit(), t_in, t_out) & rows;
        if (mask) add_column(other, b, mask, t_in, t_out);
      });
    else
      for_each_bit(rows, [&](int a) {
        unsigned mask = overlap(boxes, WideBox(boxes_, a), limit(), t_in, t_out) & columns;
        if (is_same) mask &= ~1u << a;
        if (mask) add_row(a, other, mask, t_in, t_out);
      });
  }

  void add_row(int a, int other, unsigned mask, const float* t_in, const float* t_out) {
    const CornerBlock &mine = search_.a.corners[block_], &theirs = search_.b.corners[other];
    for (int c = 0; c < kCornersA; ++c) mask &= ~lanes_with<kCornersB>(theirs, mine.vertex[c][a]);
    for_each_bit(mask, [&](int b) { add(mine, a, theirs, b, t_in[b], t_out[b]); });
  }

  void add_column(int other, int b, unsigned mask, const float* t_in, const float* t_out) {
    const CornerBlock &mine = search_.a.corners[block_], &theirs = search_.b.corners[other];
    for (int c = 0; c < kCornersB; ++c) mask &= ~lanes_with<kCornersA>(mine, theirs.vertex[c][b]);
    for_each_bit(mask, [&](int a) { add(mine, a, theirs, b, t_in[a], t_out[a]); });
  }

  /// ee: the smaller edge first, so that the answer does not depend on the order in the tree.
  void add(const CornerBlock& mine, int a, const CornerBlock& theirs, int b, float t_in, float t_out) {
    PairBuffer& pairs = *search_.pairs;
    const int at = pairs.count++;
    if constexpr (kIsSelf) {
      const auto key = [](std::int32_t v0, std::int32_t v1) { return (std::int64_t{v0} << 32) | v1; };
      const std::int64_t edge_a = key(mine.vertex[0][a], mine.vertex[1][a]);
      const std::int64_t edge_b = key(theirs.vertex[0][b], theirs.vertex[1][b]);
      const std::int64_t first = edge_a < edge_b ? edge_a : edge_b, second = edge_a < edge_b ? edge_b : edge_a;
      pairs.corner[0][at] = static_cast<std::int32_t>(first >> 32);
      pairs.corner[1][at] = static_cast<std::int32_t>(first);
      pairs.corner[2][at] = static_cast<std::int32_t>(second >> 32);
      pairs.corner[3][at] = static_cast<std::int32_t>(second);
    } else {
      pairs.corner[0][at] = mine.vertex[0][a];
      for (int c = 0; c < kCornersB; ++c) pairs.corner[1 + c][at] = theirs.vertex[c][b];
    }
    pairs.t_in[at] = static_cast<double>(t_in);
    pairs.t_out[at] = static_cast<double>(t_out);
  }

  Search& search_;
  const int block_;
  const BoxBlock& boxes_;
  const WideBox hull_;
};

}  // namespace tamis::TAMIS_ISA
