#include "engines/tamis/step_length.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>

namespace tamis {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

}  // namespace

StepLengthSearch::StepLengthSearch(const Mesh& mesh, const Options& options)
    : options_(options),
      kernels_(kernels(options.isa)),
      trees_(mesh, kernels_),
      pipelines_([this] { return NearPipeline(kernels_, trees_.motion(), options_, question_); }) {}

SafeStep StepLengthSearch::find(const Step& step, const Separations& separations, double fraction,
                                Statistics& statistics) {
  question_.step = step;
  question_.fraction = fraction;
  question_.earliest = 1;
  trees_.update(step, separations, statistics);
  trees_.count_drifts(step, step.start);
  const auto start = Clock::now();
  for (NearPipeline& pipeline : pipelines_) pipeline.begin();
  for (const Sample& sample : kSamples)
    trees_.for_each_kind(
        [&](PairKind kind, const TreeView& a, const TreeView& b) { search_sample(kind, a, b, sample); });
  return collect(statistics, seconds_since(start)).answer(step, fraction, separations);
}

void StepLengthSearch::search_sample(PairKind kind, const TreeView& a, const TreeView& b, const Sample& sample) {
  constexpr int kGrain = 8;
  const tbb::blocked_range<int> all(0, count_in(sample, a.leaf_blocks), kGrain);
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
  std::uint64_t bytes = trees_.memory_bytes();
  for (const NearPipeline& pipeline : pipelines_) bytes += pipeline.memory_bytes();
  return bytes;
}

}  // namespace tamis
