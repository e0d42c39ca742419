#include "search/step_length_search.hpp"

#include <algorithm>
#include <span>

namespace tamis {
namespace {

/// Where a leaf block meets so many pairs short steps come first, which meet few: a pair that ends one spares the rest.
constexpr std::uint64_t kManyPairsABlock = 1024;
constexpr double kShortSteps[] = {0x1p-6, 0x1p-3};
/// In the coordinates of the boxes: with a larger separation no two have a gap.
constexpr double kMeetsAll = 8;

}  // namespace

void StepLengthSearch::begin(StepLengthQuery& asked, Statistics& statistics) {
  TAMIS_ASSERT(0 < asked.fraction && asked.fraction < 1);
  const Step& step = asked.query.step;
  const Separations& separations = asked.query.separations;
  FeatureTrees& trees = workspace_.trees;
  trees.refit_or_rebuild(step, separations, statistics);
  Stopwatch watch;
  const BoxFrame& frame = trees.motion().frame;
  shared_.fit(step, frame, asked.fraction);
  trees.fit_residuals(step, shared_);
  asked.stretch = shared_.stretch();
  asked.spread = trees.motion().spread;
  const double separation = (separations.fixed + 2 * separations.largest_radius()) * frame.scale;
  asked.separation = std::min(separation, kMeetsAll);
  statistics.seconds.bounds += watch.lap();
  streams_.begin(asked);
}

SafeStep StepLengthSearch::find(const Query& query, double fraction, Statistics& statistics) {
  StepLengthQuery asked{query, fraction, false};
  begin(asked, statistics);
  const Stopwatch watch;
  const Samples samples(workspace_.trees.most_leaf_blocks());
  const Sample& first = *samples.begin();
  search(first);
  if (meets_many(first)) search_short_steps(asked.bound, samples);
  for (const Sample& sample : std::span(samples).subspan(1)) search(sample);
  StepLimit limit;
  streams_.for_each([&](StepLengthConsumer& consumer) { limit.add(consumer.limit()); });
  streams_.report(statistics, watch.seconds(), {&SearchCounts::boxes, &SearchCounts::near});
  return limit.answer(query, fraction);
}

void StepLengthSearch::find_all(const Query& query, double fraction, std::vector<StepLimit>& ends,
                                Statistics& statistics) {
  StepLengthQuery asked{query, fraction, true};
  begin(asked, statistics);
  const Stopwatch watch;
  search(*Samples().begin());
  streams_.report(statistics, watch.seconds(), {&SearchCounts::boxes, &SearchCounts::near});
  ends.clear();
  streams_.for_each(
      [&](StepLengthConsumer& consumer) { ends.insert(ends.end(), consumer.ends().begin(), consumer.ends().end()); });
  std::sort(ends.begin(), ends.end(), comes_before_in_order);
}

/// Of the sample, which has been searched.
bool StepLengthSearch::meets_many(const Sample& sample) const {
  std::uint64_t blocks = 0;
  workspace_.trees.for_each_kind([&](PairKind, const TreeView& a, const TreeView&) {
    blocks += static_cast<std::uint64_t>(sample.count_in(a.leaf_blocks));
  });
  const StageCount pairs = streams_.counts().boxes;
  return pairs.vf + pairs.ee > kManyPairsABlock * blocks;
}

/// A pair that ends a short step ends it first of all.
void StepLengthSearch::search_short_steps(Bound& bound, const Samples& samples) {
  for (const double until : kShortSteps) {
    const double earliest = bound.latest();
    if (until >= earliest) return;
    bound.begin(until);
    for (const Sample& sample : samples) search(sample);
    if (bound.latest() < until) return;
    bound.begin(earliest);
  }
}

void StepLengthSearch::search(const Sample& sample) {
  workspace_.trees.for_each_kind(
      [&](PairKind kind, const TreeView& a, const TreeView& b) { streams_.search(kind, a, b, sample); });
}

}  // namespace tamis
