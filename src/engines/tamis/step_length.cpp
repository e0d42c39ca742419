#include "engines/tamis/step_length.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <span>

#include "engines/stopwatch.hpp"
#include "numerics/assert.hpp"

namespace tamis {
namespace {

/// Where a leaf block meets so many pairs short steps come first, which meet few: a pair that ends one spares the rest.
constexpr std::uint64_t kMany = 1024;
constexpr double kShortSteps[] = {0x1p-6, 0x1p-3};
/// In the frame of the boxes: with a larger separation no two have a gap.
constexpr double kMeetsAll = 8;

}  // namespace

StepLengthSearch::StepLengthSearch(const Mesh& mesh, const Options& options, const Kernels& kernels,
                                   FeatureTrees& trees)
    : options_(options), kernels_(kernels), trees_(trees), shared_(mesh), pipelines_([this] {
        return NearPipeline(kernels_, trees_.motion(), options_, question_);
      }) {}

void StepLengthSearch::begin(const Step& step, const Separations& separations, double fraction, bool lists_all,
                             Statistics& statistics) {
  question_.step = step;
  question_.fraction = fraction;
  question_.earliest = 1;
  question_.lists_all = lists_all;
  trees_.update(step, separations, statistics);
  Stopwatch watch;
  const BoxFrame& frame = trees_.motion().frame;
  shared_.fit(step, frame, fraction);
  trees_.fit_residuals(step, shared_);
  question_.stretch = shared_.stretch();
  question_.spread = trees_.motion().spread;
  const double separation = (separations.fixed + 2 * separations.largest_radius()) * frame.scale;
  question_.separation = std::min(separation, kMeetsAll);
  statistics.seconds.bounds += watch.lap();
  for (NearPipeline& pipeline : pipelines_) pipeline.begin();
}

SafeStep StepLengthSearch::find(const Step& step, const Separations& separations, double fraction,
                                Statistics& statistics) {
  TAMIS_ASSERT(0 < fraction && fraction < 1);
  begin(step, separations, fraction, false, statistics);
  Stopwatch watch;
  const Samples samples(trees_.most_leaf_blocks());
  const Sample& first = *samples.begin();
  search(first);
  if (meets_many(first)) search_short_steps(samples);
  for (const Sample& sample : std::span(samples).subspan(1)) search(sample);
  return collect(statistics, watch.lap()).answer(step, fraction, separations);
}

void StepLengthSearch::find_all(const Step& step, const Separations& separations, double fraction,
                                std::vector<StepLimit>& ends, Statistics& statistics) {
  TAMIS_ASSERT(0 < fraction && fraction < 1);
  begin(step, separations, fraction, true, statistics);
  Stopwatch watch;
  search(*Samples().begin());
  collect(statistics, watch.lap());
  ends.clear();
  for (const NearPipeline& pipeline : pipelines_)
    ends.insert(ends.end(), pipeline.ends().begin(), pipeline.ends().end());
  std::sort(ends.begin(), ends.end(), comes_before_in_order);
}

/// Of the sample, which has been searched.
bool StepLengthSearch::meets_many(const Sample& sample) const {
  std::uint64_t pairs = 0, blocks = 0;
  for (const NearPipeline& pipeline : pipelines_) pairs += pipeline.counts().boxes.vf + pipeline.counts().boxes.ee;
  trees_.for_each_kind([&](PairKind, const TreeView& a, const TreeView&) {
    blocks += static_cast<std::uint64_t>(sample.count_in(a.leaf_blocks));
  });
  return pairs > kMany * blocks;
}

/// A pair that ends a short step ends it first of all.
void StepLengthSearch::search_short_steps(const Samples& samples) {
  for (const double until : kShortSteps) {
    const double earliest = question_.earliest;
    if (until >= earliest) return;
    question_.earliest = until;
    for (const Sample& sample : samples) search(sample);
    if (question_.earliest < until) return;
    question_.earliest = earliest;
  }
}

void StepLengthSearch::search(const Sample& sample) {
  TAMIS_ASSERT(trees_.are_of(question_.step));
  trees_.for_each_kind([&](PairKind kind, const TreeView& a, const TreeView& b) { search_sample(kind, a, b, sample); });
}

void StepLengthSearch::search_sample(PairKind kind, const TreeView& a, const TreeView& b, const Sample& sample) {
  constexpr int kGrain = 8;
  const tbb::blocked_range<int> all(0, sample.count_in(a.leaf_blocks), kGrain);
  tbb::parallel_for(all, [&](const tbb::blocked_range<int>& part) {
    bool is_known = false;
    NearPipeline& pipeline = pipelines_.local(is_known);
    if (!is_known) pipeline.begin();
    const int first = sample.first + part.begin() * sample.stride, last = sample.first + part.end() * sample.stride;
    pipeline.search(kind, a, b, first, std::min(last, a.leaf_blocks), sample.stride);
  });
}

StepLimit StepLengthSearch::collect(Statistics& statistics, double seconds) {
  StepLimit limit;
  NearCounts counts;
  for (const NearPipeline& pipeline : pipelines_) {
    limit.add(pipeline.limit());
    counts += pipeline.counts();
  }
  statistics.isa = kernels_.isa;
  statistics.stages = {counts.boxes, counts.near};
  statistics.decided_by = counts.decided_by;
  statistics.nodes_visited = counts.nodes_visited;
  const double sum = counts.traverse + counts.filter + counts.solving, share = sum > 0 ? seconds / sum : 0;
  statistics.seconds.traverse = share * counts.traverse;
  statistics.seconds.filter = share * counts.filter;
  statistics.seconds.solve = share * counts.solving;
  return limit;
}

std::uint64_t StepLengthSearch::memory_bytes() const {
  std::uint64_t bytes = shared_.memory_bytes();
  for (const NearPipeline& pipeline : pipelines_) bytes += pipeline.memory_bytes();
  return bytes;
}

}  // namespace tamis
