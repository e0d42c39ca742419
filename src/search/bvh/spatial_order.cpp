#include "search/bvh/spatial_order.hpp"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "numbers/floating_point_state.hpp"
#include "search/bounds/moving_boxes.hpp"

namespace tamis {
namespace {

/// Shared by all ranges.
struct Halving {
  const Split split;
  const Pause& pause;
  const std::span<const std::size_t> ends;
  Index* const order;  ///< the result
};

/// A range of the centers, from place `first` on.
struct CenterRange {
  Centers centers, scratch;
  std::size_t first, count;
  ExtentBounds extents;

  CenterRange part(std::size_t from, std::size_t to) const {
    return {centers.from(from), scratch.from(from), first + from, to - from, extents};
  }
};

struct Halves {
  CenterRange low, high;
};

void copy(const Centers& from, const Centers& to, std::size_t count) {
  for (int axis = 0; axis < from.axes; ++axis) std::copy_n(from.at[axis], count, to.at[axis]);
  std::copy_n(from.feature, count, to.feature);
}

/// Features change places only within the group that the cut goes through.
Halves split_at(const CenterRange& range, std::size_t lower, const Halving& how) {
  const auto end = std::ranges::upper_bound(how.ends, range.first + lower);
  const std::size_t group_begin = end == how.ends.begin() ? 0 : *std::prev(end);
  const std::size_t group_end = end == how.ends.end() ? range.first + range.count : *end;
  const std::size_t from = std::max(group_begin, range.first) - range.first;
  const std::size_t to = std::min(group_end, range.first + range.count) - range.first;
  Halves halves{range.part(0, lower), range.part(lower, range.count)};
  if (from == lower) return halves;
  const CenterRange group = range.part(from, to);
  const HalvesExtents extents = how.split(group.centers, group.scratch, group.count, lower - from, group.extents);
  if (group.count == range.count) {
    halves.low.extents = extents.low;
    halves.high.extents = extents.high;
  }
  const CenterRange behind = range.part(to, range.count);
  copy(behind.centers, behind.scratch, behind.count);
  std::swap(halves.high.centers, halves.high.scratch);
  return halves;
}

/// Cuts between blocks of the largest level of which the range has several, so that such cuts make every block of every
/// level of the tree.
void halve(const CenterRange& range, const Halving& how) {
  constexpr std::size_t kParallelFrom = 8192;
  const std::size_t count = range.count;
  if (count <= kBlock) {
    Index* const order = how.order + range.first;
    if (range.centers.feature != order) std::copy_n(range.centers.feature, count, order);
    return;
  }
  std::size_t unit = kBlock;
  while (unit * kBlock < count) unit *= kBlock;
  const std::size_t blocks = (count + unit - 1) / unit, lower = (blocks + 1) / 2 * unit;
  const Halves halves = split_at(range, lower, how);
  const auto below = [&] { halve(halves.low, how); };
  const auto above = [&] { halve(halves.high, how); };
  if (count >= kParallelFrom) {
    how.pause();
    tbb::parallel_invoke(as_task(below), as_task(above));
  } else {
    below();
    above();
  }
}

}  // namespace

CenterStore::CenterStore(std::size_t count, int axes)
    : axes_(axes), at_(static_cast<std::size_t>(axes) * count), features_(count) {}

Centers CenterStore::view() {
  Centers all{{}, features_.data(), axes_};
  for (int axis = 0; axis < axes_; ++axis)
    all.at[axis] = at_.data() + static_cast<std::size_t>(axis) * features_.size();
  return all;
}

void order_in_space(const Centers& centers, std::size_t count, Split split, const Pause& pause,
                    std::span<const std::size_t> ends) {
  CenterStore scratch(count, centers.axes);
  ExtentBounds unknown;
  std::ranges::fill(unknown.along, std::numeric_limits<float>::infinity());
  halve({centers, scratch.view(), 0, count, unknown}, {split, pause, ends, centers.feature});
}

}  // namespace tamis
