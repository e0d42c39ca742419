// Lists pairs that may touch on a step although vertices deviate from it, for questions to come; and prepares questions
// that lists may serve.
#pragma once
#include "search/candidate_consumer.hpp"
#include "search/thread_streams.hpp"

namespace tamis {

class CandidateSearch {
 public:
  /// Keeps a reference.
  explicit CandidateSearch(Workspace& workspace) : workspace_(workspace), streams_(workspace) {}

  /// All that are within the separations before `until`, of vertices up to `deviation` beside their place: take(kind,
  /// list) gets them part by part, in no order. False: there are more than most_pairs(), or it looks so after a part of
  /// them, and some are missing. Leaves the trees at this step.
  template <class Take>
  bool list(const Query& query, double deviation, float until, const Take& take, Statistics& statistics) {
    const std::int64_t most = most_pairs();
    CandidateQuery asked{query, deviation, most};
    begin(asked);
    double part = 0;
    for (const Sample& sample : Samples(workspace_.trees.most_leaf_blocks())) {
      search(asked, sample, until);
      streams_.finish([&](CandidateConsumer& consumer) {
        for (std::size_t kind = 0; kind < kPairKinds; ++kind)
          take(static_cast<PairKind>(kind), consumer.candidates(static_cast<PairKind>(kind)));
      });
      part += 1.0 / sample.stride;
      if (static_cast<double>(most - asked.left) > (part + kSmallestPart) * static_cast<double>(most))
        asked.bound.settle();
    }
    end(statistics);
    return !asked.bound.is_settled();
  }
  /// Prepares the trees for a query of which lists may hold the pairs (`is_listed`): if they do not, plan() says
  /// whether they should, and make() makes them, or gives up. True: the lists are to be asked, with the vertices of
  /// this step if has_pairs(); false: the trees must be searched.
  template <class Plan, class Make, class HasPairs>
  bool prepare(const Query& query, LooksAt looks_at, bool is_listed, const Plan& plan, const Make& make,
               const HasPairs& has_pairs, Statistics& statistics) {
    FeatureTrees& trees = workspace_.trees;
    if (!is_listed) {
      // Refit to the query even if lists follow: the decision to rebuild must not see the step that they are for.
      trees.refit_or_rebuild(query.step, query.separations, looks_at, statistics);
      if (!plan()) return false;
      const Stopwatch watch;
      is_listed = make();
      if (!is_listed) trees.refit_for(query.step, query.separations);
      statistics.seconds.build += watch.seconds();
    }
    if (is_listed && has_pairs()) trees.load_vertices(query.step, query.separations, statistics);
    return is_listed;
  }
  std::uint64_t memory_bytes() const { return streams_.memory_bytes(); }

 private:
  /// Of each leaf block of sixteen features, on the average.
  static constexpr std::int64_t kMostPairsABlock = 256;
  static constexpr double kSmallestPart = 1.0 / 64;  ///< samples are uneven: a part may have as many more

  std::int64_t most_pairs() const;
  void begin(CandidateQuery& asked);
  void search(const CandidateQuery& asked, const Sample& sample, float until);
  void end(Statistics& statistics);

  Workspace& workspace_;
  ThreadStreams<CandidateConsumer> streams_;
};

}  // namespace tamis
