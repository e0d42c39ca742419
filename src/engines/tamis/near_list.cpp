#include "engines/tamis/near_list.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "numerics/error_bounds.hpp"

namespace tamis {
namespace {

/// Gaps are worth measuring up to so many times what has just moved: then they serve as many questions.
constexpr float kAhead = 8;
/// And up to this part of the reach, where hardly anything has moved.
constexpr float kLeast = 1.0f / 32;

/// The largest difference of two boxes' displacements.
float largest_difference(const float (&low_a)[3][kBlock], const float (&high_a)[3][kBlock], int a,
                         const float (&low_b)[3][kBlock], const float (&high_b)[3][kBlock], int b) {
  float square = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const float way = std::max(high_a[axis][a] - low_b[axis][b], high_b[axis][b] - low_a[axis][a]);
    square += way * way;
  }
  return std::sqrt(square);
}

/// Calls f(leaf block, gap) for the leaf blocks of `tree` whose hulls at t=0 are within `reach` of one hull, by their
/// largest gap along an axis.
template <class F>
void for_each_near(const TreeView& tree, int level, int node, const BoxBlock& of, int lane, float reach, const F& f) {
  const BoxBlock& hulls = tree.levels[level][node];
  float gaps[kBlock] = {};
  for (int axis = 0; axis < 3; ++axis) {
    const float low = of.low0[axis][lane], high = of.high0[axis][lane];
    for (int i = 0; i < kBlock; ++i)
      gaps[i] = std::max(gaps[i], std::max(hulls.low0[axis][i] - high, low - hulls.high0[axis][i]));
  }
  for (int i = 0; i < kBlock; ++i) {
    if (!(gaps[i] < reach)) continue;
    if (level == 1)
      f(node * kBlock + i, gaps[i]);
    else
      for_each_near(tree, level - 1, node * kBlock + i, of, lane, reach, f);
  }
}

/// Of two boxes at t=0, along an axis.
float largest_extent(const BoxBlock& a, int i, const BoxBlock& b, int j) {
  float extent = 0;
  for (int axis = 0; axis < 3; ++axis)
    extent = std::max({extent, a.high0[axis][i] - b.low0[axis][j], b.high0[axis][j] - a.low0[axis][i]});
  return extent;
}

}  // namespace

RelativeDrift::RelativeDrift(const TreeView& a, int block, const TreeView& b, int other) {
  const BoxBlock &of_a = a.drifts[1][block / kBlock], &of_b = b.drifts[1][other / kBlock];
  const int i = block % kBlock, j = other % kBlock;
  at_start = largest_difference(of_a.low0, of_a.high0, i, of_b.low0, of_b.high0, j);
  at_end = largest_difference(of_a.low1, of_a.high1, i, of_b.low1, of_b.high1, j);
}

float RelativeDrift::until(float t) const { return std::max(at_start, at_start + t * (at_end - at_start)); }

void NearList::clear() {
  first_.clear();
  entries_.clear();
}

void NearList::make(const Making& making) {
  const int blocks = making.question.a.leaf_blocks;
  std::vector<Row> rows(static_cast<std::size_t>(blocks));
  tbb::enumerable_thread_specific<std::unique_ptr<PairBuffer>> scratch;
  constexpr int kGrain = 8;
  tbb::parallel_for(tbb::blocked_range<int>(0, blocks, kGrain), [&](const tbb::blocked_range<int>& part) {
    auto& own = scratch.local();
    if (!own) own = std::make_unique<PairBuffer>();
    for (int block = part.begin(); block < part.end(); ++block)
      measure(making, block, *own, rows[static_cast<std::size_t>(block)]);
  });
  clear();
  for (const Row& row : rows) {
    first_.push_back(entries_.size());
    entries_.insert(entries_.end(), row.begin(), row.end());
  }
  first_.push_back(entries_.size());
}

void NearList::measure(const Making& making, int block, PairBuffer& scratch, Row& row) {
  const TreeView &a = making.question.a, &b = making.question.b;
  if (b.leaf_blocks == 0) return;
  const bool is_self = making.kind == PairKind::edge_edge;
  const auto gap_of_blocks = is_self ? making.kernels.gap_ee : making.kernels.gap_vf;
  const BoxBlock& hulls = a.levels[1][block / kBlock];
  const int lane = block % kBlock;
  for_each_near(b, b.level_count - 1, 0, hulls, lane, making.reach, [&](int other, float hull_gap) {
    if (is_self && other < block) return;
    const float moved = RelativeDrift(a, block, b, other).until(making.until);
    // As in kernels/near_boxes.hpp: the three sizes of a pair are together at most three times the largest extent.
    const float extent = largest_extent(hulls, lane, b.levels[1][other / kBlock], other % kBlock);
    const float room = 4 * static_cast<float>(error_bounds::kRoomToAdvance) * extent;
    const float ahead = std::max(kAhead * moved, kLeast * making.reach);
    const float most = std::min(making.reach, ahead + making.separation + room);
    // Boxes have half the separation on each side already, features have not.
    const float by_hulls = hull_gap - room;
    const float by_features = hull_gap < most ? gap_of_blocks(making.question, block, other, most, scratch) : 0;
    row.push_back({other, std::max({0.0f, by_hulls, std::min(by_features, most - room) - making.separation})});
  });
}

void NearList::append_unproven(const TreeView& a, const TreeView& b, int block, float t, float scale,
                               std::vector<std::int32_t>& others) const {
  // What the room of a pair has grown by since: its sizes are larger by at most six times the relative drift.
  constexpr float kGrown = 1 + 8 * static_cast<float>(error_bounds::kRoomToAdvance);
  const auto i = static_cast<std::size_t>(block);
  for (std::size_t at = first_[i]; at < first_[i + 1]; ++at) {
    const Entry& entry = entries_[at];
    if (!(entry.gap * scale > kGrown * RelativeDrift(a, block, b, entry.other).until(t))) others.push_back(entry.other);
  }
}

}  // namespace tamis
