// From a leaf block of one tree down the other tree to pairs of features. Stage by stage over small lists, without
// branches on what boxes meet, which nothing could predict: leaf blocks, features against leaf blocks, features.
#pragma once
#include <utility>

#include "kernels/reach.hpp"
#include "kernels/row_pairs.hpp"

namespace tamis::TAMIS_ISA {

/// The bits of sixteen from `first` on.
inline unsigned from_bit(int first) { return first >= kBlock ? 0 : ~0u << std::max(first, 0); }

/// `Boxes`: MovingBoxes, StillBoxes, RestBoxes, NearBoxes or ClearanceBoxes.
template <PairKind kind, class Boxes, Course course = Course::step>
class BlockSearch {
 public:
  BlockSearch(Search& search, int block)
      : search_(search), block_(block), row_pairs_(search, block), boxes_(search, block) {
    Bounds hulls;
    boxes_.bound(search.a, 1, block / kBlock, hulls);
    for (int k = 0; k < Bounds::kCount; ++k) my_hull_[k] = hulls.at[k][block % kBlock];
    boxes_.bound(search.a, 0, block, mine_);
    if constexpr (Boxes::kMoves) means_ = boxes_.means(search.a.levels[0][block], mine_);
    if constexpr (Boxes::kHasReach) expect_short_reaches();
  }

  void run() {
    if (search_.b.leaf_blocks == 0) return;
    visit(search_.b.level_count - 1, 0);
    match_leaves();
  }

 private:
  using Bounds = typename Boxes::Bounds;
  static constexpr bool kIsSelf = RowPairs<kind, course>::kIsSelf;
  static constexpr int kMostLeaves = 32, kAhead = 4;
  /// Rows of a block that are looked at first, and the part of them above which the cheap test leaves too many to be
  /// asked at all (docs/history/performance.md, "What chooses").
  static constexpr int kSample = 16;
  static constexpr double kMostMet = 0.65;
  /// Part of a leaf block's extent up to which hardly any features but neighbours are within reach of each other, and
  /// how many in a row cost less later than being asked again (docs/history/performance.md, "Reach by blocks").
  static constexpr float kShortReach = 0x1p-4f;
  static constexpr int kFew = 2;

  void visit(int level, int node) {
    ++search_.nodes_visited;
    Bounds hulls;
    boxes_.bound(search_.b, level, node, hulls);
    unsigned mask = children_that_meet(level, node, hulls), fast = 0;
    if constexpr (Boxes::kMoves) fast = mask & boxes_.move_far(search_.b.levels[level][node], hulls, means_);
    if (fast) mask &= ~fast | sharply(level, node);
    if (level > 1) return for_each_bit(mask, [&](int child) { visit(level - 1, node * kBlock + child); });
    if (has_short_reaches()) find_reaches(node, hulls);
    for_each_bit(mask, [&](int child) { append_leaf(node * kBlock + child, hulls, child, fast >> child & 1); });
    if (leaf_count_ > kMostLeaves - kBlock) match_leaves();
  }

  /// Unless none of my features may meet its hull, which is lane `lane` of `hulls`.
  void append_leaf(int leaf, const Bounds& hulls, int lane, bool is_fast) {
    leaves_[leaf_count_] = leaf;
    is_fast_[leaf_count_] = is_fast;
    if (has_short_reaches()) reach_[leaf_count_] = reaches_[lane];
    rows_of_[leaf_count_] = rows_that_meet(leaf_count_, hulls, lane);
    leaf_count_ += rows_of_[leaf_count_] != 0;
  }

  /// Reaches are looked for where some can be short: that between two blocks is at least half of that within mine, as
  /// any residual is at least half of mine's range away from one of its ends.
  void expect_short_reaches() {
    const auto mine = [&](int k) { return FloatLanes(my_hull_[k]); };
    extent_ = extent(search_, block_);
    has_short_reaches_ = boxes_.reach(mine, mine).get(0) <= 2 * kShortReach * extent_;
  }
  bool has_short_reaches() const {
    if constexpr (Boxes::kHasReach) return has_short_reaches_;
    return false;
  }

  /// Of the leaf blocks of a node: how far apart their features and mine can be that are of interest; -1 where that is
  /// far.
  void find_reaches(int node, const Bounds& hulls) {
    if constexpr (Boxes::kHasReach)
      for_sixteen_lanes([&](int first) {
        const FloatLanes reach =
            boxes_.reach([&](int k) { return FloatLanes(my_hull_[k]); }, [&](int k) { return hulls.lanes(k, first); });
        const FloatLanes least = min(FloatLanes(extent_), extent_at_start(search_.b.levels[1][node], first));
        select(reach <= FloatLanes(kShortReach) * least, reach, FloatLanes(-1.0f)).store_aligned(reaches_ + first);
      });
  }

  unsigned children_that_meet(int level, int node, const Bounds& hulls) const {
    unsigned mask = meet([&](int k, int) { return FloatLanes(my_hull_[k]); },
                         [&](int k, int first) { return hulls.lanes(k, first); });
    // In the same tree only blocks from this one on: child c covers leaf blocks below (c + 1) 16^(level-1).
    if (kIsSelf) mask &= from_bit((block_ >> (4 * (level - 1))) - node * kBlock);
    return search_.a.groups.may_touch ? without_kept_apart(mask, level, node) : mask;
  }

  unsigned sharply(int level, int node) const {
    if constexpr (Boxes::kMoves)
      return boxes_.meet_at_some_time(search_.a.levels[1][block_ / kBlock], block_ % kBlock,
                                      search_.b.levels[level][node]);
    return ~0u;
  }

  /// Bits of sixteen lanes whose boxes may meet. `a(k, first)`, `b(k, first)`: bound k of those from lane `first` on.
  template <class A, class B>
  [[gnu::always_inline]] unsigned meet(const A& a, const B& b) const {
    unsigned mask = 0;
    for_sixteen_lanes([&](int first) {
      mask |= bits(boxes_.meet([&](int k) { return a(k, first); }, [&](int k) { return b(k, first); })) << first;
    });
    return mask;
  }

  /// Of the bits of a node's children, those that may touch by their groups.
  unsigned without_kept_apart(unsigned mask, int level, int node) const {
    unsigned rest = mask;
    for_each_bit(mask, [&](int child) {
      if (are_kept_apart(search_.a, block_, search_.b, level - 1, node * kBlock + child)) rest &= ~(1u << child);
    });
    return rest;
  }

  void match_leaves() {
    for (int i = 0; i < kAhead && i < leaf_count_; ++i) fetch(leaves_[i]);
    for (int i = 0; i < leaf_count_; ++i) {
      if (i + kAhead < leaf_count_) fetch(leaves_[i + kAhead]);
      is_bounded_[i] = false;
      if (!has_short_reach(i)) bound(i);
      if constexpr (Boxes::kMoves) asks_theirs_[i] = is_fast_[i] && ask_theirs(i);
    }
    if (has_short_reaches())
      match_rows<One::mine>([&](int i) { return has_short_reach(i); },
                            [&](int count) { return keep_near_rows(count); });
    match_rows<One::mine>([&](int i) { return !is_fast_[i] && !has_short_reach(i); },
                          [&](int count) {
                            return keep_rows(0, count, 0, [&](int i) { return others_that_meet<One::mine>(rows_[i]); });
                          });
    if constexpr (Boxes::kMoves) {
      match_rows<One::mine>([&](int i) { return is_fast_[i] && !asks_theirs_[i]; },
                            [&](int count) { return keep_fast_rows<One::mine>(count); });
      match_rows<One::theirs>([&](int i) { return asks_theirs_[i]; },
                              [&](int count) { return keep_fast_rows<One::theirs>(count); });
    }
    leaf_count_ = 0;
  }

  void bound(int i) {
    if (std::exchange(is_bounded_[i], true)) return;
    boxes_.bound(search_.b, 0, leaves_[i], theirs_[i]);
  }

  /// Takes their features that may meet my hull as the rows of a leaf, if these are fewer than mine. Returns whether.
  bool ask_theirs(int i) {
    if (kIsSelf && leaves_[i] == block_) return false;
    const unsigned theirs = boxes_.meet_at_some_time(search_.a.levels[1][block_ / kBlock], block_ % kBlock,
                                                     search_.b.levels[0][leaves_[i]]);
    const bool are_fewer = __builtin_popcount(theirs) < __builtin_popcount(rows_of_[i]);
    if (are_fewer) rows_of_[i] = theirs;
    return are_fewer;
  }

  /// Appends the pairs of the rows of some leaves. `keep(count)`, of that many rows, leaves those with pairs.
  template <One one, class IsOne, class Keep>
  void match_rows(const IsOne& is_one, const Keep& keep) {
    int count = 0;
    for (int i = 0; i < leaf_count_; ++i) append_bits(is_one(i) ? rows_of_[i] : 0, kBlock * i, rows_, count);
    const int found = keep(count);
    for (int i = 0; i < found; ++i)
      row_pairs_.template append<one>(leaf_of(rows_[i]), lane_of(rows_[i]), found_[i], boxes_.t_limit());
  }

  /// Of the first `count` rows, those of features that may meet, with the bits of these; their number.
  template <One one>
  int keep_fast_rows(int count) {
    const auto cheap = [&](int i) { return others_that_meet<one>(rows_[i]); };
    const auto both = [&](int i) { return found_[i] & others_that_meet_at_some_time<one>(rows_[i]); };
    // The block's first rows tell whether the cheap test leaves so much that the sharp one is better asked at once.
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

  /// The same where hardly any but neighbours are within reach of each other.
  int keep_near_rows(int count) {
    const int near = keep_rows(0, count, 0, [&](int i) { return others_within_reach(rows_[i]); });
    return keep_rows(0, near, 0, [&](int i) {
      if (__builtin_popcount(found_[i]) <= kFew) return found_[i];
      bound(static_cast<int>(place_of(rows_[i])));
      return found_[i] & others_that_meet<One::mine>(rows_[i]);
    });
  }

  /// Of the rows first to last those where bits(i) has some, from place `to` on. Returns the place behind them.
  template <class Bits>
  int keep_rows(int first, int last, int to, const Bits& bits) {
    for (int i = first; i < last; ++i) {
      found_[to] = bits(i);
      rows_[to] = rows_[i];
      to += found_[to] != 0;
    }
    return to;
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

  /// Bits of my features that may meet some of leaf i, whose hull is in that lane.
  unsigned rows_that_meet(int i, const Bounds& hulls, int lane) const {
    const BoxBlock &theirs = search_.b.levels[1][leaves_[i] / kBlock], &mine = search_.a.levels[0][block_];
    if constexpr (Boxes::kMoves)
      if (is_fast_[i]) return boxes_.meet_at_some_time(theirs, lane, mine);
    if (has_short_reach(i)) return within_reach(theirs, lane, mine, reach_[i]);
    return meet([&](int k, int first) { return mine_.lanes(k, first); },
                [&](int k, int) { return FloatLanes(hulls.at[k][lane]); });
  }

  /// Of a row, place in leaves_ and lane of the one: without a sign, which takes more operations.
  static unsigned place_of(std::int32_t row) { return static_cast<unsigned>(row) / kBlock; }
  int leaf_of(std::int32_t row) const { return leaves_[place_of(row)]; }
  static int lane_of(std::int32_t row) { return static_cast<int>(static_cast<unsigned>(row) % kBlock); }

  /// Of a leaf: is how near the boxes are at t=0 all that need be asked of its features?
  bool has_short_reach(int i) const { return has_short_reaches() && reach_[i] >= 0; }

  /// Bits of theirs that are within reach of mine and no neighbours.
  unsigned others_within_reach(int row) const {
    return within_reach(search_.a.levels[0][block_], lane_of(row), search_.b.levels[0][leaf_of(row)],
                        reach_[place_of(row)]) &
           ~neighbours<One::mine>(row);
  }

  /// Bits of the sixteen that may meet the one and are no neighbours.
  template <One one>
  unsigned others_that_meet(int row) const {
    const int lane = lane_of(row);
    const auto bounds = of_row<one>(mine_, theirs_[place_of(row)]);
    return meet([&](int k, int) { return FloatLanes(bounds.one.at[k][lane]); },
                [&](int k, int first) { return bounds.sixteen.lanes(k, first); }) &
           ~neighbours<one>(row);
  }

  template <One one>
  unsigned neighbours(int row) const {
    return row_pairs_.template neighbours<one>(leaf_of(row), lane_of(row));
  }

  template <One one>
  unsigned others_that_meet_at_some_time(int row) const {
    const auto boxes = of_row<one>(search_.a.levels[0][block_], search_.b.levels[0][leaf_of(row)]);
    return boxes_.meet_at_some_time(boxes.one, lane_of(row), boxes.sixteen);
  }

  Search& search_;
  const int block_;
  const RowPairs<kind, course> row_pairs_;
  const Boxes boxes_;
  float my_hull_[Bounds::kCount];
  Bounds mine_;
  int leaf_count_ = 0;
  alignas(64) std::int32_t leaves_[kMostLeaves + kBlock];
  unsigned rows_of_[kMostLeaves + kBlock];
  bool is_bounded_[kMostLeaves + kBlock], is_fast_[kMostLeaves + kBlock], asks_theirs_[kMostLeaves + kBlock];
  MovingBoxes::Means means_;
  bool has_short_reaches_ = false;
  float extent_ = 0;
  alignas(64) float reaches_[kBlock];  ///< of the leaf blocks of a node
  float reach_[kMostLeaves + kBlock];
  int sampled_ = 0, met_ = 0;  ///< fast rows that were asked the cheap way first, and those that it left
  Bounds theirs_[kMostLeaves];
  std::int32_t rows_[kMostLeaves * kBlock + kBlock];
  unsigned found_[kMostLeaves * kBlock];
};

}  // namespace tamis::TAMIS_ISA
