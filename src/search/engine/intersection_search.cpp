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

void IntersectionConsumer::consume(PairKind kind, PairBuffer& pairs) {
  const PairKernels& stages = thread().kernels.along_edges;
  if (!wants(kind)) pairs.count = 0;
  if (query().accepts_intersections)
    leave_out(query().filter, kind, pairs);
  else
    leave_out_groups(query().filter, kind, pairs);
  const PairBuffer& left = filter_crossings(thread(), kind, stages, pairs);
  const LaneDecisions decisions = decide_in_lanes(thread(), stages, 1, left);
  for (const TouchingPair& pair : touching(decisions)) add(left, pair.pair, pair.result);
  decide_left(left, undecided(decisions));
}

void IntersectionConsumer::add(const PairBuffer& pairs, int place, const PairResult& r) {
  if (!r.touches) return;
  const Edge edge = edge_of(pairs, place);
  const Face face = face_of(pairs, place);
  if (query().rings.are_neighbours(edge, face)) return;
  found_.push_back({edge, face, r.toi_lower, r.toi_upper, r.u, r.v});
  if (query().question == Question::is_free) shared_->bound.settle();
}

void IntersectionConsumer::decide_left(const PairBuffer& pairs, std::span<const std::int32_t> places) {
  const auto decided = [&](int place, PrecisionCount& counts) {
    stop_if_cancelled(query());
    const PairPoints points = edge_runner_points(query().step.start, edge_of(pairs, place), face_of(pairs, place));
    return decide({kEdgeRunner, points}, counts);
  };
  decide_singly(
      thread(), places, query().question != Question::is_free, [&](int) { return wants(kEdgeRunner); }, decided,
      [&](int place, const DecidedPair& pair) { add(pairs, place, pair.result); });
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
