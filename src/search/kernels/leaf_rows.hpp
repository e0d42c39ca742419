// Tests the features of one leaf block against the features of the leaf blocks that it may meet. A row is one feature
// against the sixteen of another block. Rows without pairs are removed stage by stage, without branches on which boxes
// meet. No processor could predict such branches.
#pragma once
#include <bit>
#include <utility>

#include "numbers/platform.hpp"
#include "search/kernels/reach.hpp"
#include "search/kernels/row_pairs.hpp"

namespace tamis::TAMIS_ISA {

/// How the features of two leaf blocks are tested against each other.
enum class Test {
  boxes,                ///< their boxes meet by the search's cheap test
  some_time,            ///< they meet at one time; each of my features against sixteen of theirs
  some_time_of_theirs,  ///< the same, each of their features against sixteen of mine
  reach,                ///< they are within reach of each other at t=0
};

/// A leaf block of search.b that mine may meet.
struct MetLeaf {
  int block;
  Test test;
  float reach;    ///< Test::reach: how far apart along each axis features of interest can be at t=0
  unsigned rows;  ///< bits of the features that have a row
};

/// Bits of sixteen lanes whose boxes may meet. `a(k, first)`, `b(k, first)`: bound k of the boxes from lane `first` on.
template <class Boxes, class A, class B>
TAMIS_ALWAYS_INLINE unsigned lanes_that_meet(const Boxes& boxes, const A& a, const B& b) {
  return bits_of_sixteen(
      [&](int first) { return boxes.meet([&](int k) { return a(k, first); }, [&](int k) { return b(k, first); }); });
}

/// The rows of one leaf block of search.a. `Boxes`: as in BlockSearch.
template <PairKind kind, class Boxes, Course course>
class LeafRows {
 public:
  using Bounds = typename Boxes::Bounds;

  LeafRows(Search& search, int block, const Boxes& boxes)
      : search_(search), block_(block), boxes_(boxes), row_pairs_(search, block) {
    boxes_.bound(search.a, 0, block, mine_);
  }

  /// Bounds of my features.
  const Bounds& bounds() const { return mine_; }

  /// Adds the rows of my features that may meet the hull of `leaf`, which is lane `lane` of `hulls`; `leaf.rows` is set
  /// here.
  void append(MetLeaf leaf, const Bounds& hulls, int lane) {
    leaf.rows = rows_that_meet(leaf, hulls, lane);
    leaves_[leaf_count_] = leaf;
    leaf_count_ += leaf.rows != 0;
  }

  /// True if there is no space for the leaves of another node.
  bool is_full() const { return leaf_count_ > kMostLeaves - kBlock; }

  /// Finds the pairs of all leaves that were appended, and empties the list of leaves.
  void match() {
    for (int i = 0; i < kAhead && i < leaf_count_; ++i) fetch(leaves_[i].block);
    for (int i = 0; i < leaf_count_; ++i) {
      if (i + kAhead < leaf_count_) fetch(leaves_[i + kAhead].block);
      is_bounded_[i] = false;
      if (!Boxes::kHasReach || leaves_[i].test != Test::reach) bound(i);
      if constexpr (Boxes::kMoves) ask_fewer(leaves_[i]);
    }
    if constexpr (Boxes::kHasReach)
      match_rows<One::mine>(Test::reach, [&](int count) { return keep_near_rows(count); });
    match_rows<One::mine>(Test::boxes, [&](int count) {
      return keep_rows(0, count, 0, [&](int i) { return others_that_meet<One::mine>(rows_[i]); });
    });
    if constexpr (Boxes::kMoves) {
      match_rows<One::mine>(Test::some_time, [&](int count) { return keep_fast_rows<One::mine>(count); });
      match_rows<One::theirs>(Test::some_time_of_theirs, [&](int count) { return keep_fast_rows<One::theirs>(count); });
    }
    leaf_count_ = 0;
  }

 private:
  static constexpr int kMostLeaves = 32, kAhead = 4;
  /// The first kSample rows of a block get the cheap test. If more than the part kMostMet of them remain, the other
  /// rows get the sharp test at once: contacts of kick 62-65 take 17 ms instead of 500.
  static constexpr int kSample = 16;
  static constexpr double kMostMet = 0.65;
  /// A row with at most this many features within reach is not tested again. Later stages take less time:
  /// if such rows are always tested again, cloth gains 3% by the cheap test, not 25%.
  static constexpr int kFew = 2;

  unsigned rows_that_meet(const MetLeaf& leaf, const Bounds& hulls, int lane) const {
    const BoxBlock &theirs = search_.b.levels[1][leaf.block / kBlock], &mine = search_.a.levels[0][block_];
    if constexpr (Boxes::kMoves)
      if (leaf.test == Test::some_time) return boxes_.meet_at_some_time(theirs, lane, mine);
    if constexpr (Boxes::kHasReach)
      if (leaf.test == Test::reach) return within_reach(theirs, lane, mine, leaf.reach);
    return lanes_that_meet(
        boxes_, [&](int k, int first) { return mine_.lanes(k, first); },
        [&](int k, int) { return FloatLanes(hulls.at[k][lane]); });
  }

  /// Prefetches boxes and corners while other blocks are tested.
  void fetch(int block) const {
    const auto fetch_all = [](const auto& of_block) {
      for (std::size_t byte = 0; byte < sizeof(of_block); byte += 64)
        prefetch(reinterpret_cast<const char*>(&of_block) + byte);
    };
    fetch_all(search_.b.levels[0][block]);
    fetch_all(search_.b.corners[block]);
  }

  void bound(int i) {
    if (std::exchange(is_bounded_[i], true)) return;
    boxes_.bound(search_.b, 0, leaves_[i].block, theirs_[i]);
  }

  /// For a leaf whose features move far. Turns the rows around, to its features that may meet my hull, if that gives
  /// fewer rows.
  void ask_fewer(MetLeaf& leaf) const {
    if (leaf.test != Test::some_time || (RowPairs<kind, course>::kIsSelf && leaf.block == block_)) return;
    const unsigned theirs = boxes_.meet_at_some_time(search_.a.levels[1][block_ / kBlock], block_ % kBlock,
                                                     search_.b.levels[0][leaf.block]);
    if (std::popcount(theirs) >= std::popcount(leaf.rows)) return;
    leaf.rows = theirs;
    leaf.test = Test::some_time_of_theirs;
  }

  /// Finds the pairs of the leaves with this test. `keep(count)` reduces the first `count` rows to those with pairs,
  /// and returns their number.
  template <One one, class Keep>
  void match_rows(Test test, const Keep& keep) {
    int count = 0;
    for (int i = 0; i < leaf_count_; ++i)
      append_bits(leaves_[i].test == test ? leaves_[i].rows : 0, kBlock * i, rows_, count);
    const int found = keep(count);
    for (int i = 0; i < found; ++i)
      row_pairs_.template append<one>(leaf_of(rows_[i]).block, lane_of(rows_[i]), found_[i], boxes_.t_limit());
  }

  /// Keeps, of the first `count` rows, the rows with features that meet at one time. Returns their number.
  template <One one>
  int keep_fast_rows(int count) {
    const auto cheap = [&](int i) { return others_that_meet<one>(rows_[i]); };
    const auto both = [&](int i) { return found_[i] & others_that_meet_at_some_time<one>(rows_[i]); };
    // The block's first rows tell whether the cheap test is worth its time.
    const int sample = std::min(count, kSample - sampled_), met = keep_rows(0, sample, 0, cheap);
    sampled_ += sample;
    met_ += met;
    const int found = keep_rows(0, met, 0, both);
    if (met_ > kMostMet * sampled_)
      return keep_rows(sample, count, found, [&](int i) {
        return others_that_meet_at_some_time<one>(rows_[i]) & ~neighbours<one>(rows_[i]);
      });
    return keep_rows(found, keep_rows(sample, count, found, cheap), found, both);
  }

  /// Keeps, of the first `count` rows, the rows with features within reach. Returns their number.
  int keep_near_rows(int count) {
    const int near = keep_rows(0, count, 0, [&](int i) { return others_within_reach(rows_[i]); });
    return keep_rows(0, near, 0, [&](int i) {
      if (std::popcount(found_[i]) <= kFew) return found_[i];
      bound(static_cast<int>(place_of(rows_[i])));
      return found_[i] & others_that_meet<One::mine>(rows_[i]);
    });
  }

  /// Of the rows first to last, moves those for which bits(i) is not zero to place `to` and on, with their bits.
  /// Returns the place behind them.
  template <class Bits>
  int keep_rows(int first, int last, int to, const Bits& bits) {
    for (int i = first; i < last; ++i) {
      found_[to] = bits(i);
      rows_[to] = rows_[i];
      to += found_[to] != 0;
    }
    return to;
  }

  /// A row's place in leaves_, and the lane of its one feature. Unsigned arithmetic takes fewer operations.
  static unsigned place_of(std::int32_t row) { return static_cast<unsigned>(row) / kBlock; }
  const MetLeaf& leaf_of(std::int32_t row) const { return leaves_[place_of(row)]; }
  static int lane_of(std::int32_t row) { return static_cast<int>(static_cast<unsigned>(row) % kBlock); }

  /// Bits of the sixteen of a row that are within reach of its one feature and are not its neighbours.
  unsigned others_within_reach(int row) const {
    const MetLeaf& leaf = leaf_of(row);
    return within_reach(search_.a.levels[0][block_], lane_of(row), search_.b.levels[0][leaf.block], leaf.reach) &
           ~neighbours<One::mine>(row);
  }

  /// Bits of the sixteen that may meet the one feature by the cheap test and are not its neighbours.
  template <One one>
  unsigned others_that_meet(int row) const {
    const int lane = lane_of(row);
    const auto bounds = of_row<one>(mine_, theirs_[place_of(row)]);
    return lanes_that_meet(
               boxes_, [&](int k, int) { return FloatLanes(bounds.one.at[k][lane]); },
               [&](int k, int first) { return bounds.sixteen.lanes(k, first); }) &
           ~neighbours<one>(row);
  }

  template <One one>
  unsigned neighbours(int row) const {
    return row_pairs_.template neighbours<one>(leaf_of(row).block, lane_of(row));
  }

  /// Bits of the sixteen that may meet the one feature at one time, neighbours included.
  template <One one>
  unsigned others_that_meet_at_some_time(int row) const {
    const auto boxes = of_row<one>(search_.a.levels[0][block_], search_.b.levels[0][leaf_of(row).block]);
    return boxes_.meet_at_some_time(boxes.one, lane_of(row), boxes.sixteen);
  }

  Search& search_;
  const int block_;
  const Boxes boxes_;
  const RowPairs<kind, course> row_pairs_;
  Bounds mine_;
  int leaf_count_ = 0;
  MetLeaf leaves_[kMostLeaves + 1];
  bool is_bounded_[kMostLeaves];
  int sampled_ = 0, met_ = 0;  ///< rows that were sampled with the cheap test, and those that it left
  Bounds theirs_[kMostLeaves];
  std::int32_t rows_[kMostLeaves * kBlock + kBlock];
  unsigned found_[kMostLeaves * kBlock];
};

}  // namespace tamis::TAMIS_ISA
