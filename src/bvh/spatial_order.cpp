#include "bvh/spatial_order.hpp"

#include <tbb/parallel_invoke.h>

#include <algorithm>

#include "bounds/moving_boxes.hpp"

namespace tamis {
namespace {

/// What all halves share.
struct Halving {
  const Split split;
  const Pause& pause;
  const std::span<const std::size_t> ends;
};

/// Some centers that come one after the other, from place `first` on.
struct CenterRange {
  Centers centers, scratch;
  std::size_t first, count;

  CenterRange part(std::size_t from, std::size_t to) const {
    return {centers.from(from), scratch.from(from), first + from, to - from};
  }
};

/// Only in the group that the cut goes through features change places.
void split_at(const CenterRange& range, std::size_t lower, const Halving& how) {
  const auto end = std::ranges::upper_bound(how.ends, range.first + lower);
  const std::size_t group_begin = end == how.ends.begin() ? 0 : *std::prev(end);
  const std::size_t group_end = end == how.ends.end() ? range.first + range.count : *end;
  const std::size_t from = std::max(group_begin, range.first) - range.first;
  const std::size_t to = std::min(group_end, range.first + range.count) - range.first;
  if (from == lower) return;
  const CenterRange group = range.part(from, to);
  how.split(group.centers, group.scratch, group.count, lower - from);
}

/// In whole blocks of the largest level that has several, so that every block of every level of the tree is one box of
/// space.
void halve(const CenterRange& range, const Halving& how) {
  constexpr std::size_t kParallelFrom = 8192;
  const std::size_t count = range.count;
  if (count <= kBlock) return;
  std::size_t unit = kBlock;
  while (unit * kBlock < count) unit *= kBlock;
  const std::size_t blocks = (count + unit - 1) / unit, lower = (blocks + 1) / 2 * unit;
  split_at(range, lower, how);
  const auto below = [&] { halve(range.part(0, lower), how); };
  const auto above = [&] { halve(range.part(lower, count), how); };
  if (count >= kParallelFrom) {
    how.pause();
    tbb::parallel_invoke(below, above);
  } else {
    below();
    above();
  }
}

}  // namespace

CenterStore::CenterStore(std::size_t count, int axes)
    : at_(static_cast<std::size_t>(axes), std::vector<float>(count)), features_(count) {}

Centers CenterStore::view() {
  Centers all{{}, features_.data(), static_cast<int>(at_.size())};
  for (std::size_t axis = 0; axis < at_.size(); ++axis) all.at[axis] = at_[axis].data();
  return all;
}

void order_in_space(const Centers& centers, std::size_t count, Split split, const Pause& pause,
                    std::span<const std::size_t> ends) {
  CenterStore scratch(count, centers.axes);
  halve({centers, scratch.view(), 0, count}, {split, pause, ends});
}

}  // namespace tamis
