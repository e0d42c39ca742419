#include "search/candidate_search.hpp"

namespace tamis {

std::int64_t CandidateSearch::most_pairs() const {
  const FeatureTrees& trees = workspace_.trees;
  return kMostPairsABlock * (trees.points().leaf_blocks + trees.edges().leaf_blocks);
}

void CandidateSearch::begin(CandidateQuery& asked) {
  Separations separations = asked.query.separations;
  separations.fixed += 2 * asked.deviation;
  workspace_.trees.refit_for(asked.query.step, separations);
  streams_.begin(asked);
}

void CandidateSearch::search(const CandidateQuery& asked, const Sample& sample, float until) {
  workspace_.trees.for_each_kind([&](PairKind kind, const TreeView& a, const TreeView& b) {
    if (!asked.bound.is_settled()) streams_.search(kind, a, b, sample, until);
  });
}

void CandidateSearch::end(Statistics& statistics) {
  streams_.for_each([](CandidateConsumer& consumer) { consumer.release(); });
  statistics.nodes_visited += streams_.counts().nodes_visited;
}

}  // namespace tamis
