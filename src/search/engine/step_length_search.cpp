#include "search/engine/step_length_search.hpp"

#include <algorithm>
#include <span>

#include "search/query/cancellation.hpp"
#include "search/topology/at.hpp"

namespace tamis {
namespace {

/// If leaf blocks meet more than this many pairs each, short steps are searched first, on which they meet few. A pair
/// that ends a short step spares the rest of the search.
constexpr std::uint64_t kManyPairsPerBlock = 1024;
constexpr double kShortSteps[] = {0x1p-6, 0x1p-3};
/// Short steps are no longer than this part of the time known to end the step. A step that is hardly shorter meets
/// hardly fewer pairs.
constexpr double kShort = 0.25;
/// In the coordinates of the boxes: with the separation kMeetsAll all boxes meet but outliers'; with kMeetsOutliers,
/// these too.
constexpr double kMeetsAll = 8, kMeetsOutliers = 4 * BoxFrame::kFarthest;

}  // namespace

/// Returns true if the lists serve the query, false if the trees must be searched.
bool StepLengthSearch::begin(StepLengthQuery& asked, Statistics& statistics) {
  TAMIS_ASSERT(0 < asked.fraction && asked.fraction < 1);
  TAMIS_ASSERT(asked.query.changed.empty() || asked.query.changed.size() == at(workspace_.mesh.vertex_count()));
  const Query& query = asked.query;
  const bool do_lists_serve = near_start_.begin(query, asked.fraction, asked.lists_all);
  const bool is_listed = candidates_.prepare(query, LooksAt::distances, do_lists_serve, near_start_, statistics);
  const Stopwatch watch;
  if (!is_listed) {
    refit_residuals(asked);
    workspace_.trees.mark(query.changed);
  }
  asked.spread = workspace_.trees.motion().spread;
  statistics.seconds.bounds += watch.seconds();
  streams_.begin(asked);
  return is_listed;
}

void StepLengthSearch::refit_residuals(StepLengthQuery& asked) {
  FeatureTrees& trees = workspace_.trees;
  const PackedMotion& motion = trees.motion();
  asked.shared_motion = fit_shared_motion(workspace_.mesh, motion, asked.fraction);
  trees.refit_residuals(asked.shared_motion);
  const Separations& separations = motion.separations;
  const double separation = (separations.fixed + 2 * separations.largest_radius()) * motion.frame.scale;
  asked.separation = std::min(separation, motion.frame.has_outliers ? kMeetsOutliers : kMeetsAll);
}

SafeStep StepLengthSearch::find(const Query& query, double fraction, Statistics& statistics) {
  StepLengthQuery asked{.query = query, .fraction = fraction, .lists_all = false};
  ask(asked, statistics);
  StepLimit limit;
  streams_.for_each([&](StepLengthConsumer& consumer) { limit.add(consumer.limit()); });
  return limit.answer(query, fraction);
}

void StepLengthSearch::find_all(const Query& query, double fraction, std::vector<StepLimit>& ends,
                                Statistics& statistics) {
  StepLengthQuery asked{.query = query, .fraction = fraction, .lists_all = true};
  ask(asked, statistics);
  ends.clear();
  streams_.for_each(
      [&](StepLengthConsumer& consumer) { ends.insert(ends.end(), consumer.ends().begin(), consumer.ends().end()); });
  sort_in_parts(ends, comes_before_in_order, [&] { stop_if_cancelled(query); });
}

void StepLengthSearch::ask(StepLengthQuery& asked, Statistics& statistics) {
  const bool is_listed = begin(asked, statistics);
  const Stopwatch watch;
  if (is_listed)
    streams_.search_lists(near_start_.lists());
  else
    search_trees(asked);
  streams_.report(statistics, watch.seconds(), {&SearchCounts::boxes, &SearchCounts::near});
}

void StepLengthSearch::search_trees(StepLengthQuery& asked) {
  if (asked.lists_all) return streams_.search_trees();
  const Samples samples(workspace_.trees.most_leaf_blocks());
  const Sample& first = *samples.begin();
  streams_.search_trees(first);
  if (meets_many(first)) search_short_steps(asked.bound, samples);
  for (const Sample& sample : std::span(samples).subspan(1)) streams_.search_trees(sample);
}

/// True if the search has met many pairs a leaf block in `sample`, its first one.
bool StepLengthSearch::meets_many(const Sample& sample) const {
  std::uint64_t blocks = 0;
  workspace_.trees.for_each_kind([&](PairKind, const TreeView& a, const TreeView&) {
    blocks += static_cast<std::uint64_t>(sample.count_in(a.leaf_blocks));
  });
  const StageCount pairs = streams_.counts().boxes;
  return pairs.vf + pairs.ee > kManyPairsPerBlock * blocks;
}

/// The first pair that ends a short step is also the first that ends the whole step.
void StepLengthSearch::search_short_steps(Bound& bound, const Samples& samples) {
  for (const double until : kShortSteps) {
    const double earliest = bound.latest();
    if (until >= kShort * earliest) return;
    bound.begin(until);
    for (const Sample& sample : samples) streams_.search_trees(sample);
    if (bound.latest() < until) return;
    bound.begin(earliest);
  }
}

}  // namespace tamis
