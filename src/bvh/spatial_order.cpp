#include "bvh/spatial_order.hpp"

#include <tbb/parallel_invoke.h>

#include "bounds/moving_boxes.hpp"

namespace tamis {
namespace {

/// In whole blocks of the largest level that has several, so that every block of every level of the tree is one box of
/// space.
void halve(const Centers& centers, const Centers& scratch, std::size_t count, Split split) {
  constexpr std::size_t kParallelFrom = 8192;
  if (count <= kBlock) return;
  std::size_t unit = kBlock;
  while (unit * kBlock < count) unit *= kBlock;
  const std::size_t blocks = (count + unit - 1) / unit, lower = (blocks + 1) / 2 * unit;
  split(centers, scratch, count, lower);
  const auto below = [&] { halve(centers, scratch, lower, split); };
  const auto above = [&] { halve(centers.from(lower), scratch.from(lower), count - lower, split); };
  if (count >= kParallelFrom) {
    tbb::parallel_invoke(below, above);
  } else {
    below();
    above();
  }
}

}  // namespace

CenterStore::CenterStore(std::size_t count) : features_(count) {
  for (auto& axis : at_) axis.resize(count);
}

Centers CenterStore::view() { return {{at_[0].data(), at_[1].data(), at_[2].data()}, features_.data()}; }

void order_in_space(const Centers& centers, std::size_t count, Split split) {
  CenterStore scratch(count);
  halve(centers, scratch.view(), count, split);
}

}  // namespace tamis
