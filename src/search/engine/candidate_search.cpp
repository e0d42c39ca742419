#include "search/engine/candidate_search.hpp"

#include "search/engine/pair_buffer.hpp"

namespace tamis {

void CandidateConsumer::begin(CandidateQuery& shared) {
  PairStream::begin(shared.query);
  shared_ = &shared;
  release();  // an exception may have left pairs of another query
}

/// The slab clip, then axes that turn with the pair. The trees' separation holds twice the deviation.
void CandidateConsumer::consume(PairKind kind, PairBuffer& pairs) {
  PairBuffer &clipped = thread().clipped, &filtered = thread().filtered;
  const MotionView motion = thread().motion.view();
  const PairKernels& stages = thread().kernels.of(kind);
  leave_out_groups(query().filter, kind, pairs);
  stages.slab(motion, pairs, clipped);
  stages.cull_apart(motion, clipped, filtered);
  SearchCounts& counts = thread().counts;
  of(counts.boxes, kind) += static_cast<std::uint64_t>(pairs.count);
  of(counts.apart, kind) += static_cast<std::uint64_t>(clipped.count);
  candidates_[kind].add(filtered);
  if (shared_->pairs_left.fetch_sub(filtered.count, std::memory_order_relaxed) < filtered.count)
    shared_->bound.settle();
}

bool CandidateSearch::list(const Query& query, const Listing& listing, PairLists& lists, Statistics& statistics) {
  FeatureTrees& trees = workspace_.trees;
  const std::int64_t most = kMostPairsPerBlock * trees.leaf_blocks();
  const Query listed{listing.step, listing.separations, query.filter, query.rings, query.is_cancelled};
  CandidateQuery asked{listed, most};
  Separations separations = listing.separations;
  separations.fixed += 2 * listing.deviation;
  trees.refit_for(listing.step, separations, nullptr);
  streams_.begin(asked);
  double part = 0;
  for (const Sample& sample : Samples(trees.most_leaf_blocks())) {
    streams_.search_trees(sample, listing.until);
    streams_.for_each([&](CandidateConsumer& consumer) { lists.take(consumer.candidates()); });
    part += 1.0 / sample.stride;
    if (static_cast<double>(most - asked.pairs_left) > (part + kSmallestPart) * static_cast<double>(most))
      asked.bound.settle();
  }
  streams_.for_each([](CandidateConsumer& consumer) { consumer.release(); });
  statistics.nodes_visited += streams_.counts().nodes_visited;
  return !asked.bound.is_settled();
}

bool CandidateSearch::prepare(const Query& query, LooksAt looks_at, bool is_listed, KeptLists& kept,
                              Statistics& statistics) {
  FeatureTrees& trees = workspace_.trees;
  if (!is_listed) {
    // Refits to the query even if lists follow. The decision to rebuild must not see the step that they are for.
    trees.refit_or_rebuild(query.step, query.separations, query.frame, looks_at, statistics);
    const std::optional<Listing> listing = kept.plan(query);
    if (!listing) return false;
    const Stopwatch watch;
    is_listed = list(query, *listing, kept.lists(), statistics);
    kept.end_listing(is_listed);
    if (!is_listed) trees.refit_for(query.step, query.separations, query.frame);
    statistics.seconds.build += watch.seconds();
  }
  if (is_listed && kept.lists().any()) trees.load_vertices(query.step, query.separations, query.frame, statistics);
  return is_listed;
}

}  // namespace tamis
