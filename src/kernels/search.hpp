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

/// Bits of the lanes of `block` that share a vertex with feature `lane` of `other`; of empty lanes, anything.
template <int corners, int other_corners>
inline unsigned adjacent_lanes(const CornerBlock& block, const CornerBlock& other, int lane) {
  using Unsigned = xsimd::batch<std::uint32_t, Arch>;
  unsigned result = 0;
  for (int first = 0; first < kBlock; first += kFloatLanes) {
    Unsigned differ(~0u);  // 0 where two vertices are one: cheaper than as many masks
    for (int c = 0; c < corners; ++c)
      for (int o = 0; o < other_corners; ++o)
        differ = xsimd::min(differ, xsimd::bitwise_cast<Unsigned>(IntLanes::load_aligned(block.vertex[c] + first) ^
                                                                  IntLanes(other.vertex[o][lane])));
    result |= bits(differ == Unsigned(0u)) << first;
  }
  return result;
}

/// `Boxes`: MovingBoxes, SweptBoxes or NearBoxes.
template <PairKind kind, class Boxes>
class BlockSearch {
 public:
  BlockSearch(Search& search, int block)
      : search_(search),
        block_(block),
        boxes_(search.a, 0, block, search),
        hull_(Sixteen(search.a, 1, block / kBlock, search), block % kBlock) {}

  void run() {
    if (search_.b.leaf_blocks == 0) return;
    if (!search_.others.empty()) return visit_others();
    visit(search_.b.level_count - 1, 0);
  }

 private:
  using Sixteen = typename Boxes::Sixteen;
  using One = typename Boxes::One;
  static constexpr bool kIsSelf = kind == PairKind::edge_edge;
  static constexpr int kCornersA = kIsSelf ? 2 : 1, kCornersB = kIsSelf ? 2 : 3;

  void visit(int level, int node) {
    ++search_.nodes_visited;
    const Sixteen hulls(search_.b, level, node, search_);
    unsigned mask = meet(hulls, hull_);
    // In the same tree only blocks from this one on: child c covers leaf blocks below (c + 1) 16^(level-1).
    if (kIsSelf) {
      const int first = (block_ >> (4 * (level - 1))) - node * kBlock;
      if (first >= kBlock) return;
      if (first > 0) mask &= ~0u << first;
    }
    if (level == 1) return visit_leaves(node, hulls, mask);
    for_each_bit(mask, [&](int child) { visit(level - 1, node * kBlock + child); });
  }

  void visit_others() {
    for (const std::int32_t other : search_.others) {
      ++search_.nodes_visited;
      const unsigned rows = meet(boxes_, One(Sixteen(search_.b, 1, other / kBlock, search_), other % kBlock));
      const unsigned columns = meet(Sixteen(search_.b, 0, other, search_), hull_);
      if (rows && columns) visit_leaf(other, rows, columns);
    }
  }

  /// First each side's boxes against the other's hull, in all leaf blocks before the first branch; then one by one on
  /// the side where fewer remain.
  void visit_leaves(int node, const Sixteen& hulls, unsigned mask) {
    unsigned rows[kBlock], columns[kBlock], both = 0;
    for_each_bit(mask, [&](int child) {
      rows[child] = meet(boxes_, One(hulls, child));
      columns[child] = meet(Sixteen(search_.b, 0, node * kBlock + child, search_), hull_);
      both |= static_cast<unsigned>((rows[child] != 0) & (columns[child] != 0)) << child;
    });
    for_each_bit(both, [&](int child) { visit_leaf(node * kBlock + child, rows[child], columns[child]); });
  }

  unsigned meet(const Sixteen& boxes, const One& one) {
    return Boxes::meet(boxes, one, times_.t_in[0], times_.t_out[0]);
  }

  void visit_leaf(int other, unsigned rows, unsigned columns) {
    if (search_.pairs->count + kBlock * kBlock > PairBuffer::kCapacity) search_.flush(search_);
    const Sixteen boxes(search_.b, 0, other, search_);
    const CornerBlock &mine = search_.a.corners[block_], &theirs = search_.b.corners[other];
    if (kIsSelf && other == block_)
      match<kCornersA, kCornersB>({boxes, theirs, columns}, {boxes_, mine, rows}, [](int a) { return ~1u << a; });
    else if (__builtin_popcount(columns) < __builtin_popcount(rows))
      match<kCornersA, kCornersB>({boxes_, mine, rows}, {boxes, theirs, columns}, [](int) { return ~0u; });
    else
      match<kCornersB, kCornersA>({boxes, theirs, columns}, {boxes_, mine, rows}, [](int) { return ~0u; });
  }

  /// Some lanes of a leaf block.
  struct Side {
    const Sixteen& boxes;
    const CornerBlock& corners;
    unsigned lanes;
  };

  /// Each lane of `few` against all those of `many` at once, as far as `lets` bits of them. All boxes first, without a
  /// branch on what comes out, which nothing could predict; then what was found.
  template <int many_corners, int few_corners, class Lets>
  void match(const Side& many, const Side& few, const Lets& lets) {
    unsigned found[kBlock], any_found = 0;
    for_each_bit(few.lanes, [&](int lane) {
      const unsigned met = Boxes::meet(many.boxes, One(few.boxes, lane), times_.t_in[lane], times_.t_out[lane]);
      found[lane] =
          met & many.lanes & lets(lane) & ~adjacent_lanes<many_corners, few_corners>(many.corners, few.corners, lane);
      any_found |= static_cast<unsigned>(found[lane] != 0) << lane;
    });
    for_each_bit(any_found, [&](int lane) { append<many_corners>(many.corners, few.corners, lane, found[lane]); });
  }

  template <int many_corners>
  void append(const CornerBlock& many, const CornerBlock& few, int lane, unsigned found) {
    PairBuffer& pairs = *search_.pairs;
    for (int first = 0; first < kBlock; first += kFloatLanes) {
      const unsigned mask = found >> first & ((1u << kFloatLanes) - 1);
      const auto put = [&](auto* to, const auto& lanes) { store_compressed(mask, lanes, to + pairs.count); };
      const auto one_of_many = [&](int corner) { return IntLanes::load_aligned(many.vertex[corner] + first); };
      const auto the_lane = [&](int corner) { return IntLanes(few.vertex[corner][lane]); };
      if constexpr (kIsSelf) {
        // The smaller edge first, so that the answer does not depend on the order in the tree: by its first vertex,
        // in which two edges without a common vertex differ.
        const auto is_first = one_of_many(0) < the_lane(0);
        for (int c = 0; c < 2; ++c) {
          put(pairs.corner[c], select(is_first, one_of_many(c), the_lane(c)));
          put(pairs.corner[2 + c], select(is_first, the_lane(c), one_of_many(c)));
        }
      } else if constexpr (many_corners == kCornersA) {
        put(pairs.corner[0], one_of_many(0));
        for (int c = 0; c < kCornersB; ++c) put(pairs.corner[1 + c], the_lane(c));
      } else {
        put(pairs.corner[0], the_lane(0));
        for (int c = 0; c < kCornersB; ++c) put(pairs.corner[1 + c], one_of_many(c));
      }
      put(pairs.t_in, FloatLanes::load_aligned(times_.t_in[lane] + first));
      put(pairs.t_out, FloatLanes::load_aligned(times_.t_out[lane] + first));
      pairs.count += __builtin_popcount(mask);
    }
  }

  Search& search_;
  const int block_;
  const Sixteen boxes_;
  const One hull_;
  struct {
    alignas(64) float t_in[kBlock][kBlock], t_out[kBlock][kBlock];
  } times_;  ///< [lane of the few][lane of the many]
};

}  // namespace tamis::TAMIS_ISA
