// The hierarchy must give every pair of triangles whose bounds overlap, once, however the work is cut into parts.
#include "paper/bvh/self_traverse.hpp"

#include <gtest/gtest.h>

#include <set>

#include "paper/bounds/feature_boxes.hpp"
#include "paper/bvh/refit.hpp"
#include "scenes/scene_list.hpp"

namespace tamis::lab {
namespace {

using Pairs = std::multiset<std::pair<Index, Index>>;

struct Tree {
  explicit Tree(const scenes::Scene& scene) {
    const Mesh mesh = scene.mesh();
    points.update(mesh, scene.step());
    boxes.update(mesh, points, 0);
    std::vector<Vec3<double>> centres;
    for (const Face& f : mesh.faces()) centres.push_back(points[f[0]].at0 + points[f[1]].at0 + points[f[2]].at0);
    shape.build(centres);
    cost = refit(
        shape, [&](Index t) { return boxes.faces[static_cast<std::size_t>(t)]; }, volumes);
  }

  MovingPoints points;
  FeatureBoxes boxes;
  BinaryTree shape;
  std::vector<Dop16> volumes;
  double cost = 0;
};

Pairs pairs_by_tree(const Tree& tree, std::size_t parts) {
  const SelfTraversal<Dop16> traversal(tree.shape, tree.volumes, {});
  Pairs pairs;
  std::uint64_t tested = 0;
  for (const SubtreePair& part : traversal.parts(parts))
    traversal.visit(
        part, [&](Index a, Index b) { pairs.insert(std::minmax(a, b)); }, tested);
  return pairs;
}

Pairs pairs_one_by_one(const std::vector<Dop16>& boxes) {
  Pairs pairs;
  for (std::size_t j = 0; j < boxes.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      if (overlap(boxes[i], boxes[j])) pairs.insert({static_cast<Index>(i), static_cast<Index>(j)});
  return pairs;
}

TEST(self_traverse, gives_each_overlapping_pair_once_for_any_number_of_parts) {
  for (const char* name : {"soup", "folded-cloth", "tangle", "degenerate", "fans"})
    for (Index triangles : {1, 2, 3, 7, 300}) {
      const Tree tree(scenes::scene_by_name(name, triangles, 5));
      const Pairs expected = pairs_one_by_one(tree.boxes.faces);
      for (std::size_t parts : {1U, 2U, 64U, 100000U}) EXPECT_EQ(pairs_by_tree(tree, parts), expected) << name;
    }
}

TEST(self_traverse, every_node_contains_its_children) {
  const Tree tree(scenes::scene_by_name("soup", 500, 1));
  const auto volume = [&](Index node) { return tree.volumes[static_cast<std::size_t>(node)]; };
  for (Index node = 0; node < tree.shape.size(); ++node) {
    if (tree.shape.is_leaf(node)) continue;
    const Dop16 merged = merge(volume(tree.shape.left(node)), volume(tree.shape.right(node)));
    EXPECT_EQ(merged.lower, volume(node).lower);
    EXPECT_EQ(merged.upper, volume(node).upper);
  }
  EXPECT_EQ(tree.shape.size(), 2 * 500 - 1);
}

}  // namespace
}  // namespace tamis::lab
