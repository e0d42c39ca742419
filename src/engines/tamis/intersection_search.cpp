#include "engines/tamis/intersection_search.hpp"

#include <algorithm>

#include "engines/stopwatch.hpp"
#include "numerics/assert.hpp"

namespace tamis {
namespace {

/// The caller's own function is about pairs of other kinds.
Options by_groups(Options options) {
  options.filter.accepts = nullptr;
  return options;
}

}  // namespace

IntersectionSearch::IntersectionSearch(const Mesh& mesh, const Options& options, const Kernels& kernels,
                                       FeatureTrees& trees)
    : mesh_(mesh),
      options_(by_groups(options)),
      kernels_(kernels),
      trees_(trees),
      found_(options_),
      pipelines_(kernels_, trees_.motion(), options_, &mesh_) {}

void IntersectionSearch::find(const Positions& positions, Intersections wanted, std::vector<Intersection>& found,
                              Statistics& statistics) {
  const Step step{positions, positions};
  trees_.update(step, {}, statistics);
  Stopwatch watch;
  found_.begin(step, {}, wanted == Intersections::any ? Question::is_free : Question::all_contacts);
  pipelines_.begin(found_);
  search();
  pipelines_.gather(found_);
  pipelines_.counts().report(statistics, watch.lap(), true);
  statistics.isa = kernels_.isa;
  found.clear();
  for (const Contact& contact : found_.contacts()) found.push_back(intersection_of(contact));
  std::sort(found.begin(), found.end(), comes_first);
}

void IntersectionSearch::search() {
  TAMIS_ASSERT(trees_.are_of(found_.step()));
  constexpr std::size_t kGrain = 8;
  constexpr PairKind kRunner = PairKind::vertex_face;
  const TreeView edges = trees_.edges(), faces = trees_.faces();
  pipelines_.for_each_part(found_, kRunner, edges.leaf_blocks, kGrain,
                           [&](StagePipeline& pipeline, int first, int last) {
                             pipeline.search(kRunner, edges, faces, {first, last, 1}, 1);
                           });
}

Intersection IntersectionSearch::intersection_of(const Contact& contact) const {
  const auto& [runner, f0, f1, f2] = contact.vertices;
  TAMIS_ASSERT(0 <= runner && static_cast<std::size_t>(runner) < mesh_.edges().size());
  const Edge& edge = mesh_.edges()[static_cast<std::size_t>(runner)];
  return {edge, {f0, f1, f2}, contact.toi_lower, contact.toi_upper, contact.u, contact.v};
}

std::uint64_t IntersectionSearch::memory_bytes() const { return found_.memory_bytes() + pipelines_.memory_bytes(); }

}  // namespace tamis
