// The hierarchy of the published pipeline: a binary tree over triangles, with one of several bounding volumes.
#pragma once
#include <span>
#include <variant>

#include "paper/bounds/k_dop.hpp"
#include "paper/bounds/moving_points.hpp"
#include "paper/bounds/oriented_box.hpp"
#include "paper/bounds/sphere.hpp"
#include "paper/bounds/swept_volume.hpp"
#include "paper/bvh/refit.hpp"
#include "paper/bvh/self_traverse.hpp"
#include "paper/options.hpp"

namespace tamis::lab {

template <class Volume>
class PaperHierarchy {
 public:
  /// Builds the tree the first time, then refits it, and rebuilds it if that has made it poor. Returns true if it
  /// built. `order`: triangles in an order that each node halves; the tree is then never rebuilt. Empty: splits by
  /// place.
  bool update(std::span<const Face> triangles, const MovingPoints& points, double padding,
              const std::vector<Index>& order) {
    const bool first = tree_.size() == 0;
    if (!order.empty()) {
      if (first) tree_.build_in_order(order);
      refit_volumes(triangles, points, padding);
      return first;
    }
    if (first) build(triangles, points);
    double cost = refit_volumes(triangles, points, padding);
    const bool poor = !first && cost > kWorstGrowth * cost_when_built_;
    if (poor) {
      build(triangles, points);
      cost = refit_volumes(triangles, points, padding);
    }
    if (first || poor) cost_when_built_ = cost;
    return first || poor;
  }

  const BinaryTree& tree() const { return tree_; }
  SelfTraversal<Volume> traversal(std::span<const std::uint8_t> free_within) const {
    return {tree_, volumes_, free_within};
  }
  std::uint64_t memory_bytes() const { return tree_.memory_bytes() + volumes_.capacity() * sizeof(Volume); }

 private:
  /// Rebuilds if the sum of the nodes' extents, in units of the root's, grows by more than this factor: the number of
  /// nodes that a traversal visits grows with that sum.
  static constexpr double kWorstGrowth = 2;

  void build(std::span<const Face> triangles, const MovingPoints& points) {
    std::vector<Vec3<double>> centres;
    centres.reserve(triangles.size());
    for (const Face& f : triangles) {
      Vec3<double> sum{0, 0, 0};
      for (Index v : f) sum = sum + points[v].at0 + points[v].at1;
      centres.push_back(sum);
    }
    tree_.build(centres);
  }

  double refit_volumes(std::span<const Face> triangles, const MovingPoints& points, double padding) {
    const auto leaf = [&](Index triangle) {
      const Face& f = triangles[static_cast<std::size_t>(triangle)];
      const std::array corners{points[f[0]], points[f[1]], points[f[2]]};
      return volume_around<Volume>(corners, points.centre(), padding);
    };
    return refit(tree_, leaf, volumes_);
  }

  BinaryTree tree_;
  std::vector<Volume> volumes_;
  double cost_when_built_ = 0;
};

using AnyPaperHierarchy = std::variant<PaperHierarchy<Dop16>, PaperHierarchy<Aabb>, PaperHierarchy<Dop18>,
                                       PaperHierarchy<Dop26>, PaperHierarchy<Sphere>, PaperHierarchy<OrientedBox>>;

inline AnyPaperHierarchy make_paper_hierarchy(BoundingVolume volume) {
  switch (volume) {
    case BoundingVolume::sphere:
      return PaperHierarchy<Sphere>();
    case BoundingVolume::aabb:
      return PaperHierarchy<Aabb>();
    case BoundingVolume::obb:
      return PaperHierarchy<OrientedBox>();
    case BoundingVolume::dop16:
      return PaperHierarchy<Dop16>();
    case BoundingVolume::dop18:
      return PaperHierarchy<Dop18>();
    case BoundingVolume::dop26:
      return PaperHierarchy<Dop26>();
  }
  return PaperHierarchy<Dop16>();
}

}  // namespace tamis::lab
