#include "bvh/spatial_order.hpp"

#include <tbb/parallel_invoke.h>

#include "bounds/moving_boxes.hpp"

namespace tamis {
namespace {

/// In whole blocks of the largest level that has several, so that every block of every level of the tree is one box of
/// space.
void halve(const Centers& centers, const Centers& scratch, std::size_t count, Split split, const Pause& pause) {
  constexpr std::size_t kParallelFrom = 8192;
  if (count <= kBlock) return;
  std::size_t unit = kBlock;
  while (unit * kBlock < count) unit *= kBlock;
  const std::size_t blocks = (count + unit - 1) / unit, lower = (blocks + 1) / 2 * unit;
  split(centers, scratch, count, lower);
  const auto below = [&] { halve(centers, scratch, lower, split, pause); };
  const auto above = [&] { halve(centers.from(lower), scratch.from(lower), count - lower, split, pause); };
  if (count >= kParallelFrom) {
    pause();
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

void order_in_space(const Centers& centers, std::size_t count, Split split, const Pause& pause) {
  CenterStore scratch(count, centers.axes);
  halve(centers, scratch.view(), count, split, pause);
}

}  // namespace tamis
