// Lists pairs that may touch on a step although vertices deviate from it, for questions to come, and prepares questions
// that such lists may serve.
#pragma once
#include <array>
#include <atomic>

#include "query/bound.hpp"
#include "search/thread_streams.hpp"

namespace tamis {

/// What the threads share.
struct CandidateQuery {
  const Query& query;
  double deviation;                ///< how far vertices may be from where the step has them, along any axis
  std::atomic<std::int64_t> left;  ///< how many more may be listed
  Bound bound = {};                ///< settled: there are too many
};

/// Lists pairs that may touch although vertices deviate from the step, and decides none.
class CandidateConsumer final : public PairConsumer {
 public:
  static constexpr bool kHoldsPairsBack = true;
  using Shared = CandidateQuery;

  using PairConsumer::PairConsumer;

  void begin(CandidateQuery& shared);
  /// Those found since they were last taken.
  PairList& candidates(PairKind kind) { return candidates_[static_cast<std::size_t>(kind)]; }
  /// Gives back the memory of the lists: they are made once in many queries.
  void release() { candidates_ = {}; }

  bool wants(PairKind) const override { return !shared_->bound.is_settled(); }
  SearchKernel kernel(PairKind kind) const override { return thread().kernels.of(kind).search; }
  void consume(PairKind kind) override;
  std::uint64_t memory_bytes() const;

 private:
  CandidateQuery* shared_ = nullptr;
  std::array<PairList, kPairKinds> candidates_;
};

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
  /// Prepares for a query whose pairs may be in lists (`is_listed`). If they are not, plan() says whether lists are
  /// worth making, and make() makes them, or finds that they are too long. True: the lists are to be asked; the
  /// vertices of this step are loaded if has_pairs(). False: the trees, which are of this step, must be searched.
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
