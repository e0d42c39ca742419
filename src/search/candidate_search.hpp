// Lists pairs that may touch on a step although vertices deviate from it, for questions to come, and prepares questions
// that such lists may serve.
#pragma once
#include <atomic>
#include <cstdint>
#include <limits>

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
class CandidateConsumer final : public PairStream {
 public:
  static constexpr bool kHoldsPairsBack = true;
  using Shared = CandidateQuery;

  using PairStream::PairStream;

  void begin(CandidateQuery& shared);
  /// Those found since they were last taken.
  PairLists& candidates() { return candidates_; }
  /// Gives back the memory of the lists: they are made once in many queries.
  void release() { candidates_ = {}; }

  bool wants(PairKind) const override { return !shared_->bound.is_settled(); }
  SearchKernel kernel(PairKind kind) const override { return thread().kernels.of(kind).search; }
  void consume(PairKind kind) override;
  std::uint64_t memory_bytes() const { return candidates_.memory_bytes(); }

 private:
  CandidateQuery* shared_ = nullptr;
  PairLists candidates_;
};

class CandidateSearch {
 public:
  /// Keeps a reference.
  explicit CandidateSearch(Workspace& workspace) : workspace_(workspace), streams_(workspace) {}

  /// Adds to `lists`, in no order, all pairs that come within their separations before `until` although vertices
  /// deviate by up to `deviation` from their place. False: there are more than kMostPairsPerBlock times the blocks, or
  /// they cost more than `most_work` (SearchWork::pairs), or a part of them suggests it, and some are missing. Leaves
  /// the trees at this step.
  bool list(const Query& query, double deviation, float until, PairLists& lists, Statistics& statistics,
            std::uint64_t most_work = kAnyWork);
  /// Prepares for a query whose pairs may be in `lists` (`is_listed`). If they are not, plan() says whether lists are
  /// worth making, and make() makes them, or finds that they are too long. True: the lists are to be asked; the
  /// vertices of this step are loaded if they hold any pair. False: the trees, which are of this step, must be
  /// searched.
  template <class Plan, class Make>
  bool prepare(const Query& query, LooksAt looks_at, bool is_listed, const Plan& plan, const Make& make,
               const PairLists& lists, Statistics& statistics) {
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
    if (is_listed && lists.any()) trees.load_vertices(query.step, query.separations, statistics);
    return is_listed;
  }
  std::uint64_t memory_bytes() const { return streams_.memory_bytes(); }

 private:
  static constexpr std::uint64_t kAnyWork = std::numeric_limits<std::uint64_t>::max();
  /// Of each leaf block of sixteen features, on the average.
  static constexpr std::int64_t kMostPairsPerBlock = 256;
  /// Samples are uneven: a part may have so much more of what is listed, and cost so much more.
  static constexpr double kSmallestPart = 1.0 / 64, kPartToTry = 0.25;

  Workspace& workspace_;
  ThreadStreams<CandidateConsumer> streams_;
};

}  // namespace tamis
