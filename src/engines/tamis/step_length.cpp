#include "engines/tamis/step_length.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>

namespace tamis {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// As in the search for contacts: refitting goes on until the leaf blocks' area exceeds by this factor what it was when
/// they were built.
constexpr double kPoor = 1.5;

}  // namespace

StepLengthSearch::StepLengthSearch(const Mesh& mesh, const Options& options)
    : mesh_(mesh),
      options_(options),
      kernels_(kernels(options.isa)),
      pipelines_([this] { return NearPipeline(kernels_, motion_, options_, question_); }) {
  points_.set_features(mesh.points());
  edges_.set_features(mesh.edges());
  faces_.set_features(mesh.faces());
}

SafeStep StepLengthSearch::find(const Step& step, const Separations& separations, double fraction,
                                Statistics& statistics) {
  auto start = Clock::now();
  question_.step = step;
  question_.fraction = fraction;
  question_.earliest = 1;
  motion_.assign(step, mesh_.points(), separations, SecondHalf::displacement);
  statistics.seconds.bounds = seconds_since(start);
  start = Clock::now();
  update_trees(statistics);
  statistics.seconds.build = seconds_since(start);
  start = Clock::now();
  for (NearPipeline& pipeline : pipelines_) pipeline.begin();
  for (const Sample& sample : kSamples) {
    search_sample(PairKind::vertex_face, points_.view(), faces_.view(), sample);
    search_sample(PairKind::edge_edge, edges_.view(), edges_.view(), sample);
  }
  return collect(statistics, seconds_since(start)).answer(step, fraction, separations);
}

void StepLengthSearch::update_trees(Statistics& statistics) {
  BlockTree* const trees[] = {&points_, &edges_, &faces_};
  const auto area = [&] { return points_.start_area() + edges_.start_area() + faces_.start_area(); };
  if (built_area_ > 0) {
    for (BlockTree* tree : trees) tree->refit(motion_, kernels_.trees);
    if (area() <= kPoor * built_area_) return;
  }
  for (BlockTree* tree : trees) tree->build(motion_, kernels_.trees);
  built_area_ = area();
  statistics.rebuilt = true;
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
  std::uint64_t bytes = motion_.memory_bytes() + points_.memory_bytes() + edges_.memory_bytes() + faces_.memory_bytes();
  for (const NearPipeline& pipeline : pipelines_) bytes += pipeline.memory_bytes();
  return bytes;
}

}  // namespace tamis
