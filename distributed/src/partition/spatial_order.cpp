#include "distributed/src/partition/spatial_order.hpp"

#include <algorithm>
#include <numeric>

#include "distributed/src/partition/box_tree.hpp"
#include "search/bounds/box.hpp"

namespace tamis::distributed {
namespace {

std::size_t longest_axis(std::span<const std::uint32_t> places, const std::vector<Point>& points) {
  Point low = points[places[0]], high = low;
  for (const std::uint32_t place : places)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], points[place][axis]);
      high[axis] = std::max(high[axis], points[place][axis]);
    }
  std::size_t longest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis)
    if (high[axis] - low[axis] > high[longest] - low[longest]) longest = axis;
  return longest;
}

/// About half of `count`, rounded to whole groups of sixteen, or of 256, and so on.
std::size_t half_in_groups(std::size_t count) {
  std::size_t group = BoxTree::kChildren;
  while (group * BoxTree::kChildren < count) group *= BoxTree::kChildren;
  return std::max(count / 2 / group, std::size_t{1}) * group;
}

void order(std::span<std::uint32_t> places, const std::vector<Point>& points) {
  if (places.size() <= BoxTree::kChildren) return;
  const std::size_t axis = longest_axis(places, points), half = half_in_groups(places.size());
  std::ranges::nth_element(places, places.begin() + static_cast<std::ptrdiff_t>(half), {},
                           [&](std::uint32_t place) { return points[place][axis]; });
  order(places.first(half), points);
  order(places.subspan(half), points);
}

}  // namespace

std::vector<Point> centers_of(const ElementSet& set) {
  std::vector<Point> centers;
  centers.reserve(set.elements.size());
  for (const Corners& corners : set.elements) {
    Box box;
    for_each_corner(corners, [&](std::size_t v) {
      box.include(set.motions[v].start);
      box.include(set.motions[v].end);
    });
    centers.push_back(box.middle());
  }
  return centers;
}

std::vector<std::uint32_t> spatial_order(const std::vector<Point>& points) {
  std::vector<std::uint32_t> places(points.size());
  std::iota(places.begin(), places.end(), 0U);
  order(places, points);
  return places;
}

}  // namespace tamis::distributed
