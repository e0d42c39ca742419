#include "paper/bvh/binary_tree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace tamis::lab {
namespace {

using Centres = std::span<const Vec3<double>>;

double component(const Vec3<double>& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

int longest_axis(Centres centres, std::span<const Index> triangles) {
  std::array<double, 3> extent{};
  for (int axis = 0; axis < 3; ++axis) {
    double low = std::numeric_limits<double>::max(), high = -low;
    for (Index t : triangles) {
      const double c = component(centres[static_cast<std::size_t>(t)], axis);
      low = std::min(low, c);
      high = std::max(high, c);
    }
    extent[static_cast<std::size_t>(axis)] = high - low;
  }
  return static_cast<int>(std::max_element(extent.begin(), extent.end()) - extent.begin());
}

void build_subtree(Centres centres, std::span<Index> triangles, std::vector<Index>& links) {
  if (triangles.size() == 1) {
    links.push_back(~triangles[0]);
    return;
  }
  const int axis = longest_axis(centres, triangles);
  const std::size_t half = triangles.size() / 2;
  // Equal centres are ordered by index, so that the tree is the same on every machine.
  std::nth_element(triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(half), triangles.end(),
                   [&](Index a, Index b) {
                     const double ca = component(centres[static_cast<std::size_t>(a)], axis);
                     const double cb = component(centres[static_cast<std::size_t>(b)], axis);
                     return ca != cb ? ca < cb : a < b;
                   });
  const std::size_t node = links.size();
  links.push_back(0);
  build_subtree(centres, triangles.first(half), links);
  links[node] = static_cast<Index>(links.size());
  build_subtree(centres, triangles.subspan(half), links);
}

void halve(std::span<const Index> triangles, std::vector<Index>& links) {
  if (triangles.size() == 1) {
    links.push_back(~triangles[0]);
    return;
  }
  const std::size_t node = links.size(), half = triangles.size() / 2;
  links.push_back(0);
  halve(triangles.first(half), links);
  links[node] = static_cast<Index>(links.size());
  halve(triangles.subspan(half), links);
}

}  // namespace

void BinaryTree::build_in_order(std::span<const Index> triangles) {
  links_.clear();
  if (!triangles.empty()) halve(triangles, links_);
}

void BinaryTree::build(Centres centres) {
  links_.clear();
  if (centres.empty()) return;
  std::vector<Index> triangles(centres.size());
  std::iota(triangles.begin(), triangles.end(), 0);
  links_.reserve(2 * triangles.size() - 1);
  build_subtree(centres, triangles, links_);
}

}  // namespace tamis::lab
