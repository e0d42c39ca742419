#include "engines/tamis/near_list.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace tamis {
namespace {

/// Gaps are worth measuring up to so many times what has just moved: then they serve as many questions.
constexpr float kAhead = 8;
/// And up to this part of the reach, where hardly anything has moved.
constexpr float kLeast = 1.0f / 32;

/// Calls f(leaf block, gap, room) for the leaf blocks of `tree` whose hulls at t=0 are within `reach` of one hull, as
/// Kernels::near_hulls has it: a node's gap is no larger than its children's, its room no smaller.
template <class F>
void for_each_near(const Kernels& kernels, const TreeView& tree, int level, int node, const BoxBlock& of, int lane,
                   float reach, const F& f) {
  HullGaps found;
  unsigned near = kernels.near_hulls(tree.levels[level][node], of, lane, reach, found);
  for (; near; near &= near - 1) {
    const int i = __builtin_ctz(near);
    if (level == 1)
      f(node * kBlock + i, found.gap[i], found.room[i]);
    else
      for_each_near(kernels, tree, level - 1, node * kBlock + i, of, lane, reach, f);
  }
}

}  // namespace

void NearList::clear() {
  first_.clear();
  others_.clear();
  gaps_.clear();
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
  for (Row& row : rows) {
    first_.push_back(others_.size());
    std::sort(row.begin(), row.end(), [](const Entry& a, const Entry& b) { return a.gap < b.gap; });
    for (const Entry& entry : row) {
      others_.push_back(entry.other);
      gaps_.push_back(entry.gap);
    }
  }
  first_.push_back(others_.size());
  others_.resize(others_.size() + kBlock);
  gaps_.resize(others_.size());
}

void NearList::measure(const Making& making, int block, PairBuffer& scratch, Row& row) {
  const TreeView &a = making.question.a, &b = making.question.b;
  if (b.leaf_blocks == 0) return;
  const bool is_self = making.kind == PairKind::edge_edge;
  const auto gap_of_blocks = is_self ? making.kernels.gap_ee : making.kernels.gap_vf;
  const BoxBlock& hulls = a.levels[1][block / kBlock];
  const int lane = block % kBlock;
  const MovingBox& drifts = making.drifts_a.boxes()[static_cast<std::size_t>(block)];
  for_each_near(
      making.kernels, b, b.level_count - 1, 0, hulls, lane, making.reach, [&](int other, float gap, float room) {
        if ((is_self && other < block) || are_kept_apart(a, block, b, 0, other)) return;
        const float moved =
            RelativeDrift(drifts, making.drifts_b.boxes()[static_cast<std::size_t>(other)]).until(making.until);
        const float ahead = std::max(kAhead * moved, kLeast * making.reach);
        const float most = std::min(making.reach, ahead + making.separation + room);
        // Boxes have half the separation on each side already, features have not.
        const float by_hulls = gap - room;
        const float by_features = gap < most ? gap_of_blocks(making.question, block, other, most, scratch) : 0;
        row.push_back({other, std::max({0.0f, by_hulls, std::min(by_features, most - room) - making.separation})});
      });
}

void NearList::append_unproven(const Kernels& kernels, int block, float from, float to, GapScan scan,
                               std::vector<std::int32_t>& others) const {
  const auto row = first_.begin() + block;
  const float *begin = gaps_.data() + row[0], *end = gaps_.data() + row[1];
  if (from >= to || begin == end || *begin >= to) return;
  scan.gaps = std::lower_bound(begin, end, from);
  scan.count = static_cast<int>(std::lower_bound(scan.gaps, end, to) - scan.gaps);
  if (scan.count == 0) return;
  scan.others = others_.data() + (scan.gaps - gaps_.data());
  const std::size_t before = others.size();
  others.resize(before + static_cast<std::size_t>(scan.count) + kBlock);
  others.resize(before + static_cast<std::size_t>(kernels.unproven(scan, others.data() + before)));
}

}  // namespace tamis
