// The pairs of a row: one feature of a leaf block and the sixteen of another. Finds the neighbours of the one among the
// sixteen. Appends the features that meet it to the buffer.
#pragma once
#include "search/kernels/compress.hpp"

namespace tamis::TAMIS_ISA {

/// Whether a row's one feature is of the block searched from ("mine"), or of a block of the tree ("theirs").
enum class One { mine, theirs };

/// The data of two blocks, ordered by their roles in a row.
template <class T>
struct OfRow {
  const T &one, &sixteen;
};
template <One one, class T>
inline OfRow<T> of_row(const T& mine, const T& theirs) {
  if constexpr (one == One::mine)
    return {mine, theirs};
  else
    return {theirs, mine};
}

/// Pairs of the rows between one block and the leaf blocks of search.b.
template <PairKind kind, Course course>
class RowPairs {
 public:
  /// Both blocks are of one tree, so a pair is found from both sides.
  static constexpr bool kIsSelf = kind == PairKind::edge_edge;

  RowPairs(Search& search, int block) : search_(search), block_(block), mine_(search.a.corners[block]) {}

  /// Bits of the sixteen that share a vertex with the one, which is in lane `lane`. If both blocks are the same, also
  /// bits of the lanes up to `lane`, so each pair is found once.
  template <One one>
  unsigned neighbours(int leaf, int lane) const {
    const unsigned found_already = kIsSelf && leaf == block_ ? ~(~1u << lane) : 0;
    return found_already |
           bits_of_sixteen([&](int first) { return are_adjacent<one>(lane, search_.b.corners[leaf], first); });
  }

  /// Appends to the buffer the pairs of the one feature, in lane `lane`, with the features whose bits are in `found`.
  template <One one>
  void append(int leaf, int lane, unsigned found, float t_limit) const {
    PairBuffer& pairs = *search_.pairs;
    if (pairs.count + kBlock > PairBuffer::kCapacity) search_.flush(search_);
    const CornerBlock& theirs = search_.b.corners[leaf];
    for_sixteen_lanes([&](int first) {
      const unsigned mask = found >> first & ((1u << kFloatLanes) - 1);
      const auto put = [&](int corner, const IntLanes& lanes) {
        store_compressed(mask, lanes, pairs.corner[corner] + pairs.count);
      };
      const auto of = [&](const CornerBlock& block, One owner, int corner) {
        return owner == one ? IntLanes(block.vertex[corner][lane])
                            : IntLanes::load_aligned(block.vertex[corner] + first);
      };
      const auto my = [&](int corner) { return of(mine_, One::mine, corner); };
      const auto their = [&](int corner) { return of(theirs, One::theirs, corner); };
      if constexpr (kIsSelf) {
        // The edge with the smaller first vertex comes first. So the answer does not depend on the order in the tree.
        // Edges without a common vertex differ in their first.
        const auto is_first = my(0) < their(0);
        for (int c = 0; c < 2; ++c) {
          put(c, select(is_first, my(c), their(c)));
          put(2 + c, select(is_first, their(c), my(c)));
        }
      } else {
        put(0, my(0));
        for (int c = 0; c < kCornersOfTheirs; ++c) put(1 + c, their(c));
        if constexpr (course == Course::along_edge) put(4, my(1));
      }
      FloatLanes(0.0f).store_unaligned(pairs.t_in + pairs.count);
      FloatLanes(t_limit).store_unaligned(pairs.t_out + pairs.count);
      pairs.count += count_bits(mask);
    });
  }

 private:
  static constexpr int kCornersOfMine = kIsSelf || course == Course::along_edge ? 2 : 1;
  static constexpr int kCornersOfTheirs = kIsSelf ? 2 : 3;

  /// The lanes that share a vertex with the one; of empty lanes, anything.
  template <One one>
  auto are_adjacent(int lane, const CornerBlock& theirs, int first) const {
    using Unsigned = xsimd::batch<std::uint32_t, Arch>;
    constexpr int kCornersOfOne = one == One::mine ? kCornersOfMine : kCornersOfTheirs;
    constexpr int kCornersOfSixteen = one == One::mine ? kCornersOfTheirs : kCornersOfMine;
    const auto corners = of_row<one>(mine_, theirs);
    Unsigned differ(~0u);  // 0 where two vertices are equal: cheaper than a mask for each comparison
    for (int c = 0; c < kCornersOfOne; ++c)
      for (int o = 0; o < kCornersOfSixteen; ++o)
        differ =
            xsimd::min(differ, same_bits<std::uint32_t>(IntLanes(corners.one.vertex[c][lane]) ^
                                                        IntLanes::load_aligned(corners.sixteen.vertex[o] + first)));
    return differ == Unsigned(0u);
  }

  Search& search_;
  const int block_;
  const CornerBlock& mine_;
};

}  // namespace tamis::TAMIS_ISA
