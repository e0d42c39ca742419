#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>

#include "bvh/block_tree.hpp"

namespace tamis {
namespace {

struct Center {
  std::array<float, 3> at;
  Index feature;
};

std::size_t longest_axis(std::span<const Center> centers) {
  std::array<float, 3> low = centers[0].at, high = centers[0].at;
  for (const Center& c : centers)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], c.at[axis]);
      high[axis] = std::max(high[axis], c.at[axis]);
    }
  const std::array<float, 3> size{high[0] - low[0], high[1] - low[1], high[2] - low[2]};
  return static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
}

template <std::size_t axis>
void put_lower_first(std::span<Center> centers, std::size_t count) {
  std::nth_element(centers.begin(), centers.begin() + static_cast<std::ptrdiff_t>(count), centers.end(),
                   [](const Center& a, const Center& b) { return a.at[axis] < b.at[axis]; });
}

/// Halves along the longest axis, in whole blocks of the largest level that has several, so that every block of every
/// level of the tree is one box of space.
void sort_in_space(std::span<Center> centers) {
  constexpr std::size_t kParallelFrom = 8192;
  if (centers.size() <= kBlock) return;
  std::size_t unit = kBlock;
  while (unit * kBlock < centers.size()) unit *= kBlock;
  const std::size_t blocks = (centers.size() + unit - 1) / unit, lower = (blocks + 1) / 2 * unit;
  switch (longest_axis(centers)) {
    case 0:
      put_lower_first<0>(centers, lower);
      break;
    case 1:
      put_lower_first<1>(centers, lower);
      break;
    default:
      put_lower_first<2>(centers, lower);
  }
  const auto below = centers.first(lower), above = centers.subspan(lower);
  if (centers.size() >= kParallelFrom) {
    tbb::parallel_invoke([=] { sort_in_space(below); }, [=] { sort_in_space(above); });
  } else {
    sort_in_space(below);
    sort_in_space(above);
  }
}

}  // namespace

std::vector<Index> spatial_order(std::span<const std::array<float, 3>> centers) {
  std::vector<Center> items(centers.size());
  for (std::size_t i = 0; i < centers.size(); ++i) items[i] = {centers[i], static_cast<Index>(i)};
  sort_in_space(items);
  std::vector<Index> order(centers.size());
  for (std::size_t i = 0; i < items.size(); ++i) order[i] = items[i].feature;
  return order;
}

}  // namespace tamis
