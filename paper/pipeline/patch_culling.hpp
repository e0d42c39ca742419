// High-level culling: proves whole patches of surface free of self-contact during the step, by a continuous normal cone
// and a contour test (Tang, Curtis, Yoon, Manocha 2009; star contours: Schvartzman, Gascon, Otaduy 2010), or, if the
// mesh moves in a subspace, by the length of its coordinates (Barbic, James 2010).
// Pairs of triangles within such a patch need no test; pairs between patches do.
#pragma once
#include <optional>

#include "paper/bounds/moving_points.hpp"
#include "paper/bounds/normal_cone.hpp"
#include "paper/bvh/binary_tree.hpp"
#include "paper/filters/contour_test.hpp"
#include "paper/options.hpp"
#include "paper/pipeline/reduced_pose.hpp"
#include "paper/pipeline/subspace_certificates.hpp"
#include "paper/topology/patches.hpp"

namespace tamis::lab {

class PatchCulling {
 public:
  /// Does nothing if `method` is none. Mesh and model must outlive it. `model`: for `subspace` only, validated.
  PatchCulling(const Mesh& mesh, HighLevelCulling method, const ReducedModel* model);

  /// The order of triangles from which the hierarchy must be built; empty if any will do.
  const std::vector<Index>& order() const { return order_; }

  /// Tries to prove nodes free, from the root down. REQUIRES: a tree of as many triangles as `order()`. REQUIRES (not
  /// checked: O(n)): built in that order.
  void update(const BinaryTree& tree, const MovingPoints& points, const Step& step);

  /// For each node, whether its triangles are proven free of contact with each other. Empty if there is no culling.
  const std::vector<std::uint8_t>& free_within() const { return free_within_; }
  std::uint64_t triangles_in_free_patches() const { return triangles_in_free_patches_; }
  std::uint64_t memory_bytes() const;

 private:
  /// Smaller patches are not worth a proof: testing them is faster.
  static constexpr std::size_t kSmallest = 16;

  void update_cones(const BinaryTree& tree, const MovingPoints& points);
  void update_norm(const BinaryTree& tree, const Step& step);
  void mark_free(const BinaryTree& tree, const MovingPoints& points);
  bool proves_free(Index node, const MovingPoints& points);
  bool contour_proves_free(Index node, const MovingPoints& points);

  const Mesh& mesh_;
  HighLevelCulling method_;
  const ReducedModel* model_;
  std::vector<Index> order_;
  IndexRows contours_;
  std::vector<NormalCone> cones_;
  std::vector<Moving<double>> loop_;
  ProjectedContour contour_;
  std::optional<PoseFinder> pose_finder_;
  std::optional<SubspaceCertificates> certificates_;
  double norm_ = 0;  ///< upper bound of |q| during the step; infinite if the step is not of the model
  std::vector<std::uint8_t> free_within_;
  std::uint64_t triangles_in_free_patches_ = 0;
};

}  // namespace tamis::lab
