// Patches and their contours, against the plain definition: the sides of a patch's triangles that have no opposite one.
#include "paper/topology/patches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "scenes/scene_list.hpp"

namespace tamis::lab {
namespace {

/// Net number of times each directed side is passed.
std::map<Edge, int> sides_of(const Mesh& mesh, std::span<const Index> patch) {
  std::map<Edge, int> sides;
  for (Index t : patch) {
    const Face& f = mesh.faces()[static_cast<std::size_t>(t)];
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = f[k], b = f[(k + 1) % 3];
      if (sides[{b, a}] > 0)
        --sides[{b, a}];
      else
        ++sides[{a, b}];
    }
  }
  std::erase_if(sides, [](const auto& side) { return side.second == 0; });
  return sides;
}

/// Visits the patches in depth-first order and compares each contour that is there.
void expect_contours(const Mesh& mesh, const IndexRows& contours, std::span<const Index> patch, Index& node,
                     int& loops) {
  const auto loop = contours[node++];
  if (!loop.empty()) {
    ++loops;
    const auto sides = sides_of(mesh, patch);
    EXPECT_EQ(sides.size(), loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto side = sides.find({loop[i], loop[(i + 1) % loop.size()]});
      ASSERT_NE(side, sides.end());
      EXPECT_EQ(side->second, 1);
    }
    std::vector<Index> sorted(loop.begin(), loop.end());
    std::ranges::sort(sorted);
    EXPECT_EQ(std::ranges::adjacent_find(sorted), sorted.end()) << "a vertex is visited twice";
  }
  if (patch.size() < 2) return;
  const std::size_t half = patch.size() / 2;
  expect_contours(mesh, contours, patch.first(half), node, loops);
  expect_contours(mesh, contours, patch.subspan(half), node, loops);
}

TEST(patches, contours_are_the_sides_that_nothing_cancels_on_every_kind_of_mesh) {
  for (const scenes::Recipe& recipe : scenes::recipes()) {
    const Mesh mesh = recipe.make(300, 1).mesh();
    const auto order = patch_order(mesh);
    ASSERT_EQ(order.size(), mesh.faces().size());
    const auto contours = patch_contours(mesh, order, 2);
    Index node = 0;
    int loops = 0;
    expect_contours(mesh, contours, order, node, loops);
    EXPECT_EQ(node, contours.size()) << recipe.name;
    EXPECT_TRUE(recipe.name != "folded-cloth" || loops > 50);
  }
}

TEST(patches, a_strip_has_one_contour_and_a_twisted_or_closed_one_has_none) {
  const Mesh strip(6, {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}});
  EXPECT_EQ(patch_contours(strip, {0, 1, 2, 3}, 2)[0].size(), 6U);
  const Mesh turned(6, {{0, 1, 2}, {2, 1, 3}, {2, 4, 3}, {4, 3, 5}});
  EXPECT_TRUE(patch_contours(turned, {0, 1, 2, 3}, 2)[0].empty());
  const Mesh closed(4, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}});
  EXPECT_TRUE(patch_contours(closed, {0, 1, 2, 3}, 2)[0].empty());
}

}  // namespace
}  // namespace tamis::lab
