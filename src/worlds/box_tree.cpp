#include "worlds/box_tree.hpp"

namespace tamis {

BoxTree::BoxTree(std::span<const Point> centers) : items_(centers.size()) {
  Box all;
  for (const Point& center : centers) all.include(center);
  // Scaled to [0,1], so centers fit floats whatever the unit of length. Centers beyond that (overflow) become 0,
  // which only makes the order poor.
  double extent = 0;
  for (std::size_t k = 0; k < 3; ++k) extent = std::max(extent, all.high[k] - all.low[k]);
  const double scale = extent > 0 ? 1 / extent : 0;
  std::vector<Center<3>> scaled(centers.size());
  for (std::size_t i = 0; i < centers.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double at = (centers[i][k] - all.low[k]) * scale;
      scaled[i].at[k] = at >= 0 && at <= 1 ? static_cast<float>(at) : 0;
    }
    scaled[i].feature = static_cast<Index>(i);
  }
  order_in_space<3>(scaled, [] {});
  std::ranges::transform(scaled, items_.begin(), [](const Center<3>& center) { return center.feature; });
  Index first = 0, end = leaf_count();  // nodes of one level
  while (end - first > 1) {
    const Index below = first;
    first = end;
    for (Index child = below; child < first; child += kBlock, ++end) first_child_.push_back(child);
  }
  first_child_.push_back(first);
}

}  // namespace tamis
