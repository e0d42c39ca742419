#include "paper/pipeline/patch_culling.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include "numbers/assert.hpp"
#include "paper/bvh/refit.hpp"
#include "search/topology/at.hpp"

namespace tamis::lab {
namespace {

/// Half angle up to which all normals face the axis. The margin to the right angle is far above the rounding of the
/// axis and of the projection along it.
constexpr double kWidestCone = std::numbers::pi / 2 - 1e-3;

}  // namespace

PatchCulling::PatchCulling(const Mesh& mesh, HighLevelCulling method, const ReducedModel* model)
    : mesh_(mesh), method_(method), model_(model) {
  if (method == HighLevelCulling::none) return;
  order_ = patch_order(mesh);
  if (method == HighLevelCulling::subspace)
    pose_finder_.emplace(*model);
  else
    contours_ = patch_contours(mesh, order_, kSmallest);
}

void PatchCulling::update(const BinaryTree& tree, const MovingPoints& points, const Step& step) {
  if (method_ == HighLevelCulling::none || tree.size() == 0) return;
  TAMIS_ASSERT(tree.size() == 2 * static_cast<Index>(order_.size()) - 1);
  if (pose_finder_)
    update_norm(tree, step);
  else
    update_cones(tree, points);
  mark_free(tree, points);
}

void PatchCulling::update_cones(const BinaryTree& tree, const MovingPoints& points) {
  const auto cone_of = [&](Index triangle) {
    const Face& f = mesh_.faces()[at(triangle)];
    return NormalCone::around(points[f[0]], points[f[1]], points[f[2]]);
  };
  refit(tree, cone_of, cones_);
}

/// Positions move on straight lines, and so do q and the residual x - (X + U q): both are largest at an end.
void PatchCulling::update_norm(const BinaryTree& tree, const Step& step) {
  if (!certificates_) certificates_.emplace(tree, mesh_.faces(), *model_);
  norm_ = 0;
  for (const Positions& x : {step.start, step.end}) {
    const ReducedPose pose = pose_finder_->pose_of(x);
    const bool is_of_the_model = pose.residual <= certificates_->allowed_residual() && pose.norm >= 0;
    norm_ = is_of_the_model ? std::max(norm_, pose.norm) : std::numeric_limits<double>::infinity();
  }
}

void PatchCulling::mark_free(const BinaryTree& tree, const MovingPoints& points) {
  free_within_.assign(at(tree.size()), 0);
  triangles_in_free_patches_ = 0;
  struct Patch {
    Index node;
    std::size_t triangles;
  };
  std::vector<Patch> open{{0, order_.size()}};
  while (!open.empty()) {
    const Patch patch = open.back();
    open.pop_back();
    if (patch.triangles < kSmallest) continue;
    if (proves_free(patch.node, points)) {
      free_within_[at(patch.node)] = 1;
      triangles_in_free_patches_ += patch.triangles;
      continue;
    }
    const std::size_t half = patch.triangles / 2;
    open.push_back({tree.left(patch.node), half});
    open.push_back({tree.right(patch.node), patch.triangles - half});
  }
}

bool PatchCulling::proves_free(Index node, const MovingPoints& points) {
  return certificates_ ? norm_ < certificates_->least_norms()[at(node)] : contour_proves_free(node, points);
}

bool PatchCulling::contour_proves_free(Index node, const MovingPoints& points) {
  const NormalCone& cone = cones_[at(node)];
  const auto contour = contours_[node];
  if (!(cone.half_angle < kWidestCone) || contour.empty()) return false;
  loop_.clear();
  for (Index v : contour) loop_.push_back(points[v]);
  contour_.project(loop_, cone.axis);
  return method_ == HighLevelCulling::star_contours ? contour_.proves_star_shaped() : contour_.proves_simple();
}

std::uint64_t PatchCulling::memory_bytes() const {
  return (order_.capacity() + contours_.offsets.capacity() + contours_.items.capacity()) * sizeof(Index) +
         cones_.capacity() * sizeof(NormalCone) + loop_.capacity() * sizeof(loop_[0]) + free_within_.capacity() +
         (pose_finder_ ? pose_finder_->memory_bytes() : 0) + (certificates_ ? certificates_->memory_bytes() : 0);
}

}  // namespace tamis::lab
