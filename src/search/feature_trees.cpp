#include "search/feature_trees.hpp"

#include <algorithm>

#include "bvh/order_axes.hpp"
#include "numerics/assert.hpp"
#include "query/cancellation.hpp"
#include "query/stopwatch.hpp"

namespace tamis {
namespace {

/// Refitting goes on until the leaf blocks' swept area exceeds by this factor what it was when they were built
/// (docs/history/performance.md: "When to rebuild").
constexpr double kPoorArea = 1.5;
/// An order by how far features go is asked about again when they sweep over less than this part of what they did then.
constexpr double kShorterSteps = 1.0 / 64;

}  // namespace

FeatureTrees::FeatureTrees(const Mesh& mesh, const Options& options, const Kernels& kernels)
    : mesh_(mesh), options_(options), kernels_(kernels), loose_(mesh) {
  const PairFilter& filter = options.filter;
  for (BlockTree* tree : {&points_, &edges_, &faces_, &loose_points_, &loose_edges_})
    tree->set_groups(filter.group_of_vertex, filter.groups_may_touch, filter.group_count);
  points_.set_features(mesh.points());
  edges_.set_features(mesh.edges());
  faces_.set_features(mesh.faces());
  if (loose_.points.empty()) return;
  loose_points_.set_features(loose_.points);
  loose_edges_.set_features(std::span<const Edge>(loose_.edges));
}

void FeatureTrees::refit_or_rebuild(const Step& step, const Separations& separations, Statistics& statistics) {
  Stopwatch watch;
  assign(step, separations);
  statistics.seconds.bounds += watch.lap();
  if (!are_of_motion_) update_trees(statistics);
  statistics.seconds.build += watch.lap();
}

void FeatureTrees::assign(const Step& step, const Separations& separations) {
  TAMIS_ASSERT(step.start.count() == mesh_.vertex_count() && step.end.count() == mesh_.vertex_count());
  assigned_ = step;
  if (motion_.assign(step, mesh_.points(), separations)) are_of_motion_ = false;
}

bool FeatureTrees::are_of(const Step& step) const {
  const auto are_same = [](const Positions& a, const Positions& b) {
    return a.data() == b.data() && a.count() == b.count() && a.stride() == b.stride();
  };
  if (!are_of_motion_ || !are_same(assigned_.start, step.start) || !are_same(assigned_.end, step.end)) return false;
  const Index some = mesh_.points()[mesh_.points().size() / 2];
  const double* packed = motion_.vertices[static_cast<std::size_t>(some)].at;
  return std::equal(packed, packed + 3, step.start[some]) && std::equal(packed + 4, packed + 7, step.end[some]);
}

void FeatureTrees::refit_for(const Step& step, const Separations& separations) {
  TAMIS_ASSERT(points_.is_built());
  assign(step, separations);
  if (!are_of_motion_) refit_trees();
}

void FeatureTrees::refit_trees() {
  for (BlockTree* tree : {&points_, &edges_, &faces_, &loose_points_, &loose_edges_}) {
    stop_if_cancelled(options_);
    tree->refit(motion_, kernels_.trees);
  }
  are_of_motion_ = true;
}

void FeatureTrees::load_vertices(const Step& step, const Separations& separations, Statistics& statistics) {
  TAMIS_ASSERT(points_.is_built());
  const Stopwatch watch;
  assign(step, separations);
  statistics.seconds.bounds += watch.seconds();
}

void FeatureTrees::update_trees(Statistics& statistics) {
  BlockTree* const trees[] = {&points_, &edges_, &faces_, &loose_points_, &loose_edges_};
  const auto area = [&] {
    double sum = 0;
    for (const BlockTree* tree : trees)
      if (tree->feature_count() > 0) sum += tree->swept_area();
    return sum;
  };
  const double scale = motion_.frame.scale;
  const auto best_axes = [&] { return order_axes(motion_, mesh_.points(), kernels_.trees.split); };
  if (built_area_ > 0) {
    refit_trees();
    const double now = area();
    // The next step may go nowhere near as far, and sweep over little in whatever order: in its own frame, as a step
    // that goes far has a large one.
    const double part = now / built_area_ * (built_scale_ / scale) * (built_scale_ / scale);
    const bool is_of_longer_steps = axes_ != 3 && part < kShorterSteps && best_axes() == 3;
    if (now <= kPoorArea * built_area_ && !is_of_longer_steps) return;
  }
  built_area_ = 0;  // until all are built
  are_of_motion_ = false;
  axes_ = best_axes();
  for (BlockTree* tree : trees) tree->build(motion_, axes_, kernels_.trees, [&] { stop_if_cancelled(options_); });
  // Areas are of the box frame, which holds the scene whatever its size; a scene without area is rebuilt each time.
  built_area_ = area();
  built_scale_ = scale;
  are_of_motion_ = true;
  statistics.rebuilt = true;
}

void FeatureTrees::fit_residuals(const Step& step, const SharedMotion& shared) {
  TAMIS_ASSERT(are_of(step));
  motion_.assign_residuals(step, shared);
  for (BlockTree* tree : {&points_, &edges_, &faces_, &loose_points_, &loose_edges_}) {
    stop_if_cancelled(options_);
    tree->refit_residuals(motion_, kernels_.trees);
  }
}

std::uint64_t FeatureTrees::memory_bytes() const {
  std::uint64_t bytes = motion_.memory_bytes();
  for (const BlockTree* tree : {&points_, &edges_, &faces_, &loose_points_, &loose_edges_})
    bytes += tree->memory_bytes();
  return bytes;
}

}  // namespace tamis
