#include "engines/tamis/intersection_search.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <tuple>

#include "engines/stopwatch.hpp"

namespace tamis {
namespace {

/// As in the search for contacts.
constexpr double kPoor = 1.5;

/// The groups of a runner's edge and of the face count. The caller's own function is about pairs of other kinds.
Options options_of_runners(const Mesh& mesh, const Options& options) {
  Options result = options;
  result.guarantee = Guarantee::exact;
  result.filter.accepts = nullptr;
  std::vector<Index>& group = result.filter.group_of_vertex;
  if (!group.empty())
    for (const Edge& edge : mesh.edges()) group.push_back(group[static_cast<std::size_t>(edge[0])]);
  return result;
}

}  // namespace

IntersectionSearch::IntersectionSearch(const Mesh& mesh, const Options& options)
    : mesh_(mesh),
      options_(options_of_runners(mesh, options)),
      kernels_(kernels(options.isa)),
      found_(options_),
      pipelines_([this] { return StagePipeline(kernels_, motion_, options_, true); }) {
  for (Index runner = mesh.vertex_count(); const Edge& edge : mesh.edges())
    runners_.push_back({runner++, edge[0], edge[1]});
  for (const Index p : mesh.points())
    if (!mesh.faces_of_vertex(p).empty()) used_.push_back(p);
  for (const auto& runner : runners_) used_.push_back(runner[0]);
  start_.resize(static_cast<std::size_t>(mesh.vertex_count()) + runners_.size());
  end_ = start_;
  runner_tree_.set_runners(runners_);
  faces_.set_features(mesh.faces());
  const PairFilter& filter = options_.filter;
  for (BlockTree* tree : {&runner_tree_, &faces_})
    tree->set_groups(filter.group_of_vertex, filter.groups_may_touch, filter.group_count);
}

void IntersectionSearch::find(const Positions& positions, Intersections wanted, std::vector<Intersection>& found,
                              Statistics& statistics) {
  Stopwatch watch;
  place_runners(positions);
  const Step step{start_, end_};
  motion_.assign(step, used_, {});
  statistics.seconds.bounds = watch.lap();
  update_trees(statistics);
  statistics.seconds.build = watch.lap();
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
  for (const Contact& c : found_.contacts())
    found.push_back({mesh_.edges()[static_cast<std::size_t>(c.vertices[0] - mesh_.vertex_count())],
                     {c.vertices[1], c.vertices[2], c.vertices[3]},
                     c.toi_lower,
                     c.toi_upper,
                     c.u,
                     c.v});
  std::sort(found.begin(), found.end(), [](const Intersection& a, const Intersection& b) {
    return std::tie(a.edge, a.face) < std::tie(b.edge, b.face);
  });
}

void IntersectionSearch::place_runners(const Positions& positions) {
  const auto n = static_cast<std::size_t>(mesh_.vertex_count());
  const auto at = [&](Index v) { return Point{positions[v][0], positions[v][1], positions[v][2]}; };
  for (const Index p : mesh_.points()) start_[static_cast<std::size_t>(p)] = end_[static_cast<std::size_t>(p)] = at(p);
  for (std::size_t e = 0; e < runners_.size(); ++e) {
    start_[n + e] = at(mesh_.edges()[e][0]);
    end_[n + e] = at(mesh_.edges()[e][1]);
  }
}

void IntersectionSearch::update_trees(Statistics& statistics) {
  BlockTree* const trees[] = {&runner_tree_, &faces_};
  const auto area = [&] { return runner_tree_.swept_area() + faces_.swept_area(); };
  if (built_area_ > 0) {
    for (BlockTree* tree : trees) tree->refit(motion_, kernels_.trees);
    if (area() <= kPoor * built_area_) return;
  }
  for (BlockTree* tree : trees) tree->build(motion_, kernels_.trees);
  built_area_ = area();
  statistics.rebuilt = true;
}

void IntersectionSearch::search() {
  constexpr int kGrain = 8;
  const TreeView runners = runner_tree_.view(), faces = faces_.view();
  tbb::parallel_for(tbb::blocked_range<int>(0, runners.leaf_blocks, kGrain), [&](const auto& part) {
    bool is_known = false;
    StagePipeline& pipeline = pipelines_.local(is_known);
    if (!is_known) pipeline.begin(found_);
    pipeline.search(PairKind::vertex_face, runners, faces, {part.begin(), part.end(), 1}, 1, true);
  });
}

std::uint64_t IntersectionSearch::memory_bytes() const {
  std::uint64_t bytes = motion_.memory_bytes() + runner_tree_.memory_bytes() + faces_.memory_bytes() +
                        (start_.capacity() + end_.capacity()) * sizeof(Point) +
                        (3 * runners_.capacity() + used_.capacity()) * sizeof(Index) + found_.memory_bytes();
  for (const StagePipeline& pipeline : pipelines_) bytes += pipeline.memory_bytes();
  return bytes;
}

}  // namespace tamis
