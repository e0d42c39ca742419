#include "engines/tamis/intersection_search.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "engines/stopwatch.hpp"

namespace tamis {
namespace {

/// The caller's own function is about pairs of other kinds.
Options exact_by_groups(Options options) {
  options.guarantee = Guarantee::exact;
  options.filter.accepts = nullptr;
  return options;
}

}  // namespace

IntersectionSearch::IntersectionSearch(const Mesh& mesh, const Options& options, const Kernels& kernels,
                                       FeatureTrees& trees)
    : mesh_(mesh),
      options_(exact_by_groups(options)),
      kernels_(kernels),
      trees_(trees),
      found_(options_),
      pipelines_([this] { return StagePipeline(kernels_, trees_.motion(), options_, &mesh_); }) {}

void IntersectionSearch::find(const Positions& positions, Intersections wanted, std::vector<Intersection>& found,
                              Statistics& statistics) {
  const Step step{positions, positions};
  trees_.update(step, {}, statistics);
  Stopwatch watch;
  found_.begin(step, {}, wanted == Intersections::any ? Question::is_free : Question::all_contacts);
  for (StagePipeline& pipeline : pipelines_) pipeline.begin(found_);
  search();
  PipelineCounts counts;
  for (StagePipeline& pipeline : pipelines_) {
    pipeline.finish();
    found_.take(pipeline.found());
    counts += pipeline.counts();
  }
  counts.report(statistics, watch.lap(), true);
  statistics.isa = kernels_.isa;
  found.clear();
  for (const Contact& contact : found_.contacts()) found.push_back(intersection_of(contact));
  std::sort(found.begin(), found.end(), comes_first);
}

void IntersectionSearch::search() {
  constexpr int kGrain = 8;
  const TreeView edges = trees_.edges(), faces = trees_.faces();
  tbb::parallel_for(tbb::blocked_range<int>(0, edges.leaf_blocks, kGrain), [&](const auto& part) {
    bool is_known = false;
    StagePipeline& pipeline = pipelines_.local(is_known);
    if (!is_known) pipeline.begin(found_);
    pipeline.search(PairKind::vertex_face, edges, faces, {part.begin(), part.end(), 1}, 1, true);
  });
}

Intersection IntersectionSearch::intersection_of(const Contact& contact) const {
  const auto& [runner, f0, f1, f2] = contact.vertices;
  const Edge& edge = mesh_.edges()[static_cast<std::size_t>(runner - mesh_.vertex_count())];
  return {edge, {f0, f1, f2}, contact.toi_lower, contact.toi_upper, contact.u, contact.v};
}

std::uint64_t IntersectionSearch::memory_bytes() const {
  std::uint64_t bytes = found_.memory_bytes();
  for (const StagePipeline& pipeline : pipelines_) bytes += pipeline.memory_bytes();
  return bytes;
}

}  // namespace tamis
