#include "search/engine/feature_trees.hpp"

#include <algorithm>

#include "numbers/assert.hpp"
#include "numbers/in_parts.hpp"
#include "search/bvh/order_axes.hpp"
#include "search/query/cancellation.hpp"
#include "search/query/stopwatch.hpp"

namespace tamis {
namespace {

/// Trees are rebuilt once the leaf blocks' swept area exceeds that at the last build by this factor. Measured on
/// cloth-ball: at 0.8 times the area a refit takes 95 ms in all and a rebuild 119, at 1.9 times 279 and 248.
constexpr double kPoorArea = 1.5;
/// Trees are also rebuilt once the area at the start exceeds that at the last build by this factor, whatever they sweep
/// over. The swept area depends on the length of the step.
constexpr double kPoorStart = 8;
/// Building costs about as much as visiting this many pairs of nodes for each leaf block.
constexpr std::uint64_t kNodesPerBlock = 9;
/// A step is long if leaf blocks sweep over more than kFarAreas times their own area. On long steps, every
/// kStartInRow-th question in a row about the start tests whether an order by the start would pay.
constexpr double kFarAreas = 4;
constexpr int kStartInRow = 8;

}  // namespace

FeatureTrees::FeatureTrees(const Mesh& mesh, const Options& options, const Kernels& kernels)
    : mesh_(mesh), options_(options), kernels_(kernels), loose_(mesh) {
  const PairFilter& filter = options.filter;
  for (BlockTree* tree : trees()) tree->set_groups(filter.group_of_vertex, filter.groups_may_touch, filter.group_count);
  points_.set_features(mesh.points());
  edges_.set_features(mesh.edges());
  faces_.set_features(mesh.faces());
  if (loose_.points.empty()) return;
  loose_points_.set_features(loose_.points);
  loose_edges_.set_features(std::span<const Edge>(loose_.edges));
}

template <class F>
void FeatureTrees::for_each_tree(const F& f) {
  const auto all = trees();
  const std::size_t at_a_time = loops_nest() && mesh_.points().size() > kVerticesPerPart ? 1 : all.size();
  for_each_in_parts(all, at_a_time, [&](BlockTree* tree) { f(*tree); });
}

void FeatureTrees::refit_or_rebuild(const Step& step, const Separations& separations, const BoxFrame* frame,
                                    LooksAt looks_at, Statistics& statistics) {
  Stopwatch watch;
  assign(step, separations, frame);
  statistics.seconds.bounds += watch.lap();
  const bool looks_at_start = looks_at != LooksAt::whole_step;
  start_in_row_ = looks_at_start ? start_in_row_ + 1 : 0;
  if (!boxes_are_current_ || is_order_in_doubt_ || looks_at_start != is_order_of_start())
    update_trees(looks_at, statistics);
  statistics.seconds.build += watch.lap();
}

void FeatureTrees::assign(const Step& step, const Separations& separations, const BoxFrame* frame) {
  TAMIS_ASSERT(step.start.count() == mesh_.vertex_count() && step.end.count() == mesh_.vertex_count());
  mark({});
  if (motion_.assign(step, mesh_.points(), separations, frame)) boxes_are_current_ = false;
}

bool FeatureTrees::are_of(const Step& step) const {
  if (!boxes_are_current_) return false;
  const Index some = mesh_.points()[mesh_.points().size() / 2];
  const PackedVertex& packed = motion_.vertices[static_cast<std::size_t>(some)];
  return std::equal(packed.start(), packed.start() + 3, step.start[some]) &&
         std::equal(packed.end(), packed.end() + 3, step.end[some]);
}

void FeatureTrees::refit_for(const Step& step, const Separations& separations, const BoxFrame* frame) {
  TAMIS_ASSERT(points_.is_built());
  assign(step, separations, frame);
  if (!boxes_are_current_) refit_trees();
}

void FeatureTrees::refit_trees() {
  for_each_tree([&](BlockTree& tree) {
    stop_if_cancelled(options_);
    tree.refit(motion_, kernels_.bound_leaf);
  });
  boxes_are_current_ = true;
}

void FeatureTrees::load_vertices(const Step& step, const Separations& separations, const BoxFrame* frame,
                                 Statistics& statistics) {
  const Stopwatch watch;
  assign(step, separations, frame);
  statistics.seconds.bounds += watch.seconds();
}

void FeatureTrees::update_trees(LooksAt looks_at, Statistics& statistics) {
  if (built_areas_) {
    if (!boxes_are_current_) refit_trees();
    if (is_order_good(looks_at)) return;
  }
  built_areas_.reset();  // until all trees are built
  boxes_are_current_ = false;
  axes_ = best_axes(looks_at);
  for_each_tree(
      [&](BlockTree& tree) { tree.build(motion_, axes_, kernels_.bound_leaf, [&] { stop_if_cancelled(options_); }); });
  built_areas_ = areas();
  built_scale_ = motion_.frame.scale;
  is_order_in_doubt_ = false;
  nodes_in_doubt_ = 0;
  boxes_are_current_ = true;
  statistics.rebuilt = true;
}

BlockTree::Areas FeatureTrees::areas() const {
  BlockTree::Areas sum;
  for (const BlockTree* tree : trees()) {
    if (tree->feature_count() == 0) continue;
    const BlockTree::Areas one = tree->areas();
    sum.at_start += one.at_start;
    sum.swept += one.swept;
  }
  return sum;
}

OrderAxes FeatureTrees::best_axes(LooksAt looks_at) const { return order_axes(motion_, mesh_.points(), looks_at); }

bool FeatureTrees::is_order_good(LooksAt looks_at) {
  const BlockTree::Areas now = areas(), &built = *built_areas_;
  const double by_scale = (built_scale_ / motion_.frame.scale) * (built_scale_ / motion_.frame.scale);
  const bool is_far = now.swept > kFarAreas * now.at_start;
  is_order_in_doubt_ = axes_.displacement_weight > 0 && !is_far;
  const int blocks = points_.view().leaf_blocks + edges_.view().leaf_blocks + faces_.view().leaf_blocks;
  const bool has_cost_an_order = nodes_in_doubt_ > kNodesPerBlock * static_cast<std::uint64_t>(blocks);
  if (is_order_in_doubt_ && has_cost_an_order && best_axes(looks_at).displacement_weight == 0) return false;
  const auto has_spread = [&](double times) { return now.at_start * by_scale > times * built.at_start; };
  if (is_order_of_start()) return !has_spread(kPoorArea) && !(is_far && looks_at == LooksAt::whole_step);
  if (has_spread(kPoorStart)) return false;
  const bool may_pay = is_far && looks_at != LooksAt::whole_step && start_in_row_ % kStartInRow == 0;
  return now.swept <= kPoorArea * built.swept && !(may_pay && best_axes(looks_at).time == 0);
}

/// The compiler names a kind that is forgotten here.
std::array<const BlockTree*, 2> FeatureTrees::trees_of(PairKind kind) const {
  switch (kind) {
    case PairKind::vertex_face:
      return {&points_, &faces_};
    case PairKind::edge_edge:
      return {&edges_, &edges_};
    case PairKind::vertex_edge:
      return {&loose_points_, &loose_edges_};
    case PairKind::vertex_vertex:
      return {&loose_points_, &loose_points_};
  }
  TAMIS_ASSERT(false);
  return {};
}

void FeatureTrees::mark(std::span<const std::uint8_t> of_vertex) {
  for (BlockTree* tree : trees()) tree->mark(of_vertex);
}

void FeatureTrees::refit_residuals(const SharedMotion& shared) {
  TAMIS_ASSERT(boxes_are_current_);
  motion_.assign_residuals(mesh_.points(), shared);
  for_each_tree([&](BlockTree& tree) {
    stop_if_cancelled(options_);
    tree.refit_residuals(motion_, kernels_.bound_leaf);
  });
}

}  // namespace tamis
