#include "search/contact_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tamis {
namespace {

/// The smallest float at or after a time of the step.
float float_after(double t) {
  const auto f = static_cast<float>(t);
  return static_cast<double>(f) >= t ? f : std::nextafter(f, std::numeric_limits<float>::infinity());
}

/// All contacts have nothing to learn from an early one.
Samples samples_for(const Query& query, int parts) {
  return query.question == Question::all_contacts ? Samples() : Samples(parts);
}

}  // namespace

void ContactSearch::find(const Query& query, ContactCollector& answer, Statistics& statistics) {
  FeatureTrees& trees = workspace_.trees;
  statistics.nodes_visited = 0;
  const bool is_listed = prepare(query, statistics);
  const std::uint64_t visited_ahead = statistics.nodes_visited;
  const Stopwatch watch;
  streams_.begin(answer);
  if (is_listed) search_lists(answer);
  const bool is_undecided = !is_listed || ahead_.leaves_undecided(answer);
  if (is_listed && is_undecided) trees.refit_or_rebuild(query.step, query.separations, statistics);
  if (is_undecided) search_trees(answer);
  ahead_.end(answer);
  using Counts = SearchCounts;
  if (trees.motion().separations.any())
    streams_.report(statistics, watch.seconds(), {&Counts::boxes, &Counts::slab, &Counts::apart, &Counts::solve});
  else
    streams_.report(statistics, watch.seconds(),
                    {&Counts::boxes, &Counts::slab, &Counts::dnf, &Counts::ncf, &Counts::solve});
  statistics.nodes_visited += visited_ahead;
}

/// Prepares for this query. Returns true if the listed pairs are to be asked first, false if the trees must be
/// searched.
bool ContactSearch::prepare(const Query& query, Statistics& statistics) {
  FeatureTrees& trees = workspace_.trees;
  bool is_listed = ahead_.begin(query);
  if (!is_listed) {
    // Refit to the query even if lists follow: the decision to rebuild must not see the predicted step.
    trees.refit_or_rebuild(query.step, query.separations, statistics);
    if (!ahead_.plan(query)) return false;
    const Stopwatch watch;
    is_listed = list_ahead(query, statistics);
    if (!is_listed) trees.refit_for(query.step, query.separations);
    statistics.seconds.build += watch.seconds();
  }
  if (is_listed) trees.load_vertices(query.step, query.separations, statistics);
  return is_listed;
}

/// Lists what may touch within the next steps. False: that is too much.
bool ContactSearch::list_ahead(const Query& query, Statistics& statistics) {
  FeatureTrees& trees = workspace_.trees;
  const double slack = ahead_.slack();
  const Query predicted{ahead_.predicted_step(), query.separations, query.filter, query.rings, query.is_cancelled};
  const int leaf_blocks = trees.points().leaf_blocks + trees.edges().leaf_blocks;
  CandidateQuery asked{predicted, slack, PairsAhead::most_pairs(leaf_blocks)};
  trees.refit_for(predicted.step, {query.separations.fixed + 2 * slack});
  candidate_streams_.begin(asked);
  for (const Sample& sample : Samples(trees.most_leaf_blocks())) {
    trees.for_each_kind([&](PairKind kind, const TreeView& a, const TreeView& b) {
      if (!asked.bound.is_settled()) candidate_streams_.search(kind, a, b, sample, ahead_.until());
    });
    candidate_streams_.finish([&](CandidateConsumer& consumer) {
      for (std::size_t kind = 0; kind < kPairKinds; ++kind)
        ahead_.take(static_cast<PairKind>(kind), consumer.candidates(static_cast<PairKind>(kind)));
    });
  }
  candidate_streams_.for_each([](CandidateConsumer& consumer) { consumer.release(); });
  statistics.nodes_visited = candidate_streams_.counts().nodes_visited;
  return ahead_.complete(!asked.bound.is_settled());
}

void ContactSearch::search_lists(ContactCollector& answer) {
  constexpr std::size_t kPairsAPart = 1024;
  const auto parts_of = [&](PairKind kind) {
    return static_cast<int>((ahead_.list(kind).size() + kPairsAPart - 1) / kPairsAPart);
  };
  const int most_parts = std::max(parts_of(PairKind::vertex_face), parts_of(PairKind::edge_edge));
  float t_limit = 1;
  for (const Sample& sample : samples_for(answer.query(), most_parts)) {
    workspace_.trees.for_each_kind([&](PairKind kind, const TreeView&, const TreeView&) {
      const PairList& pairs = ahead_.list(kind);
      if (!answer.wants(kind)) return;
      streams_.for_each_part(sample.count_in(parts_of(kind)), [&](PairStream& stream, int begin, int end) {
        for (int i = begin; i < end; ++i) {
          const auto first = static_cast<std::size_t>(sample.first + i * sample.stride) * kPairsAPart;
          stream.search(kind, pairs, first, std::min(first + kPairsAPart, pairs.size()), ahead_.when(), t_limit);
        }
      });
    });
    t_limit = std::min(t_limit, gather(answer));
  }
}

/// REQUIRES: trees of the query's step.
void ContactSearch::search_trees(ContactCollector& answer) {
  const FeatureTrees& trees = workspace_.trees;
  TAMIS_ASSERT(trees.are_of(answer.query().step));
  float t_limit = 1;
  for (const Sample& sample : samples_for(answer.query(), trees.most_leaf_blocks())) {
    trees.for_each_kind([&](PairKind kind, const TreeView& a, const TreeView& b) {
      if (answer.wants(kind)) streams_.search(kind, a, b, sample, t_limit);
    });
    t_limit = std::min(t_limit, gather(answer));
  }
}

/// What the threads have found goes to `answer`, and what it knows to each thread. Returns the time after which nothing
/// is of interest: the step is shortened only between samples, so that the answer knows nothing of threads.
float ContactSearch::gather(ContactCollector& answer) {
  streams_.finish([&](ContactConsumer& consumer) { answer.take(consumer.found()); });
  streams_.for_each([&](ContactConsumer& consumer) { consumer.found().learn(answer); });
  return float_after(answer.bound().latest());
}

}  // namespace tamis
