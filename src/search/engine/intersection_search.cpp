#include "search/engine/intersection_search.hpp"

#include "pair/narrow/decide.hpp"
#include "search/engine/pair_buffer.hpp"
#include "search/engine/stages.hpp"
#include "search/query/cancellation.hpp"
#include "search/query/engine.hpp"

namespace tamis {
namespace {

/// The pair of a vertex that runs along the edge, from its first vertex, and the face.
constexpr PairKind kEdgeRunner = PairKind::vertex_face;

Edge edge_of(const PairBuffer& pairs, int i) { return {pairs.corner[0][i], pairs.corner[4][i]}; }
Face face_of(const PairBuffer& pairs, int i) { return {pairs.corner[1][i], pairs.corner[2][i], pairs.corner[3][i]}; }

}  // namespace

void IntersectionConsumer::begin(IntersectionQuery& shared) {
  PairStream::begin(shared.query);
  shared_ = &shared;
  found_.clear();
}

/// Groups alone leave out a detector's intersections, as filter.accepts takes pairs of a PairKind; with
/// Query::depends_on_pair_alone `accepts` is asked, too.
void IntersectionConsumer::consume(PairKind kind) {
  const bool depends_on_pair_alone = query().depends_on_pair_alone;
  if (!wants(kind)) thread().boxes.count = 0;
  if (depends_on_pair_alone)
    leave_out(query().filter, kind, thread().boxes);
  else
    leave_out_groups(query().filter, kind, thread().boxes);
  const int count = decide_crossings(thread(), kind, thread().kernels.along_edges);
  decide_left(add_solved(thread(), count, [&](int pair, const PairResult& result) {
    if (depends_on_pair_alone)
      thread().undecided.push_back(pair);
    else
      add(pair, result);
  }));
}

void IntersectionConsumer::add(int pair, const PairResult& r) {
  if (!r.touches) return;
  const PairBuffer& pairs = thread().filtered;
  const Edge edge = edge_of(pairs, pair);
  const Face face = face_of(pairs, pair);
  if (query().rings.are_neighbours(edge, face)) return;
  found_.push_back({edge, face, r.toi_lower, r.toi_upper, r.u, r.v});
  if (query().question == Question::is_free) shared_->bound.settle();
}

void IntersectionConsumer::decide_left(std::span<const int> pairs) {
  const auto decided = [&](int pair, PrecisionCount& counts) {
    stop_if_cancelled(query());
    const PairBuffer& filtered = thread().filtered;
    const PairPoints points = edge_runner_points(query().step.start, edge_of(filtered, pair), face_of(filtered, pair));
    return decide({kEdgeRunner, points}, counts);
  };
  decide_singly(
      thread(), pairs, query().question != Question::is_free, [&](int) { return wants(kEdgeRunner); }, decided,
      [&](int pair, const DecidedPair& decided_pair) { add(pair, decided_pair.result); });
}

void IntersectionSearch::find(const Query& query, std::vector<Intersection>& found, Statistics& statistics) {
  const FeatureTrees& trees = workspace_.trees;
  workspace_.trees.refit_or_rebuild(query.step, {}, nullptr, LooksAt::start, statistics);
  const Stopwatch watch;
  IntersectionQuery asked{query};
  streams_.begin(asked);
  streams_.search(kEdgeRunner, trees.edges(), trees.faces());
  found.clear();
  streams_.for_each([&](IntersectionConsumer& consumer) {
    found.insert(found.end(), consumer.found().begin(), consumer.found().end());
  });
  using Counts = SearchCounts;
  streams_.report(statistics, watch.seconds(),
                  {&Counts::boxes, &Counts::slab, &Counts::dnf, &Counts::ncf, &Counts::solve});
  sort_in_parts(found, comes_first, [&] { stop_if_cancelled(query); });
}

}  // namespace tamis
